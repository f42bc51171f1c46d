#include "apps/tasks/compare.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "apps/scene/space.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

ResponseSpec response_named(const Scene& scene, const std::string& name) {
  for (const ResponseSpec& response : scene.responses)
    if (response.name == name) return response;
  throw std::logic_error("no response " + name);  // load_comparison has looked
}

Measured measure_scene(const Comparison& comparison, const Scene& scene, int repeats,
                       double time_limit) {
  const MeasureOptions options{response_named(scene, comparison.response), repeats, time_limit};
  return std::visit([&](const auto& space) { return measure(scene, space, options); },
                    choose_space(scene).space);
}

[[noreturn]] void refuse(const Comparison& comparison, std::size_t row, int side,
                         const std::string& reason) {
  const ReferenceSpec& spec = *comparison.reference;
  const std::vector<std::string> physics = comparison.physics(row);
  throw InputError(
      {{spec.place.file, spec.place.line, spec.place.column,
        fmt::format("the reference of {}{} failed: {}",
                    spec.formalisms[static_cast<std::size_t>(side)],
                    physics.empty() ? "" : fmt::format(" ({})", fmt::join(physics, ", ")), reason),
        "a reference that reaches its end",
        "use a smaller reference.step, another formalism, or no [reference]"}});
}

}  // namespace

std::string response_unit(const Comparison& comparison, const ReadScene& read) {
  if (comparison.rows.optimize) return "kg";
  const Scene scene = read(comparison.rows.changes(0));
  return unit(response_named(scene, comparison.response), scene.mechanism);
}

Measured measure_row(const Comparison& comparison, const Scene& scene) {
  return measure_scene(comparison, scene, comparison.repeats, comparison.time_limit);
}

output::Series reference_side(const Comparison& comparison, std::size_t row, int side,
                              const ReadScene& read) {
  std::vector<double> weights;
  std::vector<output::Series> series;
  for (const ReferenceRun& run : comparison.reference_runs(row, side)) {
    Measured m =
        measure_scene(comparison, read(run.changes), 0, std::numeric_limits<double>::infinity());
    if (m.ending == Ending::Stopped) refuse(comparison, row, side, m.reason);
    weights.push_back(run.weight);
    series.push_back(std::move(m.series));
  }
  return combine(weights, series);
}

Reference reference_of(const output::Series& a, const output::Series& b, output::Norm norm) {
  return {output::combine({0.5, 0.5}, {a, b}), distance(a, b, norm)};
}

}  // namespace liesl
