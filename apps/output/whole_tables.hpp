#pragma once
/// @file
/// Are the tables (CSV) of a results folder as long as its other files tell?

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace liesl::output {

/// Tables over the records of results.h5 and, of batches and comparisons, over what summary.json
/// says has ended. One that ends within a line is left to its reader, who names the line.
/// @param verb what was asked for: "report"  @throws IoError for one that has fewer rows
void check_tables(const std::filesystem::path& folder, const nlohmann::ordered_json& summary,
                  const std::string& verb);

}  // namespace liesl::output
