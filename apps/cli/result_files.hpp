#pragma once
/// @file
/// Files that a finished task leaves in its folder, beside report.html.

#include <filesystem>
#include <string>

#include "apps/tasks/run.hpp"

#ifdef LIESL_OPTIM
#include "apps/study/study.hpp"
#include "apps/tasks/optimize.hpp"
#endif

namespace liesl {

/// Results, if there are records, and summary.json. @throws output::IoError (both)
void write_run(const std::filesystem::path& folder, const RunOutcome& out);

#ifdef LIESL_OPTIM
/// Of an optimisation: its final motion and limits, the design as table and as scene, its parts,
/// summary.json.
void write_optimization(const std::filesystem::path& folder, const OptimizeOutcome& out,
                        const Study& study);
#endif

}  // namespace liesl
