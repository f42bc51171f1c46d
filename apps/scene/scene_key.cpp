#include "apps/scene/scene_key.hpp"

#include <charconv>
#include <sstream>

#include "apps/input/document.hpp"

namespace liesl {
namespace {

/// The node at a key path; null if there is none.
const toml::node* node_at(const toml::table& root, const std::string& path) {
  const toml::node* at = &root;
  std::istringstream parts(path);
  for (std::string part; at && std::getline(parts, part, '.');) {
    if (const toml::table* table = at->as_table()) {
      at = table->get(part);
    } else if (const toml::array* list = at->as_array()) {
      std::size_t index = list->size();
      std::from_chars(part.data(), part.data() + part.size(), index);
      at = index < list->size() ? list->get(index) : nullptr;
    } else {
      at = nullptr;
    }
  }
  return at;
}

}  // namespace

SceneNumber number_at(const SceneText& scene, const std::string& key) {
  Document document = parse_document(scene.text, scene.file);
  Problems problems(document.file);
  apply_overrides(document.root, FileKind::Scene, scene.changes, problems);
  problems.throw_if_any();
  const toml::node* node = node_at(document.root, key);
  if (node && node->is_number())
    return {*node->value<double>(), std::string(unit_at(FileKind::Scene, key))};
  if (node)
    problems.add(*node, "'" + key + "' is no number", "the key of a number",
                 "entries of lists are numbered, as in loads.push.force.1");
  else
    apply_overrides(document.root, FileKind::Scene, {key + "=0"}, problems);
  if (problems.count() == 0)  // the key of something that is left out
    problems.add({document.file, 0, 0, "'" + key + "' is not written in the scene",
                  "the key of a number that the scene gives", "write it, or give it by --set"});
  problems.throw_if_any();
  return {};
}

}  // namespace liesl
