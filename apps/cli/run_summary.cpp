#include "apps/cli/run_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>

#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {

Progress watch(output::Progress& line) {
  return [&line](double t) {
    line.update(t);
    return output::interrupted() == 0;
  };
}

std::string status_word(SolveStatus status) {
  return status == SolveStatus::Converged ? "done" : to_string(status);
}

void describe(output::RunSummary& summary, const Scene& scene, const ChosenSpace& space) {
  summary.name = scene.mechanism.name;
  summary.space = space.name;
  summary.space_reason = space.reason;
  summary.input_sha256 = output::sha256(scene.input);
  summary.warnings = scene.warnings;
}

void describe(output::RunSummary& summary, const Report& report, const InitialState& start,
              const Mechanism& mechanism) {
  summary.status = status_word(report.status);
  summary.reason = report.reason.empty() ? "the simulation reached its end" : report.reason;
  summary.steps = static_cast<int>(report.steps);
  summary.newton_iterations = report.newton_iterations;
  for (size_t b = 0; b < report.factorizations.size(); ++b)
    summary.factorizations.emplace_back(mechanism.bodies[b].name, report.factorizations[b]);
  summary.stepping_s = report.stepping_s;
  summary.warnings.insert(summary.warnings.end(), report.warnings.begin(), report.warnings.end());
  summary.more["tangent_refreshes"] = report.tangent_refreshes;
  summary.more["rejected_steps"] = report.rejected_steps;
  summary.more["smallest_step"] = report.smallest_step;
  summary.more["max_constraint_residual"] = report.max_constraint_residual;
  summary.more["start"] = {{"moved", start.moved}, {"velocity_change", start.velocity_change}};
}

namespace {

constexpr int kCompared = 12;  // frequencies at most
constexpr double kNearEnough = 0.01;
constexpr int kInstants = 200;  // at which the rate of a drive is looked at

/// Turns a second of the fastest drive of an angle.
double drive_frequency(const Mechanism& m, double duration) {
  double fastest = 0;
  for (const DriveSpec& d : m.drives)
    if (m.joints[static_cast<size_t>(d.joint)].type == JointType::Revolute)
      for (int i = 0; i <= kInstants; ++i)
        fastest = std::max(fastest, std::abs(d.motion.rate(duration * i / kInstants)));
  return fastest / (2 * std::numbers::pi);
}

/// The lowest frequency that is off, or the highest compared: what all are right below.
double right_up_to(const Eigen::VectorXd& full, const Eigen::VectorXd& reduced) {
  for (Eigen::Index i = 0; i < full.size(); ++i)
    if (i >= reduced.size() || std::abs(reduced[i] / full[i] - 1) > kNearEnough) return full[i];
  return full.size() > 0 ? full[full.size() - 1] : 0;
}

}  // namespace

template <FrameGroup G>
void describe_parts(output::RunSummary& summary, const Mechanism& mechanism, const Model<G>& model,
                    double duration) {
  for (size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto* body = dynamic_cast<const SolidBody<G>*>(model.bodies[b].get());
    if (!body) continue;
    const auto& spec = std::get<SolidSpec>(mechanism.bodies[b].kind);
    SolidModel solid = solid_model(spec);
    const Eigen::VectorXd reduced = body->free_frequencies(kCompared),
                          full = free_frequencies(solid, solid_fractions(spec).value,
                                                  static_cast<int>(reduced.size()));
    const double reach = right_up_to(full, reduced), drive = drive_frequency(mechanism, duration);
    summary.more["parts"][body->name] = {
        {"cells", spec.mesh.cell_count()},
        {"unknowns", body->basis().cols()},
        {"mass", body->total_mass()},
        {"free_hz", std::vector<double>(full.begin(), full.end())},
        {"reduced_hz", std::vector<double>(reduced.begin(), reduced.end())},
        {"right_up_to_hz", reach},
        {"drive_hz", drive}};
    if (reach < 2 * drive)
      summary.warnings.push_back(
          fmt::format("the modes of '{}' are right up to {:.4g} Hz only, twice the drive's "
                      "frequency is {:.4g} Hz: more bodies.{}.solid.modes",
                      body->name, reach, 2 * drive, body->name));
  }
}

template void describe_parts(output::RunSummary&, const Mechanism&, const Model<SE2>&, double);
template void describe_parts(output::RunSummary&, const Mechanism&, const Model<SE3>&, double);

void describe_responses(output::RunSummary& summary, const output::Results& results) {
  for (const auto& r : results.responses)
    summary.responses.push_back(output::response_figure(r, results.times));
}

void describe_energy(output::RunSummary& summary, const output::Results& results) {
  constexpr double kLost = 0.02;
  constexpr double kNothing = 1e-20;   // J: at rest
  constexpr double kRoundOff = 1e-12;  // of the potential: what does not move trembles by it
  const auto& e = results.energies;
  if (e.dissipated.empty()) return;
  double turned_over = 0, lost = 0, potential = 0;
  for (size_t i = 0; i < e.dissipated.size(); ++i) {
    turned_over = std::max(turned_over, e.kinetic[i] + e.elastic[i]);
    potential = std::max(potential, std::abs(e.potential[i]));
    if (std::abs(e.dissipated[i]) > std::abs(lost)) lost = e.dissipated[i];
  }
  if (std::abs(lost) > kLost * turned_over && turned_over > kNothing + kRoundOff * potential)
    summary.warnings.push_back(fmt::format(
        "the time integration {} {:.3g} J of energy, {:.1f} % of the largest kinetic and "
        "elastic energy: compare with a smaller simulation.step",
        lost > 0 ? "lost" : "made", std::abs(lost), 100 * std::abs(lost) / turned_over));
}

void print_figures(const output::RunSummary& summary, const std::string& folder, bool quiet) {
  if (quiet) return;
  fmt::print("{}: {} ({}), {} steps, {} corrections, {:.3g} s stepping, {}\n", summary.name,
             summary.status, summary.reason, summary.steps, summary.newton_iterations,
             summary.stepping_s, summary.space);
  for (const auto& r : summary.responses)
    if (!r.final.empty())
      fmt::print("  {:<16} largest {:.6g} {} at {:.6g}, at the end {}\n", r.name, r.max_abs, r.unit,
                 r.at_time,
                 r.final.size() == 1 ? fmt::format("{:.6g}", r.final[0])
                                     : fmt::format("({:.6g})", fmt::join(r.final, ", ")));
  for (const auto& w : summary.warnings) fmt::print("  note: {}\n", w);
  if (!folder.empty()) fmt::print("results in {}; next: liesl plot {}\n", folder, folder);
}

}  // namespace liesl
