#include "apps/scene/load_scene.hpp"

#include "apps/input/document.hpp"
#include "apps/scene/reader.hpp"

namespace liesl {

namespace {

Scene read_document(Document document, const std::vector<std::string>& overrides) {
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Scene, problems);
  apply_overrides(document.root, FileKind::Scene, overrides, problems);
  const Broken broken = validate(document.root, FileKind::Scene, problems);
  Scene scene;
  scene.file = document.file;
  scene.input = document.text;
  for (const std::string& text : overrides) scene.input += "\n--set " + text;
  Reader reader{document.root, broken, problems, scene, {}, {}};
  read_parts(reader);
  problems.throw_if_any();
  return scene;
}

}  // namespace

Scene load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return read_document(load_document(path), overrides);
}

Scene read_scene(const std::string& text, const std::string& file,
                 const std::vector<std::string>& overrides) {
  return read_document(parse_document(text, file), overrides);
}

}  // namespace liesl
