#include "apps/cli/result_files.hpp"

#include "apps/output/write_results.hpp"

#ifdef LIESL_OPTIM
#include <fmt/format.h>

#include "apps/cli/part_files.hpp"
#include "apps/output/file.hpp"
#include "apps/tasks/final_scene.hpp"
#endif

namespace liesl {

void write_run(const std::filesystem::path& folder, const RunOutcome& out) {
  if (!out.results.times.empty()) output::write_results(folder, out.results);
  output::write_summary(folder / "summary.json", output::to_json(out.summary));
}

#ifdef LIESL_OPTIM

namespace {

void write_series(const std::filesystem::path& path, const std::vector<double>& times,
                  std::vector<output::ResponseResult> responses, const Scene& scene) {
  output::Results r;
  r.times = times;
  if (scene.simulation.type != SimulationType::Dynamic) {
    r.abscissa = "load_factor";
    r.abscissa_unit = "-";
  }
  r.responses = std::move(responses);
  output::write_responses_csv(path, r);
}

}  // namespace

void write_optimization(const std::filesystem::path& folder, const OptimizeOutcome& out,
                        const Study& study) {
  const Scene& scene = study.scene;
  if (out.simulated) {
    output::write_results(folder, out.results);
    for (const auto& [name, motions] : {std::pair{"initial", &out.initial}, {"final", &out.final}})
      for (const LimitRecords& r : *motions)
        write_series(folder / fmt::format("responses_{}{}{}.csv", name,
                                          r.scenario.empty() ? "" : "_", r.scenario),
                     r.times, r.responses, scene);
  }
  if (!out.simulated && !out.results.meshes.empty()) output::write_shown(folder, out.results);
  if (!out.design.empty()) output::write_design_csv(folder / "design.csv", out.design);
  if (out.simulated) output::write_file(folder / "design.toml", final_scene(out, study));
  for (const PartOutcome& part : out.parts) write_part(folder, part);
  if (!out.loads.empty())
    output::write_file(folder / "cycle_loads.csv", loads_table(out.loads, scene.simulation.type));
  output::write_summary(folder / "summary.json", output::to_json(out.summary));
}

#endif

}  // namespace liesl
