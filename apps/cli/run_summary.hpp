#pragma once
/// @file
/// What the commands have in common: a simulation with progress, and its summary.

#include <chrono>

#include "apps/cli/collect.hpp"
#include "apps/cli/command.hpp"
#include "apps/output/progress.hpp"
#include "apps/output/summary.hpp"
#include "mbs/solvers/simulation.hpp"

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

/// A progress function that feeds the live line and stops on Ctrl-C.
Progress watch(output::Progress& line);

/// Status, space, counts and responses of a simulation.
void describe(output::RunSummary& summary, const Scene& scene, const ChosenSpace& space);
void describe(output::RunSummary& summary, const Report& report, const InitialState& start,
              const Mechanism& mechanism);
void describe_responses(output::RunSummary& summary, const output::Results& results);
/// A warning if the integrator lost or made more energy than a few per cent.
void describe_energy(output::RunSummary& summary, const output::Results& results);

/// "done" for a converged run, else the status.
std::string status_word(SolveStatus status);

/// Exit code of a run.
inline int exit_code(SolveStatus status) { return status == SolveStatus::Converged ? 0 : 1; }

/// The lines that a run ends with on the terminal.
void print_figures(const output::RunSummary& summary, const std::string& folder, bool quiet);

}  // namespace liesl
