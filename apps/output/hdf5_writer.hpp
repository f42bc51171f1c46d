#pragma once
/// @file
/// Results as one HDF5 file.

#include <filesystem>
#include <string>

#include "apps/output/results.hpp"

namespace liesl::output {

/// Writes everything that is recorded; layout in docs/outputs.md:
///   /time [n]                      attributes of the root: program, scene, space, abscissa
///   /bodies/<name>/{position [n,N,3], rotation [n,N,9], velocity [n,N,6], elements [E,2],
///                   strain [n,E,6], section_force [n,E,12],
///                   node_force [n,N,6]}                             attribute kind
///   /joints/<name>/{coordinate [n,K], force [n,6]}                  attribute type
///   /energies/{kinetic, elastic, potential, dissipated, total} [n]
///   /constraint_residual [n]
///   /responses/<name> [n,C]
/// Every data set has an attribute `unit`. @throws IoError, std::invalid_argument (shapes)
void write_hdf5(const std::filesystem::path& path, const Results& results);

/// The name as a link of HDF5: a slash, which would be a group, becomes an underscore.
std::string hdf5_name(std::string name);

}  // namespace liesl::output
