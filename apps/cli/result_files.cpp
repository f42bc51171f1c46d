#include "apps/cli/result_files.hpp"

#include "apps/output/write_results.hpp"

#ifdef LIESL_OPTIM
#include <fmt/format.h>

#include "apps/cli/part_files.hpp"
#include "apps/output/csv_writer.hpp"
#include "apps/output/file.hpp"
#include "apps/tasks/final_scene.hpp"
#endif

namespace liesl {

void write_run(const std::filesystem::path& folder, const RunOutcome& out,
               output::Hdf5Writer* begun) {
  if (!out.results.times.empty())
    output::write_results(folder, out.results, begun);
  else if (begun)
    begun->discard();
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

/// `cycle,scenario,body,time [s],node,Fx [N],Fy,Fz,Mx [N m],My,Mz,x [m],y,z` (load_factor [-] in
/// statics); a row a node of a beam, or an interface, then a patch, of a meshed part, which have
/// places; axes: see CycleLoads.
std::string loads_table(const std::vector<LoadsOfCycle>& loads, SimulationType type) {
  const bool dynamic = type == SimulationType::Dynamic;
  std::vector<output::TextColumn> columns = {
      {"cycle", "", {}},
      {"scenario", "", {}},
      {"body", "", {}},
      {dynamic ? "time" : "load_factor", dynamic ? "s" : "-", {}},
      {"node", "", {}}};
  for (const char* name : {"Fx", "Fy", "Fz"}) columns.push_back({name, "N", {}});
  for (const char* name : {"Mx", "My", "Mz"}) columns.push_back({name, "N m", {}});
  for (const char* name : {"x", "y", "z"}) columns.push_back({name, "m", {}});
  for (const LoadsOfCycle& part : loads)
    for (std::size_t n = 0; n < part.kept.times.size(); ++n)
      for (Eigen::Index k = 0; k < part.kept.loads[n].cols(); ++k) {
        columns[0].cells.push_back(std::to_string(part.cycle));
        columns[1].cells.push_back(part.scenario);
        columns[2].cells.push_back(part.body);
        columns[3].cells.push_back(output::cell(part.kept.times[n]));
        columns[4].cells.push_back(std::to_string(k));
        for (Eigen::Index c = 0; c < 6; ++c)
          columns[static_cast<std::size_t>(5 + c)].cells.push_back(
              output::cell(part.kept.loads[n](c, k)));
        for (Eigen::Index c = 0; c < 3; ++c)
          columns[static_cast<std::size_t>(11 + c)].cells.push_back(
              k < part.places.cols() ? output::cell(part.places(c, k)) : "");
      }
  return output::columns_csv(columns);
}

/// Of the scene, or of the first scenario, design.toml; of each scenario design_NAME.toml.
/// @returns the SHA-256 of each file
nlohmann::ordered_json write_designs(const std::filesystem::path& folder,
                                     const OptimizeOutcome& out, const Study& study) {
  nlohmann::ordered_json hashes;
  const auto write = [&](const std::string& name, const std::string& text) {
    output::write_file(folder / name, text);
    hashes[name] = output::sha256(text);
  };
  write("design.toml", final_scene(out, study));
  const std::vector<std::string>& names = study.spec.scenarios;
  for (std::size_t s = 0; s < names.size(); ++s)
    write(fmt::format("design_{}.toml", names[s]), final_scene(out, study, s));
  return hashes;
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
  auto summary = output::to_json(out.summary);
  if (out.simulated) summary["design_files"] = write_designs(folder, out, study);
  for (const PartOutcome& part : out.parts) write_part(folder, part);
  if (!out.loads.empty())
    output::write_file(folder / "cycle_loads.csv", loads_table(out.loads, scene.simulation.type));
  output::write_summary(folder / "summary.json", summary);
}

#endif

}  // namespace liesl
