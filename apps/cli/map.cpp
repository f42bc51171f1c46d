#include <fmt/format.h>

#include "apps/cli/command.hpp"

#ifndef LIESL_OPTIM

#include "apps/output/io_error.hpp"

namespace liesl {

int map_command(const CommandOptions& options) {
  throw output::without_optimisation("map", options.file);
}

}  // namespace liesl

#else

#include <cstdlib>

#include "apps/cli/terminal.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/plot_program.hpp"
#include "apps/study/load_study.hpp"
#include "apps/tasks/map.hpp"

namespace liesl {
namespace {

using Json = nlohmann::ordered_json;

/// "NAME" or "NAME=FROM:TO".
MapAxis axis_of(const std::string& text) {
  const auto equals = text.find('=');
  MapAxis axis{text.substr(0, equals), {}};
  if (equals == std::string::npos) return axis;
  const char* rest = text.c_str() + equals + 1;
  char *colon = nullptr, *end = nullptr;
  const double from = std::strtod(rest, &colon);
  const double to = *colon == ':' ? std::strtod(colon + 1, &end) : 0;
  if (colon == rest || !end || end == colon + 1 || *end != '\0')
    throw InputError({{"--over " + text, 0, 0, "the range cannot be read", "NAME=FROM:TO",
                       "as in --over rod_diameters[0]=0.008:0.012,rod_diameters[1]"}});
  axis.range = {from, to};
  return axis;
}

/// The designs of a results folder of `liesl optimize`.
DesignPath path_of(const std::string& folder) {
  DesignPath path{"--path " + folder, {}, {}, {}};
  const std::string text = output::read_file(std::filesystem::path(folder) / "summary.json");
  const Json summary = Json::parse(text, nullptr, false);
  if (!summary.is_object() || summary.value("command", "") != "optimize" ||
      !summary.contains("design") || !summary.contains("history"))
    throw InputError(
        {{path.file, 0, 0, "the folder holds no optimisation", "results of liesl optimize", ""}});
  for (const auto& [name, value] : summary["design"].items()) {
    path.names.push_back(name);
    path.last.push_back(value.get<double>());
  }
  for (const Json& cycle : summary["history"])
    if (cycle.contains("design"))
      path.cycles.emplace_back(cycle["cycle"].get<int>(),
                               cycle["design"].get<std::vector<double> >());
  return path;
}

MapRequest request_of(const CommandOptions& options) {
  MapRequest request;
  for (const std::string& text : options.over) request.over.push_back(axis_of(text));
  request.of = options.of;
  request.points = options.points;
  if (!options.path.empty()) request.path = path_of(options.path);
  if (options.cycle > 0) request.cycle = options.cycle;
  return request;
}

void write(const MapOutcome& out, const std::filesystem::path& folder) {
  output::write_map_csv(folder / "map.csv", out.map);
  if (!out.map.path.empty()) output::write_path_csv(folder / "path.csv", out.map);
  output::write_map_h5(folder / "map.h5", out.map);
  output::write_summary(folder / "summary.json", output::to_json(out.summary, out.map));
}

}  // namespace

int map_command(const CommandOptions& options) {
  const Stopwatch clock;
  const Study study = load_study(options.file, options.set);
  if (study.scene.simulation.type == SimulationType::Modes)
    throw InputError({{study.scene.file, 0, 0, "simulation.type = \"modes\" has no loads",
                       "\"dynamic\" or \"static\"", ""}});
  const MapRequest request = request_of(options);
  output::AtomicFolder folder(options.out, options.force);
  output::Progress line("mapping", 1, "", options.quiet);
  MapHooks hooks;
  hooks.keep_going = [] { return output::interrupted() == 0; };
  hooks.on_point = [&line](int done, int all) {
    line.update(static_cast<double>(done) / all, fmt::format("design {} of {}", done, all));
  };
  MapOutcome out = map_task(study, choose_space(study.scene), request, hooks);
  line.clear();
  out.summary.overrides = options.set;
  out.summary.input = options.file;
  out.summary.input_sha256 = output::sha256(study.input);
  out.summary.wall_s = clock.seconds();
  write(out, folder.path());
  folder.commit();
  try {
    output::draw(options.out, "", "");
  } catch (const output::IoError& error) {
    if (!options.quiet) fmt::print("  note: no picture: {}\n", error.what());
  }
  if (!options.quiet) {
    fmt::print("{}: {} ({}), {:.3g} s\n  local model: {}\n", out.summary.name, out.summary.status,
               out.summary.reason, out.summary.wall_s, out.summary.local);
    print_folder(options.out);
  }
  return out.summary.status == "done" ? 0 : 1;
}

}  // namespace liesl

#endif
