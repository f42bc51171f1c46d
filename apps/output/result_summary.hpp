#pragma once
/// @file
/// summary.json of a results folder, read back.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace liesl::output {

/// Of a folder that this version of liesl wrote. @param verb what cannot be done without: "report"
/// @throws IoError for a folder that is none, no result, not whole, or of another version
nlohmann::ordered_json read_summary(const std::filesystem::path& folder, const std::string& verb);

/// The same of a folder that has all tables and HDF5 files which liesl wrote in it. @throws IoError
/// also for what is missing: half a result
nlohmann::ordered_json read_whole_summary(const std::filesystem::path& folder,
                                          const std::string& verb);

/// The HDF5 files that are there can be read; results.h5 has times, bodies and the responses of the
/// summary. @throws IoError that names the file
void check_hdf5_files(const std::filesystem::path& folder, const nlohmann::ordered_json& summary,
                      const std::string& verb);

}  // namespace liesl::output
