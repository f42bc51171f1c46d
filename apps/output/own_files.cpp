#include "apps/output/own_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

using Names = std::set<std::string>;

constexpr const char* kHead = "# Files that liesl wrote in this folder; it replaces no others.\n";

/// Files and empty folders of a folder, relative to it.
std::vector<std::string> leaves(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool inner = entry.is_directory() && !entry.is_symlink() && !fs::is_empty(entry.path());
    if (!inner) names.push_back(entry.path().lexically_relative(folder).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Lines of the mark; empty if there is none.
Names marked(const fs::path& folder) {
  Names names;
  std::error_code error;
  if (!fs::is_regular_file(folder / kMark, error)) return names;
  names.insert(kMark);
  std::istringstream lines(read_file(folder / kMark));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty() && line[0] != '#') names.insert(line);
  return names;
}

nlohmann::json json_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};
  return nlohmann::json::parse(read_file(path), nullptr, false);
}

/// Has a result without mark this file by docs/outputs.md? Those of a part only beside its .vtu.
bool documented(const fs::path& folder, const std::string& name) {
  static const std::regex fixed(
      R"(summary\.json|results\.(h5|xdmf|csv)|(responses|energies|joints|frames|sections|part_lines|rigid_paths|cycle_loads|design|rows|map|path)\.csv)"
      R"(|(loads|map)\.h5|loads\.csv|responses_(initial|final)\.csv|checkpoint\.json|lean\.toml|batch\.json)"
      R"(|\.lock|done\.json|log\.txt|reference_\d+\.csv|cases|plots/[^/]+\.(png|svg))");
  static const std::regex of_part(
      R"(([^/]+?)(\.svg|\.dxf|\.stl|\.vtu|_outline\.toml|_outlines\.csv|_cells\.csv))");
  std::smatch part;
  return std::regex_match(name, fixed) ||
         (std::regex_match(name, part, of_part) && fs::exists(folder / (part.str(1) + ".vtu")));
}

/// A file that a process replaces, or was replacing when it was killed; so is what is in a folder
/// of such a name, and the folder of pictures before the first one.
bool unfinished(const fs::path& folder, const fs::path& name) {
  std::error_code error;
  return writer_of_part(name.filename().string()) > 0 ||
         writer_of_part(name.begin()->string()) > 0 ||
         (name == kPictures && fs::is_directory(fs::symlink_status(folder / name, error)));
}

/// "cases/<name>/rest" or "cases/.<name>.what" -> <name>; empty if it is neither.
std::string case_of(const std::string& name, const nlohmann::json& cases) {
  static const std::regex inside(R"(cases/([^/]+)(/.*)?)"),
      hidden(R"(cases/\.(.+)\.(log|previous(/.*)?|partial-[^/]*(/.*)?))");
  std::smatch found;
  const bool is_hidden = std::regex_match(name, found, hidden);
  if (!is_hidden && !std::regex_match(name, found, inside)) return "";
  return cases.contains(found.str(1)) ? found.str(1) : "";
}

/// @param is_case a folder that is known to be liesl's, with or without a result in it
std::vector<std::string> foreign(const fs::path& folder, bool is_case) {
  const Names own = marked(folder);
  const bool by_name = own.empty() && (is_case || is_result(folder));
  const nlohmann::json plan = json_of(folder / "batch.json");
  const nlohmann::json cases =
      plan.is_object() && plan.contains("input_sha256") && plan.contains("cases")
          ? plan.at("cases")
          : nlohmann::json::object();
  std::vector<std::string> names;
  Names known;  // cases that have been looked into
  for (const std::string& name : leaves(folder)) {
    if (own.count(name) || (by_name && documented(folder, name))) continue;
    if (unfinished(folder, name)) continue;
    const std::string of = case_of(name, cases), place = "cases/" + of;
    if (of.empty()) {
      names.push_back(name);
    } else if (name.starts_with(place + "/") && known.insert(of).second) {
      for (const std::string& inner : foreign(folder / place, true))
        names.push_back(place + "/" + inner);
    }
  }
  return names;
}

/// "'a.txt' (and 2 more)"
std::string first_of(const std::vector<std::string>& names) {
  return fmt::format("'{}'{}", names.front(),
                     names.size() > 1 ? fmt::format(" (and {} more)", names.size() - 1) : "");
}

void write_mark(const fs::path& folder, Names names) {
  names.erase(kMark);
  std::string text = kHead;
  for (const std::string& name : names) text += name + "\n";
  replace_file(folder / kMark, text);
}

}  // namespace

bool is_result(const fs::path& folder) {
  std::error_code error;
  if (fs::is_regular_file(folder / kMark, error)) return true;
  const nlohmann::json summary = json_of(folder / "summary.json");
  return summary.is_object() && summary.contains("/versions/liesl"_json_pointer);
}

std::vector<std::string> foreign_files(const fs::path& folder) { return foreign(folder, false); }

std::vector<std::string> missing_files(const fs::path& folder) {
  const Names names = marked(folder);
  if (names.empty()) return {kMark};
  std::vector<std::string> missing;
  for (const std::string& name : names)
    if (name.find('/') == std::string::npos && !fs::exists(folder / name)) missing.push_back(name);
  return missing;
}

void mark_files(const fs::path& folder, const std::vector<std::string>& files) {
  Names names = marked(folder);
  if (names.empty() && !fs::is_empty(folder)) {  // older than marks
    const auto foreign = foreign_files(folder);
    for (const std::string& name : leaves(folder))
      if (!std::binary_search(foreign.begin(), foreign.end(), name)) names.insert(name);
  }
  names.insert(files.begin(), files.end());
  write_mark(folder, std::move(names));
}

void mark_all(const fs::path& folder) {
  const auto names = leaves(folder);
  write_mark(folder, {names.begin(), names.end()});
}

void check_own(const fs::path& folder) {
  const auto names = foreign_files(folder);
  if (names.empty()) return;
  throw IoError("replace", folder,
                fmt::format("it holds {}, which liesl did not write; move it elsewhere, or choose "
                            "another folder",
                            first_of(names)));
}

std::string content_of(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names.empty() ? "nothing" : first_of(names);
}

void remove_own(const fs::path& folder, const std::string& but) {
  auto keep = foreign_files(folder);
  keep.insert(std::upper_bound(keep.begin(), keep.end(), but), but);
  const auto kept = [&keep](const std::string& name) {
    return std::binary_search(keep.begin(), keep.end(), name);
  };
  for (const std::string& name : leaves(folder))
    if (!kept(name)) fs::remove(folder / name);
  std::vector<fs::path> folders;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory() && !entry.is_symlink()) folders.push_back(entry.path());
  for (auto it = folders.rbegin(); it != folders.rend(); ++it)  // the inner ones first
    if (fs::is_empty(*it) && !kept(it->lexically_relative(folder).generic_string()))
      fs::remove(*it);
}

void copy_own(const fs::path& from, const fs::path& to) {
  const auto foreign = foreign_files(from);
  for (const std::string& name : leaves(from)) {
    if (std::binary_search(foreign.begin(), foreign.end(), name)) continue;
    fs::create_directories((to / name).parent_path());
    fs::copy(from / name, to / name);
  }
}

void move_foreign(const fs::path& from, const fs::path& to) {
  for (const std::string& name : foreign_files(from)) {
    fs::path place = to / name;
    while (fs::exists(fs::symlink_status(place))) place += "~";
    fs::create_directories(place.parent_path());
    fs::rename(from / name, place);
  }
}

}  // namespace liesl::output
