#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "apps/cli/command.hpp"
#include "apps/cli/run_summary.hpp"
#include "apps/lean/walk.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/scene/rewrite.hpp"

namespace liesl {

namespace {

using Json = nlohmann::ordered_json;

/// "1%" or "0.01". @throws InputError unless it is in (0, 0.5]
double read_tolerance(std::string text) {
  const std::string given = text;
  const bool percent = text.ends_with('%');
  if (percent) text.pop_back();
  while (text.ends_with(' ')) text.pop_back();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (percent) value /= 100;
  if (whole && value > 0 && value <= 0.5) return value;
  throw InputError(
      {{"--tolerance " + given, 0, 0, whole ? "out of range" : "neither a number nor a percentage",
        "a tolerance in (0, 0.5], relative to the largest response",
        "as in --tolerance 1% or --tolerance 0.01"}});
}

void check_response(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& r : scene.responses) names.push_back(r.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw InputError(
      {{"--response " + name, 0, 0, fmt::format("{} has no response '{}'", scene.file, name),
        "a name in [responses]", suggestion(name, names, "the scene has no [responses]")}});
}

Json setting_json(const Setting& s) {
  Json json = {{"space", s.space}, {"steps", s.steps}, {"step", s.step()}, {"tangent", s.tangent}};
  json["beams"] = Json::object();
  for (const auto& beam : s.beams) {
    Json& b = json["beams"][beam.name] = {{"rigid", beam.rigid}, {"elements", beam.elements}};
    b["modes"] = beam.modes >= 0 ? Json(beam.modes) : Json(nullptr);
  }
  return json;
}

Json summary_json(const LeanResult& r, const CommandOptions& options, double tolerance) {
  Json json = {{"response", options.response},
               {"tolerance", tolerance},
               {"error", r.error},
               {"error_given", r.error_given},
               {"time_s", r.time},
               {"time_given_s", r.time_given},
               {"time_reference_s", r.time_reference},
               {"time_held_out_s", r.time_held_out},
               {"corrections_given", r.corrections_given},
               {"reference_error", r.reference_error},
               {"lean", setting_json(r.lean)},
               {"given", setting_json(r.given)},
               {"reference", setting_json(r.reference)},
               {"held_out", setting_json(r.held_out)},
               {"changes", r.changes},
               {"runs", r.runs}};
  json["decisions"] = Json::array();
  for (const auto& d : r.decisions)
    json["decisions"].push_back({{"about", d.about},
                                 {"choice", d.choice},
                                 {"figure", d.figure},
                                 {"limit", d.limit > 0 ? Json(d.limit) : Json(nullptr)},
                                 {"evidence", d.evidence}});
  return json;
}

/// The comment on top of the lean scene.
std::string header(const LeanResult& r, const CommandOptions& options, double tolerance) {
  std::string text = fmt::format(
      "# Lean model of {}: '{}' within {:g} %, found by `liesl lean`.\n"
      "# {}: {:.3g} % from a run twice as fine as all that decided; as given: {:.3g} %.\n"
      "# {:.3g} s of processor time instead of {:.3g} s. Changed: {}.\n",
      std::filesystem::path(options.file).filename().string(), options.response, 100 * tolerance,
      to_string(r.status), 100 * r.error, 100 * r.error_given, r.time, r.time_given,
      r.changes.empty() ? "nothing" : fmt::format("{}", fmt::join(r.changes, ", ")));
  for (const auto& d : r.decisions)
    text += fmt::format("# {}: {} ({})\n", d.about, d.choice, d.evidence);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\r'; }, ' ');
  return text + "\n";
}

output::RunSummary describe(const LeanResult& r, const CommandOptions& options,
                            const Scene& scene) {
  output::RunSummary summary;
  summary.command = "lean";
  summary.name = scene.mechanism.name;
  summary.status = to_string(r.status);
  summary.reason = r.reason;
  summary.space = r.space;
  summary.space_reason = r.space_reason;
  summary.steps = static_cast<int>(r.lean.steps);
  summary.newton_iterations = r.corrections;
  summary.stepping_s = r.time;
  summary.warnings = r.warnings;
  summary.overrides = options.set;
  summary.input_sha256 = output::sha256(scene.input);
  return summary;
}

void print_result(const LeanResult& r, const std::string& folder) {
  fmt::print("{}: {}\n", to_string(r.status), r.reason);
  if (r.status == LeanStatus::Done)
    fmt::print("  error {:.3g} % (as given {:.3g} %), time {:.3g} s (as given {:.3g} s), {} runs\n",
               100 * r.error, 100 * r.error_given, r.time, r.time_given, r.runs);
  for (const auto& change : r.changes) fmt::print("  {}\n", change);
  for (const auto& warning : r.warnings) fmt::print("  note: {}\n", warning);
  fmt::print("results in {}; next: liesl run {}/lean.toml -o DIR\n", folder, folder);
}

}  // namespace

int lean_command(const CommandOptions& options) {
  const Stopwatch clock;
  const double tolerance = read_tolerance(options.tolerance);
  Scene scene = load_scene(options.file, options.set);
  check_response(scene, options.response);
  std::vector<std::string> overrides = options.set;
  if (scene.simulation.adaptive) overrides.push_back("simulation.adaptive=false");
  const std::string text = load_document(options.file).text;
  output::AtomicFolder folder(options.out, options.force);

  Trials trials(text, options.file, overrides, options.response,
                [](double) { return output::interrupted() == 0; });
  const LeanResult r = find_lean(trials, tolerance, [&](const Decision& d) {
    if (!options.quiet) fmt::print("{:<14} {}\n               {}\n", d.about, d.choice, d.evidence);
    std::fflush(stdout);
  });

  if (r.status == LeanStatus::Done) {
    auto changes = overrides;
    changes.insert(changes.end(), r.changes.begin(), r.changes.end());
    output::write_file(folder.path() / "lean.toml",
                       header(r, options, tolerance) + rewrite_scene(text, changes));
  }
  output::RunSummary summary = describe(r, options, scene);
  summary.more = summary_json(r, options, tolerance);
  summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(summary));
  folder.commit();
  if (!options.quiet) print_result(r, options.out);
  return r.status == LeanStatus::Done ? 0 : 1;
}

}  // namespace liesl
