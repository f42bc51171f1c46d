#include "apps/tasks/lean.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "apps/input/problem.hpp"
#include "apps/input/rewrite.hpp"
#include "apps/output/file.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/scene_key.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/run.hpp"
#include "apps/tasks/verify.hpp"

namespace liesl {

namespace {

using Json = nlohmann::ordered_json;

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
    Json& b = json["beams"][beam.name] = {{"rigid", beam.rigid},
                                          {"elements", beam.elements},
                                          {"order", beam.order},
                                          {"segments", beam.segments}};
    b["modes"] = beam.modes >= 0 ? Json(beam.modes) : Json(nullptr);
  }
  return json;
}

Json summary_json(const LeanResult& r, const LeanRequest& request) {
  Json json = {{"response", request.response},
               {"tolerance", request.tolerance},
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
  if (!has_model(r))
    for (const char* key :
         {"error", "error_given", "time_s", "time_given_s", "time_reference_s", "time_held_out_s",
          "corrections_given", "reference_error", "lean", "reference", "held_out", "changes"})
      json.erase(key);
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
std::string header(const LeanResult& r, const LeanRequest& request) {
  std::string text = fmt::format(
      "# Lean model of {}: '{}' within {:g} %, found by `liesl lean`.\n"
      "# {}: {:.3g} % from a run twice as fine as all that decided; as given: {:.3g} %.\n"
      "# {:.3g} s of processor time instead of {:.3g} s. Changed: {}.\n",
      std::filesystem::path(request.file).filename().string(), request.response,
      100 * request.tolerance, to_string(r.status), 100 * r.error, 100 * r.error_given, r.time,
      r.time_given, r.changes.empty() ? "nothing" : fmt::format("{}", fmt::join(r.changes, ", ")));
  for (const auto& d : r.decisions)
    text += fmt::format("# {}: {} ({})\n", d.about, d.choice, d.evidence);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\r'; }, ' ');
  return text + "\n";
}

output::RunSummary describe(const LeanResult& r, const LeanRequest& request, const Scene& scene) {
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
  summary.overrides = request.overrides;
  summary.input_sha256 = output::sha256(scene.input);
  return summary;
}

/// The lean model once more, with the errors of the response by mesh and step: the estimate of
/// `liesl run --verify` beside the error that was measured on the held-out run.
void add_errors(VerifiedScene lean, const std::string& response, const Progress& progress,
                output::RunSummary& summary) {
  Scene scene = read_scene(lean.text, lean.file, lean.overrides);
  std::erase_if(scene.responses, [&](const ResponseSpec& r) { return r.name != response; });
  lean.responses = scene.responses;
  RunOutcome run = run_task(scene, choose_space(scene), progress);
  if (run.status == SolveStatus::Inaccurate)
    return summary.warnings.push_back(
        "not verified: the response is within the tolerance, but `liesl run` ends the lean model "
        "'inaccurate': " +
        run.summary.reason);
  if (run.status != SolveStatus::Converged)  // stopped: the model was found before
    return summary.warnings.push_back("not verified: " + run.summary.reason);
  verify(lean, scene, run.summary, progress);
  summary.responses = std::move(run.summary.responses);
  summary.more["verification"] = run.summary.more["verification"];
  auto& warnings = run.summary.warnings;
  summary.warnings.insert(summary.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace

LeanOutcome lean_task(const LeanRequest& request, const Progress& progress,
                      const std::function<void(const Decision&)>& decided) {
  const Scene scene = read_scene(request.text, request.file, request.overrides);
  check_response(scene, request.response);
  std::vector<std::string> overrides = request.overrides;
  if (scene.simulation.adaptive) overrides.push_back("simulation.adaptive=false");
  const Trials::Fault fault = [&progress](const Scene& changed) {
    const RunOutcome run = run_task(changed, choose_space(changed), progress);
    return run.status == SolveStatus::Converged ? std::string() : run.summary.reason;
  };
  Trials trials(request.text, request.file, overrides, request.response, progress, fault);
  LeanOutcome out;
  out.result = find_lean(trials, request.tolerance, decided);
  out.summary = describe(out.result, request, scene);
  out.summary.more = summary_json(out.result, request);
  if (out.result.status != LeanStatus::Done) return out;
  overrides.insert(overrides.end(), out.result.changes.begin(), out.result.changes.end());
  if (request.verify)
    add_errors({request.text, request.file, overrides}, request.response, progress, out.summary);
  for (std::string& file : whole_paths(request.text, request.file, overrides))  // it lies elsewhere
    overrides.push_back(std::move(file));
  out.scene = header(out.result, request) + rewrite_scene(request.text, overrides);
  return out;
}

}  // namespace liesl
