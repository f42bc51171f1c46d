#include "apps/cli/terminal.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "apps/output/interrupt.hpp"

namespace liesl {

namespace {

constexpr std::size_t kMostModes = 20;  // on the terminal

void print_frequencies(const output::RunSummary& summary) {
  if (!summary.more.contains("frequencies_hz")) return;
  const auto& list = summary.more["frequencies_hz"];
  for (std::size_t i = 0; i < list.size() && i < kMostModes; ++i) {
    const double omega2 = summary.more["eigenvalues"][i];
    fmt::print("  mode {:<11} {:.6g} Hz{}\n", i + 1, list[i].get<double>(),
               omega2 < 0
                   ? fmt::format(", unstable: grows by e in {:.3g} s", 1 / std::sqrt(-omega2))
                   : "");
  }
  if (list.size() > kMostModes) fmt::print("  {} more in summary.json\n", list.size() - kMostModes);
}

/// What the errors of a verified run leave out: a mesh or a step, where there is one, whose error
/// is not known, beams and parts.
std::vector<std::string> left_out(const output::RunSummary& summary, std::optional<double> mesh,
                                  std::optional<double> step) {
  const auto& verified = summary.more["verification"];
  std::vector<std::string> what;
  if (!mesh && verified.contains("mesh")) what.push_back("step alone");
  if (!step && verified.contains("step")) what.push_back("mesh alone");
  if (mesh && verified["mesh"].contains("left_out"))
    what.push_back(
        fmt::format("without {}",
                    fmt::join(verified["mesh"]["left_out"].get<std::vector<std::string>>(), ", ")));
  return what;
}

/// " +- 2.3e-05" of what was verified. @param total both with their signs, or as vectors, where
/// that is known
std::string plus_minus(const output::RunSummary& summary, std::optional<double> mesh,
                       std::optional<double> step, std::optional<double> total = {}) {
  if (!mesh && !step) return "";
  const auto without = left_out(summary, mesh, step);
  return fmt::format(" +- {:.2g}{}", total.value_or(mesh.value_or(0) + step.value_or(0)),
                     without.empty() ? "" : fmt::format(" ({})", fmt::join(without, ", ")));
}

}  // namespace

SimulationLine::SimulationLine(const SimulationOptions& o, bool quiet)
    : line_("simulating", o.type == SimulationType::Dynamic ? o.duration : o.max_load,
            o.type == SimulationType::Dynamic ? "s" : "load",
            quiet || o.type == SimulationType::Modes) {}

bool SimulationLine::operator()(double t) {
  line_.update(t);
  return output::interrupted() == 0;
}

std::string signed_percent(double share) {
  if (!std::isfinite(share)) return "-";
  const double x = 100 * share, size = std::abs(x);
  if (size < 5e-4) return "0 %";
  return fmt::format("{:+.{}f} %", x, size >= 10 ? 0 : size >= 1 ? 1 : size >= 0.1 ? 2 : 3);
}

std::string size_percent(double share) {
  const std::string text = signed_percent(share);
  return text.starts_with('+') ? text.substr(1) : text;
}

std::string shell_word(const std::string& text) {
  const auto plain = [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) ||
           std::string_view("_-./+=:,@%").find(char(c)) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

void print_folder(const std::string& folder, const std::string& axes) {
  const std::string word = shell_word(folder);
  if (std::filesystem::exists(std::filesystem::path(folder) / "report.html"))
    fmt::print("results in {}; look at {}/report.html, or: liesl plot {}{}\n", folder, folder, word,
               axes);
  else
    fmt::print("results in {}; next: liesl plot {}{}\n", folder, word, axes);
}

void print_responses(const output::RunSummary& summary) {
  for (const auto& r : summary.responses)
    if (!r.final.empty())
      fmt::print("  {:<16} largest {:.6g}{} {} at {:.6g}, at the end {}{}\n", r.name, r.max_abs,
                 plus_minus(summary, r.error_mesh, r.error_step, r.error_total), r.unit, r.at_time,
                 r.final.size() == 1 ? fmt::format("{:.6g}", r.final[0])
                                     : fmt::format("({:.6g})", fmt::join(r.final, ", ")),
                 plus_minus(summary, r.end_error_mesh, r.end_error_step, r.end_error_total));
}

void print_figures(const output::RunSummary& summary, const std::string& folder, bool quiet) {
  if (quiet) return;
  fmt::print("{}: {} ({}), {} steps, {} corrections, {:.3g} s stepping, {}\n", summary.name,
             summary.status, summary.reason, summary.steps, summary.newton_iterations,
             summary.stepping_s, summary.space);
  print_frequencies(summary);
  print_responses(summary);
  for (const auto& w : summary.warnings)
    if (w != summary.reason) fmt::print("  note: {}\n", w);
  if (!folder.empty()) print_folder(folder);
}

}  // namespace liesl
