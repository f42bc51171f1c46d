#include "apps/tasks/run_summary.hpp"

#include <fmt/format.h>

#include "apps/output/file.hpp"

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

}  // namespace liesl
