#include <fmt/format.h>

#include "apps/cli/command.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/export_xdmf.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/result_summary.hpp"

#ifdef LIESL_OPTIM
#include "apps/cli/terminal.hpp"
#include "apps/export/part_matrices.hpp"
#include "apps/export/solid_deck.hpp"
#include "apps/scene/load_scene.hpp"
#endif

namespace liesl {
namespace {

#ifdef LIESL_OPTIM

namespace fs = std::filesystem;

[[noreturn]] void refuse(const CommandOptions& options, std::string what, std::string expected) {
  throw InputError({{options.file, 0, 0, std::move(what), std::move(expected), ""}});
}

/// Meshes and matrices are those that the result was made of.
void check_files(const CommandOptions& options, const Scene& scene,
                 const nlohmann::ordered_json& summary) {
  const auto known = summary.value("files", nlohmann::ordered_json::object());
  for (const NamedInput& file : scene.files)
    if (std::none_of(known.begin(), known.end(),
                     [&](const auto& sha256) { return sha256 == file.sha256; }))
      refuse(options, "'" + file.path + "', which it was made of, has changed",
             "the file as it was");
}

/// A design is that of the result: as it was written, not edited since.
void check_design(const CommandOptions& options, const std::string& name,
                  const nlohmann::ordered_json& summary) {
  const auto designs = summary.value("design_files", nlohmann::ordered_json::object());
  const fs::path file = fs::path(options.file) / name;
  if (designs.contains(name) && output::sha256(output::read_file(file)) != designs[name])
    throw InputError({{options.file, 0, 0,
                       "'" + name + "' is not the design of these results: it was edited since",
                       "the file as 'optimize' left it",
                       "liesl export " + file.string() + " ... takes it as a scene of its own"}});
}

/// Of a motion, or one of the scenarios of a study.
struct Source {
  std::string scenario;
  Scene scene;
};

/// The final design in its motion, or in that of each scenario that the summary names: other files
/// design_*.toml are not of this result.
std::vector<Source> designs_of(const CommandOptions& options,
                               const nlohmann::ordered_json& summary) {
  const fs::path folder = options.file;
  check_design(options, "design.toml", summary);
  check_files(options, load_scene(folder / "design.toml"), summary);
  std::vector<Source> designs;
  for (const auto& name : summary.value("scenarios", std::vector<std::string>())) {
    const fs::path file = folder / ("design_" + name + ".toml");
    if (!fs::is_regular_file(file))
      refuse(options, "'" + file.filename().string() + "' of scenario '" + name + "' is missing",
             "the whole folder, as 'optimize' left it");
    check_design(options, file.filename().string(), summary);
    designs.push_back({name, load_scene(file, options.set)});
    designs.back().scene.mechanism.name += ", scenario '" + name + "'";
  }
  if (designs.empty()) designs.push_back({"", load_scene(folder / "design.toml", options.set)});
  return designs;
}

/// The scenes of a results folder: of its final design, or the file that `run` or `esl` read, with
/// what was overridden.
std::vector<Source> scenes_of_folder(const CommandOptions& options) {
  const fs::path folder = options.file;
  const auto summary = output::read_whole_summary(folder, "export");
  if (fs::exists(folder / "design.toml")) return designs_of(options, summary);
  const auto text = [&](const char* key) {
    return summary.contains(key) && summary[key].is_string() ? summary[key].get<std::string>()
                                                             : std::string();
  };
  if (text("command") == "optimize")
    refuse(
        options,
        "is of a study of fixed loads: its part does not move and has no equivalent static loads",
        "a folder of a motion; the loads of this part are the [loads] of '" + text("input") +
            "', and its final outline is the PART_outline.toml of the folder");
  if (text("command") != "run" && text("command") != "esl")
    refuse(options, "is a folder without a scene",
           "the file of a scene, or a folder of 'run', 'esl' or 'optimize'");
  const std::string file = text("input");
  std::vector<std::string> set;
  if (summary.contains("overrides"))
    for (const auto& change : summary["overrides"])
      if (change.is_string()) set.push_back(change.get<std::string>());
  if (!fs::is_regular_file(file) ||
      output::sha256(load_scene(file, set).input) != text("input_sha256"))
    refuse(options, "'" + file + "', which it was made of, is gone or has changed",
           "the file as it was, named from here");
  set.insert(set.end(), options.set.begin(), options.set.end());
  return {{"", load_scene(file, set)}};
}

/// At least one.
std::vector<Source> scenes_of(const CommandOptions& options) {
  if (fs::is_directory(options.file)) return scenes_of_folder(options);
  return {{"", load_scene(options.file, options.set)}};
}

/// Names of the beams and meshed parts of a scene.
std::vector<std::string> parts_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.mechanism.bodies)
    if (std::holds_alternative<BeamSpec>(body.kind) || std::holds_alternative<SolidSpec>(body.kind))
      names.push_back(body.name);
  return names;
}

/// The motion with the loads of all parts.
EslOutcome loads_of_motion(const Scene& scene, const CommandOptions& options) {
  SimulationLine line(scene.simulation, options.quiet);
  EslOutcome esl = esl_task(scene, choose_space(scene), std::ref(line));
  line.clear();
  if (esl.run.status != SolveStatus::Converged)
    throw InputError(
        {{options.file, 0, 0, "the simulation ended without its loads: " + esl.run.summary.reason,
          "a simulation that converges", "liesl run"}});
  return esl;
}

/// The files of a deck. @returns how many load cases it has
template <class Deck>
std::size_t write_deck(const fs::path& folder, const Deck& deck, const CommandOptions& options) {
  const bool calculix = options.to == "calculix";
  output::write_file(folder / (options.part + (calculix ? ".inp" : ".bdf")),
                     calculix ? calculix_text(deck) : nastran_text(deck));
  output::write_file(folder / "displacements.csv", deck_displacements(deck));
  output::write_file(folder / "README.md", deck_readme(deck, calculix ? "CalculiX" : "Nastran"));
  if constexpr (std::is_same_v<Deck, SolidDeck>) {
    output::write_file(folder / "factors.csv", deck_factors(deck));
    return deck.times.size();
  } else {
    return deck.cases.size();
  }
}

/// Where the files of a part go.
fs::path target_folder(const CommandOptions& options) {
  if (!options.out.empty()) return options.out;
  const fs::path whole = fs::absolute(options.file).lexically_normal(),
                 source = whole.has_filename() ? whole : whole.parent_path();
  return fmt::format("{}_{}_{}",
                     (fs::is_directory(source) ? source.filename() : source.stem()).string(),
                     options.part, options.to);
}

/// Stiffness, mass and nodes of a meshed part; its motion does not matter.
int export_matrices(const CommandOptions& options) {
  const Scene scene = scenes_of(options).front().scene;
  std::vector<std::string> parts;
  for (const BodySpec& body : scene.mechanism.bodies)
    if (std::holds_alternative<SolidSpec>(body.kind)) parts.push_back(body.name);
  if (std::find(parts.begin(), parts.end(), options.part) == parts.end())
    refuse(options,
           options.part.empty() ? "--part is missing"
                                : "--part: there is no meshed part '" + options.part + "'",
           "the name of a meshed part; " +
               suggestion(options.part, parts, "the scene has none, --to calculix takes beams"));
  const BodySpec& body =
      scene.mechanism.bodies[static_cast<std::size_t>(scene.mechanism.body(options.part))];
  if (std::get<SolidSpec>(body.kind).as == SolidMotion::Continuum)
    refuse(options,
           "part '" + options.part + "' is a continuum: its stiffness changes with its motion",
           "as = \"reduced\"");
  output::AtomicFolder folder(target_folder(options), options.force);
  write_part_matrices(folder.path(), body.name, std::get<SolidSpec>(body.kind));
  folder.commit();
  if (!options.quiet) fmt::print("{}\n", (target_folder(options) / (body.name + ".toml")).string());
  return 0;
}

/// The deck of one motion in a folder. @returns how many load cases it has
std::size_t export_motion(const fs::path& folder, const Scene& scene,
                          const CommandOptions& options) {
  const EslOutcome esl = loads_of_motion(scene, options);
  const DeckCases cases = options.cases == "all" ? DeckCases::All : DeckCases::Peaks;
  const BodySpec& body =
      scene.mechanism.bodies[static_cast<std::size_t>(scene.mechanism.body(options.part))];
  return std::holds_alternative<SolidSpec>(body.kind)
             ? write_deck(folder, solid_deck(scene, esl, options.part, cases), options)
             : write_deck(folder, beam_deck(scene, esl, options.part, cases), options);
}

/// A folder with the part, its loads, what they shall give back and what all that means; of a study
/// with scenarios a folder each in it.
int export_deck(const CommandOptions& options) {
  if (options.to == "matrices") return export_matrices(options);
  const std::vector<Source> sources = scenes_of(options);
  const auto parts = parts_of(sources.front().scene);
  if (std::find(parts.begin(), parts.end(), options.part) == parts.end())
    refuse(options,
           options.part.empty() ? "--part is missing"
                                : "--part: there is no beam or meshed part '" + options.part + "'",
           "the name of a beam or meshed part; " + suggestion(options.part, parts));
  const fs::path target = target_folder(options);
  output::AtomicFolder folder(target, options.force);
  const std::string file = options.part + (options.to == "calculix" ? ".inp" : ".bdf");
  std::string said;
  for (const Source& source : sources) {
    fs::create_directories(folder.path() / source.scenario);
    const std::size_t count = export_motion(folder.path() / source.scenario, source.scene, options);
    said += fmt::format("{}: {} load case{} of '{}'\n", (target / source.scenario / file).string(),
                        count, count == 1 ? "" : "s", options.part);
  }
  folder.commit();
  if (!options.quiet) fmt::print("{}", said);
  return 0;
}

#else

int export_deck(const CommandOptions& options) {
  throw output::without_optimisation("export", options.file);
}

#endif

}  // namespace

int export_command(const CommandOptions& options) {
  if (options.to != "xdmf") return export_deck(options);
  if (!options.part.empty() || !options.out.empty() || !options.set.empty() || options.force ||
      options.cases != "peaks")
    throw InputError(
        {{options.file, 0, 0,
          "--part, --cases, --set, --force and -o are not for --to xdmf, the default",
          "--to calculix, --to nastran or --to matrices with them, or a results folder alone",
          "--to calculix"}});
  output::read_whole_summary(options.file, "export");
  output::export_xdmf(options.file);
  if (!options.quiet)
    fmt::print("{}\n", (std::filesystem::path(options.file) / "results.xdmf").string());
  return 0;
}

}  // namespace liesl
