#pragma once
/// @file
/// Files that a finished task leaves in its folder, beside report.html.

#include <filesystem>
#include <string>

#include "apps/output/hdf5_writer.hpp"
#include "apps/tasks/run.hpp"

#ifdef LIESL_OPTIM
#include "apps/study/study.hpp"
#include "apps/tasks/optimize.hpp"
#endif

namespace liesl {

/// Results, if there are records, and summary.json. @throws output::IoError (both)
/// @param begun what took the series of bodies, of results.h5 in this folder; null: nothing did
void write_run(const std::filesystem::path& folder, const RunOutcome& out,
               output::Hdf5Writer* begun = nullptr);

#ifdef LIESL_OPTIM
/// Of an optimisation: its final motion and limits, the design as table and as scene, its parts,
/// summary.json.
void write_optimization(const std::filesystem::path& folder, const OptimizeOutcome& out,
                        const Study& study);
#endif

}  // namespace liesl
