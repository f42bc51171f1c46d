#pragma once
/// @file
/// Results as one HDF5 file.

#include <filesystem>
#include <string>

#include "apps/output/results.hpp"

namespace liesl::output {

/// Writes everything that is recorded, as data_tree.hpp lays it out. Every data set of numbers has
/// an attribute `unit`. @throws IoError, std::invalid_argument (shapes)
void write_hdf5(const std::filesystem::path& path, const Results& results);

}  // namespace liesl::output
