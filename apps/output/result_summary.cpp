#include "apps/output/result_summary.hpp"

#include <algorithm>

#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/summary_types.hpp"
#include "apps/output/versions.hpp"
#include "apps/output/whole_tables.hpp"

namespace fs = std::filesystem;

namespace liesl::output {

namespace {

using Json = nlohmann::ordered_json;

/// What `export --to xdmf` makes of results.h5, and makes again.
constexpr const char* kDerivedMeshes = "meshes.h5";

/// Is a file of numbers one that readers need? Batches and comparisons name files before they are
/// written; they have their tables from the beginning.
bool is_needed(const fs::path& name, const std::string& command) {
  if (name == kDerivedMeshes) return false;
  if (command == "batch") return name == "results.csv";
  if (command == "compare") return name == "rows.csv";
  return name.extension() == ".csv" || name.extension() == ".h5";
}

constexpr std::string_view kCommands[] = {"run",     "esl", "optimize",    "batch",
                                          "compare", "map", "sensitivity", "lean"};

constexpr const char* kHint = "; copy the whole folder, or run it again";

/// What results.h5 of one motion lacks of what its summary tells of; empty: nothing.
std::string missing_set(const Hdf5Input& file, const Json& summary) {
  std::vector<std::string> sets = {"/time"};
  const Json responses = summary.value("responses", Json::object());
  for (const auto& [name, response] : responses.items())
    sets.push_back("/responses/" + hdf5_name(name));
  for (const std::string& body : file.children("/bodies"))
    for (const char* set : {"/position", "/rotation", "/reference_position"})
      sets.push_back("/bodies/" + body + set);
  const auto it =
      std::find_if(sets.begin(), sets.end(), [&](const auto& set) { return !file.has(set); });
  return it == sets.end() ? "" : it->substr(1);
}

}  // namespace

nlohmann::ordered_json read_summary(const fs::path& folder, const std::string& verb) {
  const fs::path path = folder / "summary.json";
  if (!fs::is_directory(folder))
    throw IoError(verb, folder,
                  fs::exists(folder) ? "it is a file; name the folder of a result"
                                     : "there is no such folder");
  if (!fs::exists(path) && fs::exists(folder / "batch.json"))
    throw IoError(verb, folder,
                  "its batch has not written a table yet; the same `liesl batch` goes on where it "
                  "was");
  if (!fs::exists(path))
    throw IoError(verb, folder, "it holds no result of liesl (no summary.json)");
  Json summary = Json::parse(read_file(path), nullptr, false);
  if (!summary.is_object() || !summary.contains("versions") || !summary["versions"].is_object() ||
      !summary["versions"].contains("liesl"))
    throw IoError(verb, path, "it is not of liesl, or not whole");
  const Json& version = summary["versions"]["liesl"];
  if (version != versions().front().second)
    throw IoError(verb, path, "it is of liesl " + version.dump() + "; run it again");
  if (const std::string wrong = wrong_type(summary); !wrong.empty())
    throw IoError(verb, path, "its " + wrong + ", not what liesl writes");
  const std::string command = summary.value("command", "");
  if (std::ranges::find(kCommands, command) == std::end(kCommands))
    throw IoError(verb, path, "its command is '" + command + "', none that leaves results");
  return summary;
}

nlohmann::ordered_json read_whole_summary(const fs::path& folder, const std::string& verb) {
  Json summary = read_summary(folder, verb);
  const std::string command = summary.value("command", "");
  for (const fs::path name : missing_files(folder))
    if (name == kMark || is_needed(name, command))
      throw IoError(verb, folder, "its " + name.string() + " is not there" + kHint);
  check_hdf5_files(folder, summary, verb);
  check_tables(folder, summary, verb);
  return summary;
}

void check_hdf5_files(const fs::path& folder, const Json& summary, const std::string& verb) {
  for (const char* name : {"results.h5", "loads.h5", "map.h5", "sensitivities.h5"}) {
    const fs::path path = folder / name;
    if (!fs::exists(path)) continue;
    std::string wrong;
    try {
      const Hdf5Input file(path);
      if (path.filename() == "results.h5" && summary.value("command", "") != "batch")
        if (const std::string set = missing_set(file, summary); !set.empty())
          wrong = "it has no '" + set + "'";
    } catch (const IoError& error) {
      wrong = error.reason();
    }
    if (!wrong.empty()) throw IoError(verb, path, wrong + kHint);
  }
}

}  // namespace liesl::output
