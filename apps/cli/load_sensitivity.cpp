#include "apps/cli/load_sensitivity.hpp"

#include <fmt/format.h>

#include "apps/batch/grid.hpp"
#include "apps/input/document.hpp"
#include "apps/input/title.hpp"
#include "apps/input/validate.hpp"
#include "apps/input/values.hpp"

namespace liesl {
namespace {

constexpr double kRounding = 1e-9;

/// Keys of the file itself; what is left goes to the scene.
bool is_own(const std::string& change) {
  const std::string path = change.substr(0, change.find('='));
  const std::string top = path.substr(0, path.find('.'));
  return find_key(FileKind::Sensitivity, top) && (top == path || top != "scene");
}

std::vector<std::string> texts(const toml::table& root, std::string_view key) {
  std::vector<std::string> list;
  for (const toml::node* node : strings(root, key)) list.push_back(*node->value<std::string>());
  return list;
}

/// What `set` says of keys that the scene has not, or of values that are none, at their places in
/// the file.
void check_set(toml::table& set, const SceneText& scene, const std::vector<std::string>& of_scene,
               Problems& problems) {
  Document changed = parse_document(scene.text, scene.file);
  apply_set(set, changed.root, problems);
  apply_overrides(changed.root, FileKind::Scene, of_scene, problems);
  validate(changed.root, FileKind::Scene, problems);
  problems.throw_if_any();
}

}  // namespace

std::vector<FunctionalSpec> functionals_of(const std::vector<std::string>& words,
                                           const std::string& where) {
  std::vector<FunctionalSpec> list;
  for (const std::string& text : words) {
    const auto functional = functional_of(text);
    if (!functional)
      throw InputError({{fmt::format("{} {}", where, text), 0, 0, "there is no such functional",
                         "peak, integral, mean, rms, at=TIME, p=P (P >= 1) or ks=RHO (RHO > 0)",
                         suggestion(text.substr(0, text.find('=')), functional_words())}});
    list.push_back(*functional);
  }
  return list.empty() ? functionals_of({"peak", "integral", "mean", "rms"}, where) : list;
}

void require_times(const std::vector<FunctionalSpec>& functionals, double duration,
                   const std::string& where) {
  for (const FunctionalSpec& f : functionals)
    if (f.kind == FunctionalKind::At && f.number > duration * (1 + kRounding))
      throw InputError({{fmt::format("{} {}", where, to_string(f)), 0, 0,
                         fmt::format("the motion ends at {:.6g} s", duration),
                         "a time within the motion (s)", ""}});
}

SensitivityMethod method_of(const std::string& word) {
  return word == "direct"    ? SensitivityMethod::Direct
         : word == "adjoint" ? SensitivityMethod::Adjoint
                             : SensitivityMethod::Auto;
}

SensitivityFile load_sensitivity(const std::filesystem::path& path,
                                 const std::vector<std::string>& changes) {
  Document document = load_document(path);
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Sensitivity, problems);
  std::vector<std::string> own, of_scene;
  for (const std::string& change : changes) (is_own(change) ? own : of_scene).push_back(change);
  apply_overrides(document.root, FileKind::Sensitivity, own, problems);
  validate(document.root, FileKind::Sensitivity, problems);
  problems.throw_if_any();
  const toml::table& root = document.root;
  SensitivityFile file;
  file.name = title(root, document.file);
  file.scene.file = (path.parent_path() / text(root, "scene")).lexically_normal().string();
  try {
    file.scene.text = load_text(file.scene.file, "a scene in TOML");
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems)
      problems.add(*root.get("scene"), "scene " + problem.file + ": " + problem.what,
                   problem.expected, "paths are relative to the file");
    problems.throw_if_any();
  }
  if (const toml::table* set = root["set"].as_table())
    for (const auto& [name, node] : *set)
      file.scene.changes.push_back(fmt::format("{}={}", name.str(), toml_text(node)));
  if (toml::table* set = document.root["set"].as_table())
    check_set(*set, file.scene, of_scene, problems);
  for (const std::string& change : of_scene) file.scene.changes.push_back(change);
  file.input = document.text + file.scene.text;
  for (const std::string& change : changes) file.input += "\n--set " + change;
  file.by = texts(root, "by");
  file.request.functionals =
      functionals_of(texts(root, "functionals"), fmt::format("{}: functionals =", document.file));
  file.request.method = method_of(text(root, "method"));
  return file;
}

}  // namespace liesl
