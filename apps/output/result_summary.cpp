#include "apps/output/result_summary.hpp"

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/summary_types.hpp"
#include "apps/output/versions.hpp"

namespace fs = std::filesystem;

namespace liesl::output {

namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace liesl::output
