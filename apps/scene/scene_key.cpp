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

void for_each_file(
    toml::table& scene,
    const std::function<void(const std::string&, toml::value<std::string>&)>& found) {
  toml::table* bodies = scene["bodies"].as_table();
  if (!bodies) return;
  for (auto&& [name, body] : *bodies) {
    const auto solid = toml::node_view<toml::node>(body)["solid"];
    for (const char* key :
         {"mesh.file", "matrices.stiffness", "matrices.mass", "matrices.nodes", "matrices.file"})
      if (auto* file = solid.at_path(key).as_string())
        found("bodies." + std::string(name.str()) + ".solid." + key, *file);
  }
}

std::string whole_path(const std::filesystem::path& scene, const std::string& named) {
  return std::filesystem::absolute(scene.parent_path() / named).lexically_normal().string();
}

std::vector<std::string> whole_paths(const std::string& text, const std::string& scene,
                                     const std::vector<std::string>& overrides) {
  Document document = parse_document(text, scene);
  Problems problems(scene);
  apply_overrides(document.root, FileKind::Scene, overrides, problems);
  problems.throw_if_any();
  std::vector<std::string> changes;
  for_each_file(document.root, [&](const std::string& key, toml::value<std::string>& file) {
    std::ostringstream value;
    value << toml::value<std::string>(whole_path(scene, *file));
    changes.push_back(key + "=" + value.str());
  });
  return changes;
}

}  // namespace liesl
