#include <fmt/format.h>

#include "apps/cli/command.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/export_xdmf.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"

#ifdef LIESL_OPTIM
#include "apps/cli/terminal.hpp"
#include "apps/export/beam_deck.hpp"
#include "apps/scene/load_scene.hpp"
#endif

namespace liesl {
namespace {

#ifdef LIESL_OPTIM

namespace fs = std::filesystem;

[[noreturn]] void refuse(const CommandOptions& options, std::string what, std::string expected) {
  throw InputError({{options.file, 0, 0, std::move(what), std::move(expected), ""}});
}

/// Names of the beams of a scene.
std::vector<std::string> beams_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.mechanism.bodies)
    if (std::holds_alternative<BeamSpec>(body.kind)) names.push_back(body.name);
  return names;
}

/// A folder with the part, its loads, what they shall give back and what all that means.
int export_deck(const CommandOptions& options) {
  if (fs::is_directory(options.file))
    refuse(options, "is a folder; a deck is made of a scene", "the file of a scene");
  const Scene scene = load_scene(options.file, options.set);
  const ChosenSpace space = choose_space(scene);
  const auto beams = beams_of(scene);
  if (std::find(beams.begin(), beams.end(), options.part) == beams.end())
    refuse(options,
           options.part.empty() ? "--part is missing"
                                : "--part: there is no beam '" + options.part + "'",
           "the name of a beam; " + suggestion(options.part, beams));
  const fs::path target = options.out.empty()
                              ? fmt::format("{}_{}_{}", fs::path(options.file).stem().string(),
                                            options.part, options.to)
                              : options.out;
  output::AtomicFolder folder(target, options.force);
  SimulationLine line(scene.simulation, options.quiet);
  EslOutcome esl = esl_task(scene, space, std::ref(line));
  line.clear();
  const bool good = esl.run.status == SolveStatus::Converged;
  if (!good)
    throw InputError(
        {{options.file, 0, 0, "the simulation ended without its loads: " + esl.run.summary.reason,
          "a simulation that converges", "liesl run"}});
  const BeamDeck deck = beam_deck(scene, esl, options.part,
                                  options.cases == "all" ? DeckCases::All : DeckCases::Peaks);
  const bool calculix = options.to == "calculix";
  const std::string file = options.part + (calculix ? ".inp" : ".bdf");
  output::write_file(folder.path() / file, calculix ? calculix_text(deck) : nastran_text(deck));
  output::write_file(folder.path() / "displacements.csv", deck_displacements(deck));
  output::write_file(folder.path() / "README.md",
                     deck_readme(deck, calculix ? "CalculiX" : "Nastran"));
  folder.commit();
  if (!options.quiet)
    fmt::print("{}: {} load cases of '{}'\n", (target / file).string(), deck.cases.size(),
               deck.part);
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
    throw InputError({{options.file, 0, 0,
                       "--part, --cases, --set, --force and -o are for --to calculix or nastran",
                       "a results folder alone", "--to calculix"}});
  output::export_xdmf(options.file);
  if (!options.quiet)
    fmt::print("{}\n", (std::filesystem::path(options.file) / "results.xdmf").string());
  return 0;
}

}  // namespace liesl
