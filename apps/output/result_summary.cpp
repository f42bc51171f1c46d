#include "apps/output/result_summary.hpp"

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/summary_types.hpp"
#include "apps/output/versions.hpp"

namespace fs = std::filesystem;

namespace liesl::output {

namespace {

using Json = nlohmann::ordered_json;

/// Is a file of numbers one that readers need? Batches and comparisons name files before they are
/// written; they have their tables from the beginning.
bool is_needed(const fs::path& name, const std::string& command) {
  if (command == "batch") return name == "results.csv";
  if (command == "compare") return name == "rows.csv";
  return name.extension() == ".csv" || name.extension() == ".h5";
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
  return summary;
}

nlohmann::ordered_json read_whole_summary(const fs::path& folder, const std::string& verb) {
  Json summary = read_summary(folder, verb);
  const std::string command = summary.value("command", "");
  for (const fs::path name : missing_files(folder))
    if (name == kMark || is_needed(name, command))
      throw IoError(
          verb, folder,
          "its " + name.string() + " is not there; copy the whole folder, or run it again");
  return summary;
}

}  // namespace liesl::output
