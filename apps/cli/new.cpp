#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <regex>

#include "apps/cli/command.hpp"
#include "apps/cli/templates.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/input/problem.hpp"
#include "apps/input/rewrite.hpp"
#include "apps/input/schema.hpp"
#include "apps/output/file.hpp"
#include "apps/output/installation.hpp"
#include "apps/output/io_error.hpp"

namespace fs = std::filesystem;

namespace liesl {
namespace {

/// A shipped file of a kind by its name, or the only one that begins so.
/// @throws InputError with the names there are
const Template& find(const std::string& kind, const std::string& name) {
  std::vector<std::string> names, begun;
  const Template* only = nullptr;
  for (const Template& t : templates()) {
    if (t.kind != kind) continue;
    if (t.name == name) return t;
    names.emplace_back(t.name);
    if (!name.empty() && t.name.starts_with(name)) {
      begun.emplace_back(t.name);
      only = &t;
    }
  }
  if (begun.size() == 1) return *only;
  const std::string what =
      name.empty() ? "--like is missing" : "there is no " + kind + " '" + name + "'";
  throw InputError(
      {{"new", 0, 0, what, "--like with the name of a shipped " + kind,
        name.empty()    ? fmt::format("known: {}", fmt::join(names, ", "))
        : begun.empty() ? suggestion(name, names)
                        : fmt::format("did you mean '{}'?", fmt::join(begun, "', '"))}});
}

const Template& scene_of_study(const std::string& name) {
  for (const Template& t : templates())
    if (t.kind == "part" && t.name == name) return t;
  return find("scene", name);
}

/// A study that names its scene as a file in its folder.
struct StudyText {
  std::string scene;  ///< name of the shipped scene; empty for what is no study
  std::string file;   ///< of the scene
  std::string text;   ///< of the study
};

/// A text with the line on top by which editors find its schema, that of this program: shipped
/// files name it from their own folder.
std::string with_schema(FileKind kind, const std::string& text) {
  const fs::path schema =
      output::share_path() / "schema" / fmt::format("{}.json", std::string(name_of(kind)));
  const std::string plain = without_schema_line(text);
  return fs::is_regular_file(schema) ? fmt::format("#:schema {}\n{}", schema.string(), plain)
                                     : plain;
}

/// @param own name of the study's file, which the scene's is not
StudyText with_scene(std::string_view study, const std::string& own) {
  static const std::regex line(R"re((^|\n)scene = "\.\./\w+/(\w+)\.toml")re");
  StudyText out{"", "", std::string(study)};
  std::smatch found;
  if (!std::regex_search(out.text, found, line)) return out;
  const auto at = static_cast<std::size_t>(found.position()),
             length = static_cast<std::size_t>(found.length());
  out.scene = found.str(2);
  out.file = out.scene + ".toml";
  if (out.file == own) out.file = out.scene + "_scene.toml";
  const std::string named = found.str(1) + "scene = \"" + out.file + "\"";
  out.text.replace(at, length, named);
  return out;
}

}  // namespace

int new_command(const CommandOptions& options) {
  const Template& source = find(options.file, options.like);
  const fs::path path = options.out.empty() ? std::string(source.name) + ".toml" : options.out;
  if (fs::exists(path) && !options.force)
    throw output::IoError("write", path, "it exists; choose another name with -o, or --force");
  const StudyText made = with_scene(source.text, path.filename().string());
  if (!made.scene.empty()) {
    const fs::path scene = path.parent_path() / made.file;
    const bool there = fs::exists(scene) && !options.force;
    if (!there)
      output::replace_file(
          scene, with_schema(FileKind::Scene, std::string(scene_of_study(made.scene).text)));
    if (!options.quiet)
      fmt::print("{}{}\n", scene.string(), there ? " (was there, not changed)" : "");
  }
  output::replace_file(
      path, with_schema(options.file == "study" ? FileKind::Study : FileKind::Scene, made.text));
  if (!options.quiet)
    fmt::print("{}\nnext: liesl {} {}\n", path.string(),
               options.file == "study" ? "optimize" : "run", shell_word(path.string()));
  return 0;
}

int schema_command(const CommandOptions& options) {
  for (const FileKind kind : kFileKinds)
    if (options.file == name_of(kind)) fmt::print("{}", schema_json(kind));
  return 0;
}

}  // namespace liesl
