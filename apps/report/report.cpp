#include "apps/report/report.hpp"

#include <algorithm>
#include <future>

#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/memory_limit.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/result_summary.hpp"
#include "apps/report/loads.hpp"
#include "apps/report/motion.hpp"
#include "apps/report/page.hpp"
#include "apps/report/series.hpp"

namespace fs = std::filesystem;

namespace liesl::report {
namespace {

/// Cases of a batch that have a page of their own.
Json reported_cases(const fs::path& folder) {
  Json names = Json::array();
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder / "cases", none))
    if (fs::exists(entry.path() / kReport)) names.push_back(entry.path().filename().string());
  return names;
}

/// The page of a batch whose case a folder is.
fs::path page_of_batch(const fs::path& folder) {
  std::error_code none;
  return fs::weakly_canonical(folder, none).parent_path().parent_path() / kReport;
}

/// Name of the batch that a folder is a case of, or null.
Json batch_of(const fs::path& folder) {
  std::error_code none;
  const fs::path cases = fs::weakly_canonical(folder, none).parent_path();
  const fs::path plan = cases.parent_path() / "batch.json";
  if (cases.filename() != "cases" || !fs::exists(plan)) return nullptr;
  const Json json = Json::parse(output::read_file(plan), nullptr, false);
  return json.is_object() ? json.value("name", Json("batch")) : Json("batch");
}

/// Bytes that a motion may take beside all else, in a page of 1 MB.
double room(const Json& data, const Blob& blob) {
  constexpr double kTexts = 320e3;  // characters beside the page's program, numbers in base64
  const auto json = data.dump(-1, ' ', true, Json::error_handler_t::replace).size();
  return 0.75 * (kTexts - static_cast<double>(json)) - static_cast<double>(blob.bytes());
}

/// The motion of a run, opened beside other work; none of a batch.
std::future<output::Hdf5Input> results_in(const fs::path& folder, const Json& summary) {
  const fs::path file = folder / "results.h5";
  if (!fs::exists(file) || summary.value("command", "") == "batch") return {};
  return std::async(output::beside(), [file] { return output::Hdf5Input(file); });
}

/// @param batch that the page leads back to, or null
std::string page_in(const fs::path& folder, const std::string& name, const Json& batch) {
  Blob blob;
  const Json summary = output::read_summary(folder, "report");
  Json data = {{"folder", name}, {"summary", summary}, {"batch", batch}};
  try {
    auto results = results_in(folder, summary);
    data["charts"] = charts(folder, summary, blob);
    data["sized"] = sized_elements(folder);
    data["outlines"] = outlines(folder, blob);
    data["loads"] = cycle_loads(folder, blob);
    for (const char* table : {"map", "path"})
      if (const fs::path file = folder / (std::string(table) + ".csv"); fs::exists(file))
        data[table] = cases(file);
    for (const char* table : {"results.csv", "rows.csv"})
      if (fs::exists(folder / table))
        data["cases"] = cases(folder / table, summary.value("done", std::size_t{0}));
    if (fs::exists(folder / "cases")) data["reported"] = reported_cases(folder);
    if (results.valid())
      data["motion"] = motion(results.get(), opening(summary), room(data, blob), blob);
  } catch (const Json::exception& error) {
    throw output::IoError("report", folder / "summary.json", error.what());
  } catch (const std::out_of_range&) {
    throw output::IoError("report", folder, "its files do not fit each other; run it again");
  }
  return page(data, blob.base64());
}

}  // namespace

std::string page_of(const fs::path& folder, const std::string& name) {
  return page_in(folder, name, batch_of(folder));
}

std::string page_of_whole(const fs::path& folder, const std::string& name) {
  output::read_whole_summary(folder, "report");
  return page_in(folder, name, nullptr);
}

fs::path write_report(const fs::path& folder) {
  if (fs::exists(folder / kReport)) {
    const auto foreign = output::foreign_files(folder);
    if (std::find(foreign.begin(), foreign.end(), kReport) != foreign.end())
      throw output::IoError("replace", folder / kReport,
                            "liesl did not write it; move it elsewhere");
  }
  std::error_code none;
  const fs::path named = fs::weakly_canonical(folder, none);
  output::read_whole_summary(folder, "report");
  const Json batch = fs::exists(page_of_batch(folder)) ? batch_of(folder) : Json();
  const std::string text = page_in(folder, named.filename().string(), batch);
  output::replace_file(folder / kReport, text);
  output::mark_files(folder, {kReport});
  return folder / kReport;
}

}  // namespace liesl::report
