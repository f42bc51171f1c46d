#pragma once
/// @file
/// A description of the HDF5 file that ParaView opens: XDMF 3, "Xdmf3 Reader S" (checked with
/// ParaView 5.11).

#include <filesystem>
#include <string>

#include "apps/output/results.hpp"

namespace liesl::output {

/// Writes `path` for `hdf5_name`, a file in the same folder that `write_hdf5` wrote of the same
/// results. A temporal collection; each instant holds a grid per body: beams as line cells with
/// strain and section force as cell fields, other bodies as points; rotation and velocity at the
/// nodes. Meshed parts appear deformed, with the fraction of material in each cell. Six-vectors
/// appear as two three-vectors. At most `max_instants` records are listed, evenly spread: ParaView
/// reads the description as a whole.
/// @param mesh_hdf5 file of the deformed meshes; empty: `hdf5_name` @throws IoError
void write_xdmf(const std::filesystem::path& path, const std::string& hdf5_name,
                const Results& results, int max_instants = kShownRecords,
                const std::string& mesh_hdf5 = "");

}  // namespace liesl::output
