#include "apps/study/load_study.hpp"

#include "apps/input/document.hpp"
#include "apps/study/study_reader.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

/// The scene that a study names, empty (and said) if it cannot be read.
std::optional<Document> scene_of(const toml::table& root, const fs::path& folder,
                                 Problems& problems) {
  const toml::node* node = root.get("scene");
  if (!node || !node->is_string()) return {};
  const fs::path path = fs::path(text(root, "scene"));
  try {
    Document document =
        load_document((path.is_absolute() ? path : folder / path).lexically_normal());
    if (kind_of(document.root) == FileKind::Scene) return document;
    problems.add(*node, "'scene' names a study", "the file of a scene");
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems) {
      if (problem.line > 0)
        problems.add(problem);
      else
        problems.add(*node, "scene " + problem.file + ": " + problem.what, problem.expected,
                     problem.hint.empty() ? "paths are relative to the study" : problem.hint);
    }
  }
  return {};
}

void read_study_parts(StudyReader& reader) {
  reader.spec.name = text(reader.root, "name");
  read_design(reader);
  read_objective(reader);
  read_constraints(reader);
  read_supports(reader);
  read_parts_of_study(reader);
  read_cycle(reader);
  check_images(reader);
  check_shapes(reader);
}

Study read_document(Document document, const fs::path& folder,
                    const std::vector<std::string>& overrides) {
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Study, problems);
  const SplitOverrides parts = split_overrides(overrides);
  apply_overrides(document.root, FileKind::Study, parts.study, problems);
  const Broken broken = validate(document.root, FileKind::Study, problems);

  auto inner = scene_of(document.root, folder, problems);
  if (!inner) problems.throw_if_any();
  if (toml::table* set = document.root["set"].as_table()) apply_set(*set, inner->root, problems);
  apply_overrides(inner->root, FileKind::Scene, parts.scene, problems);
  const Broken scene_broken = validate(inner->root, FileKind::Scene, problems);

  Study study;
  study.file = document.file;
  study.scene.file = inner->file;
  study.scene.input = inner->text;
  Reader scene{inner->root, scene_broken, problems, study.scene, {}, {}};
  scene.fixed_loads = document.root.contains("loads");
  read_parts(scene);
  study.input = document.text + study.scene.input;
  for (const std::string& text : overrides) study.input += "\n--set " + text;
  StudyReader reader{document.root, broken, scene, study.spec};
  read_study_parts(reader);
  problems.throw_if_any();
  return study;
}

}  // namespace

Study load_study(const fs::path& path, const std::vector<std::string>& overrides) {
  return read_document(load_document(path), path.parent_path(), overrides);
}

Study read_study(const std::string& text, const std::string& file, const fs::path& folder,
                 const std::vector<std::string>& overrides) {
  return read_document(parse_document(text, file), folder, overrides);
}

std::optional<InputProblem> key_problem(const fs::path& path, const std::string& key) {
  Document document = load_document(path);
  Problems problems(document.file);
  SplitOverrides parts{{}, {key + "=0"}};
  if (kind_of(document.root) == FileKind::Study) {
    parts = split_overrides(parts.scene);
    apply_overrides(document.root, FileKind::Study, parts.study, problems);
    if (auto scene = scene_of(document.root, path.parent_path(), problems))
      document = std::move(*scene);
  }
  apply_overrides(document.root, FileKind::Scene, parts.scene, problems);
  try {
    problems.throw_if_any();
  } catch (const InputError& error) {
    return error.problems.front();
  }
  return {};
}

}  // namespace liesl
