#pragma once
/// @file
/// All files of one simulation at once.

#include <filesystem>

#include "apps/output/hdf5_writer.hpp"
#include "apps/output/results.hpp"

namespace liesl::output {

/// Writes results.h5 and results.xdmf alone, of what has no tables.
/// @throws IoError, std::invalid_argument (shapes)
void write_shown(const std::filesystem::path& folder, const Results& results);

/// Writes results.h5, results.xdmf, responses.csv, energies.csv, joints.csv, frames.csv,
/// sections.csv and part_lines.csv into an existing folder, usually `AtomicFolder::path()`. Tables
/// without columns are left out.
/// @param begun what has the series of bodies already, of results.h5 in this folder; null: nothing
/// @throws IoError, std::invalid_argument (shapes)
void write_results(const std::filesystem::path& folder, const Results& results,
                   Hdf5Writer* begun = nullptr);

}  // namespace liesl::output
