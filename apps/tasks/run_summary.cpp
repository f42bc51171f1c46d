#include "apps/tasks/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/output/file.hpp"
#include "mbs/solids/solid_model.hpp"

namespace liesl {

std::string status_word(SolveStatus status) {
  return status == SolveStatus::Converged ? "done" : to_string(status);
}

void describe(output::RunSummary& summary, const Scene& scene, const ChosenSpace& space) {
  summary.name = scene.mechanism.name;
  summary.space = space.name;
  summary.space_reason = space.reason;
  summary.input_sha256 = output::sha256(scene.input);
  summary.warnings = scene.warnings;
  for (const NamedInput& file : scene.files) summary.more["files"][file.path] = file.sha256;
}

void describe(output::RunSummary& summary, const PenaltyReport& p, ConstraintForm form) {
  if (!p.used) return;
  auto& json = summary.more["penalty"];
  json = {{"constraints", to_string(form)},
          {"weight", p.displacement},
          {"weight_rotation", p.rotation},
          {"joint", p.joint},
          {"largest_opening", p.opening},
          {"largest_deformation", nullptr},
          {"share", p.share},
          {"augmentations", p.augmentations},
          {"most_augmentations", p.most_augmentations}};
  if (!p.rigid) json["largest_deformation"] = p.deformation;
}

namespace {

/// A converged run that cannot be relied on. @returns the status, that of the summary too
SolveStatus doubt(output::RunSummary& summary, const std::string& why, SolveStatus status) {
  if (status != SolveStatus::Converged) return status;
  summary.status = status_word(SolveStatus::Inaccurate);
  summary.reason = why;
  return SolveStatus::Inaccurate;
}

SolveStatus describe_energy(output::RunSummary& summary, const output::Results& results,
                            SolveStatus status) {
  constexpr double kLost = 0.02, kTooMuch = 0.1;
  constexpr double kNothing = 1e-16;  // J: at rest
  // Of the potential, and of speeds squared of one size of the mechanism in the whole time: what
  // does not move trembles by it.
  constexpr double kRoundOff = 1e-12;
  const output::Energies& e = results.energies;
  if (e.dissipated.empty() ||
      e.turned_over <= kNothing + kRoundOff * (e.largest_potential + e.crossing))
    return status;
  const double share = std::abs(e.lost) / e.turned_over;
  if (share <= kLost) return status;
  const std::string text = fmt::format(
      "the time integration {} {:.3g} J of energy, {:.1f} % of the largest kinetic and elastic "
      "energy: compare with a smaller simulation.step",
      e.lost > 0 ? "lost" : "made", std::abs(e.lost), 100 * share);
  summary.warnings.push_back(text);
  return share > kTooMuch ? doubt(summary, text, status) : status;
}

bool has_chains(const Mechanism& mechanism) {
  return std::ranges::any_of(mechanism.bodies, [&](const BodySpec& body) {
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    return beam && model_of(*beam, mechanism.formalism) == BeamModel::Segments;
  });
}

/// A body whose law is for small strains; E = 0: another.
struct SmallStrain {
  std::string name, law, remedy;
  double E = 0;  ///< Pa
};
SmallStrain small_strain(const BodySpec& body) {
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  if (beam && beam->segment.potential == AxialPotential::NeoHookean) return {};
  if (beam)
    return {"the beam '" + body.name + "'", "its material is linear",
            "check the units of E, of its section and of its loads", beam->material.E};
  const auto* solid = std::get_if<SolidSpec>(&body.kind);
  if (!solid || solid->as != SolidMotion::Continuum || solid->law != SolidLaw::StVenantKirchhoff)
    return {};
  return {"the part '" + body.name + "'",
          "the law of St. Venant and Kirchhoff is for small strains",
          "law = \"neo_hookean\", or check the units of E and of its loads",
          solid->model->material().E};
}

SolveStatus describe_strains(output::RunSummary& summary, const Mechanism& mechanism,
                             const output::Results& results, SolveStatus status) {
  constexpr double kLinear = 0.05, kTorn = 0.5;
  for (std::size_t b = 0; b < std::min(mechanism.bodies.size(), results.bodies.size()); ++b) {
    const SmallStrain of = small_strain(mechanism.bodies[b]);
    const double share = of.E > 0 ? results.bodies[b].largest_stress / of.E : 0;
    if (!(share > kLinear)) continue;
    const std::string text =
        fmt::format("the stress in {} reaches {:.2g} of its modulus E, but {}: {}", of.name, share,
                    of.law, of.remedy);
    summary.warnings.push_back(text);
    if (share > kTorn) status = doubt(summary, text, status);
  }
  return status;
}

}  // namespace

void describe(output::RunSummary& summary, const Report& report, const InitialState& start,
              const Mechanism& mechanism, SimulationType type) {
  summary.status = status_word(report.status);
  summary.reason = report.reason;
  if (report.reason.empty())
    summary.reason = type == SimulationType::Static ? "in equilibrium under the whole load"
                                                    : "the simulation reached its end";
  if (type == SimulationType::Static && report.status == SolveStatus::NotConverged &&
      summary.space == "spatial" && has_chains(mechanism))
    summary.reason +=
        "; or a chain of segments would be twisted, which it does not resist: formalism se3 tells";
  summary.steps = static_cast<int>(report.steps);
  summary.newton_iterations = report.newton_iterations;
  for (size_t b = 0; b < report.factorizations.size(); ++b)
    summary.factorizations.emplace_back(mechanism.bodies[b].name, report.factorizations[b]);
  summary.stepping_s = report.stepping_s;
  summary.warnings.insert(summary.warnings.end(), report.warnings.begin(), report.warnings.end());
  summary.more["tangent_refreshes"] = report.tangent_refreshes;
  summary.more["rejected_steps"] = report.rejected_steps;
  summary.more["refused_steps"] = report.refused_steps;
  summary.more["smallest_step"] = report.smallest_step;
  summary.more["max_constraint_residual"] = report.max_constraint_residual;
  describe(summary, report.penalty, mechanism.penalty.form);
  summary.more["start"] = {{"moved", start.moved}, {"velocity_change", start.velocity_change}};
}

void describe_responses(output::RunSummary& summary, const output::Results& results) {
  for (const auto& r : results.responses)
    summary.responses.push_back(output::response_figure(r, results.times));
}

SolveStatus describe_doubts(output::RunSummary& summary, const Scene& scene,
                            const Mechanism& mechanism, const output::Results& results,
                            SolveStatus status) {
  const SolveStatus end =
      describe_energy(summary, results, describe_strains(summary, mechanism, results, status));
  if (end != status && !scene.unfollowed.empty()) summary.reason = scene.unfollowed.front();
  return end;
}

template <FrameGroup G>
SolveStatus describe_ranges(output::RunSummary& summary, const SimulationOptions& o,
                            const PartRanges<G>& ranges, SolveStatus status) {
  for (const RangeNote& note : ranges.notes()) {
    summary.warnings.push_back(note.text);
    if (!note.beyond) continue;
    status = doubt(summary, note.text, status);
    if (status == SolveStatus::NotConverged)  // a model that does not hold may not converge
      summary.reason += "; before that " + note.text;
  }
  if (o.type == SimulationType::Dynamic && o.space == SpaceChoice::Auto)
    for (const std::string& note : ranges.leaving_plane()) summary.warnings.push_back(note);
  return status;
}

template SolveStatus describe_ranges(output::RunSummary&, const SimulationOptions&,
                                     const PartRanges<SE2>&, SolveStatus);
template SolveStatus describe_ranges(output::RunSummary&, const SimulationOptions&,
                                     const PartRanges<SE3>&, SolveStatus);

}  // namespace liesl
