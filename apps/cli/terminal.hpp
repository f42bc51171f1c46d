#pragma once
/// @file
/// What the commands share on the terminal: a live line, wall time, the figures of a run.

#include <chrono>
#include <string>

#include "apps/cli/command.hpp"
#include "apps/output/progress.hpp"
#include "apps/output/summary.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// Wall time since it was made, s.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// The live line of a simulation; none for natural frequencies.
class SimulationLine {
 public:
  SimulationLine(const SimulationOptions& options, bool quiet);
  /// Feeds the line; false stops the simulation (Ctrl-C).
  bool operator()(double t);
  void clear() { line_.clear(); }

 private:
  output::Progress line_;
};

/// "+26 %", "-0.43 %", "0 %": three digits of a share at most, none where they mean nothing; "-"
/// for what is no number.
std::string signed_percent(double share);
/// "26 %", of a share that has no sign.
std::string size_percent(double share);

/// A word of a command line as a shell reads it back: in quotes where it holds more than letters,
/// digits and _-./+=:,@%.
std::string shell_word(const std::string& text);

/// Where the results are, and how to look at them.
/// @param axes what `liesl plot` asks for besides, " --x speed --y mass_final"
void print_folder(const std::string& folder, const std::string& axes = "");

/// Largest values and those at the end, with their errors where they are known, a line each.
void print_responses(const output::RunSummary& summary);

/// The lines that a run ends with on the terminal.
void print_figures(const output::RunSummary& summary, const std::string& folder, bool quiet);

}  // namespace liesl
