#include "apps/tasks/lean.hpp"

#include <fmt/format.h>

#include <charconv>

#include "apps/cli/terminal.hpp"
#include "apps/input/document.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/output/file.hpp"
#include "apps/output/interrupt.hpp"

namespace liesl {

namespace {

/// "1%" or "0.01". @throws InputError unless it is in (0, 0.5]
double read_tolerance(std::string text) {
  const std::string given = text;
  const bool percent = text.ends_with('%');
  if (percent) text.pop_back();
  while (text.ends_with(' ')) text.pop_back();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (percent) value /= 100;
  if (whole && value > 0 && value <= 0.5) return value;
  throw InputError(
      {{"--tolerance " + given, 0, 0, whole ? "out of range" : "neither a number nor a percentage",
        "a tolerance in (0, 0.5], relative to the largest response",
        "as in --tolerance 1% or --tolerance 0.01"}});
}

void print_result(const LeanOutcome& out, const std::string& folder) {
  const LeanResult& r = out.result;
  fmt::print("{}: {}\n", to_string(r.status), r.reason);
  if (r.status == LeanStatus::Done)
    fmt::print("  error {:.3g} % (as given {:.3g} %), time {:.3g} s (as given {:.3g} s), {} runs\n",
               100 * r.error, 100 * r.error_given, r.time, r.time_given, r.runs);
  if (has_model(r))
    for (const auto& change : r.changes) fmt::print("  {}\n", change);
  print_responses(out.summary);
  for (const auto& warning : out.summary.warnings) fmt::print("  note: {}\n", warning);
  fmt::print("results in {}", folder);
  if (!out.scene.empty())
    fmt::print("; next: liesl run {} -o DIR", shell_word(folder + "/lean.toml"));
  fmt::print("\n");
}

}  // namespace

int lean_command(const CommandOptions& options) {
  const Stopwatch clock;
  const double tolerance = read_tolerance(options.tolerance);
  const LeanRequest request{load_document(options.file).text,
                            options.file,
                            options.set,
                            options.response,
                            tolerance,
                            !options.no_verify};
  output::AtomicFolder folder(options.out, options.force);
  LeanOutcome out = lean_task(
      request, [](double) { return output::interrupted() == 0; },
      [&](const Decision& d) {
        if (!options.quiet)
          fmt::print("{:<14} {}\n               {}\n", d.about, d.choice, d.evidence);
        std::fflush(stdout);
      });
  if (!out.scene.empty()) output::write_file(folder.path() / "lean.toml", out.scene);
  out.summary.wall_s = clock.seconds();
  output::write_summary(folder.path() / "summary.json", output::to_json(out.summary));
  folder.commit();
  if (!options.quiet) print_result(out, options.out);
  return out.result.status == LeanStatus::Done ? 0 : 1;
}

}  // namespace liesl
