#include "apps/report/report.hpp"

#include <fmt/format.h>

#include "apps/cli/command.hpp"
#include "apps/output/file.hpp"

namespace liesl {

int report_command(const CommandOptions& options) {
  const auto path = report::write_report(options.file);
  if (!options.quiet) fmt::print("{}\n", path.string());
  return 0;
}

void add_report(const std::filesystem::path& folder, const CommandOptions& options) {
  if (options.no_report) return;
  try {
    std::error_code none;
    const auto named = std::filesystem::weakly_canonical(options.out, none);
    output::replace_file(folder / report::kReport,
                         report::page_of(folder, named.filename().string()));
  } catch (const std::exception& error) {
    fmt::print(stderr, "liesl: no {}: {}\n", report::kReport, error.what());
  }
}

}  // namespace liesl
