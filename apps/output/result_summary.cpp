#include "apps/output/result_summary.hpp"

#include <set>
#include <string_view>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/versions.hpp"

namespace fs = std::filesystem;

namespace liesl::output {

namespace {

using Json = nlohmann::ordered_json;

/// What the keys hold whose type is the same for all commands.
bool has_type(const std::string& key, const Json& value) {
  using Words = std::set<std::string_view>;
  static const Words kTexts = {"command", "name",         "status",      "reason",
                               "space",   "space_reason", "input",       "shard",
                               "norm",    "unit",         "input_sha256"},
                     kNumbers = {"steps",
                                 "newton_iterations",
                                 "stepping_s",
                                 "wall_s",
                                 "cpu_s",
                                 "peak_memory_mb",
                                 "cycles",
                                 "mass_initial",
                                 "mass_final",
                                 "cases",
                                 "rows",
                                 "done",
                                 "failed",
                                 "jobs",
                                 "worst_constraint",
                                 "kkt_residual",
                                 "load_change",
                                 "tolerance"},
                     kLists = {"warnings",   "overrides", "arguments", "history",
                               "references", "ratios",    "decisions", "frequencies_hz"},
                     kObjects = {"constraints", "design", "design_range",   "objective",
                                 "prices",      "parts",  "factorizations", "input_units"};
  if (kTexts.contains(key)) return value.is_string();
  if (kNumbers.contains(key)) return value.is_number() || value.is_null();
  if (kLists.contains(key)) return value.is_array();
  return !kObjects.contains(key) || value.is_object();
}

}  // namespace

nlohmann::ordered_json read_summary(const fs::path& folder, const std::string& verb) {
  const fs::path path = folder / "summary.json";
  if (!fs::is_directory(folder))
    throw IoError(verb, folder,
                  fs::exists(folder) ? "it is a file; name the folder of a result"
                                     : "there is no such folder");
  if (!fs::exists(path))
    throw IoError(verb, folder, "it holds no result of liesl (no summary.json)");
  Json summary = Json::parse(read_file(path), nullptr, false);
  if (!summary.is_object() || !summary.contains("versions") || !summary["versions"].is_object() ||
      !summary["versions"].contains("liesl"))
    throw IoError(verb, path, "it is not of liesl, or not whole");
  const Json& version = summary["versions"]["liesl"];
  if (version != versions().front().second)
    throw IoError(verb, path, "it is of liesl " + version.dump() + "; run it again");
  for (const auto& [key, value] : summary.items())
    if (!has_type(key, value))
      throw IoError(verb, path,
                    "its '" + key + "' is " + value.type_name() + ", not what liesl writes");
  return summary;
}

}  // namespace liesl::output
