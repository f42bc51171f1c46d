#pragma once
/// @file
/// Of which types the keys of summary.json are that pages, pictures and exports read.

#include <nlohmann/json.hpp>
#include <string>

namespace liesl::output {

/// The first key whose value is of another type than liesl writes: "'responses.bend.unit' is
/// number"; empty if there is none. Keys that are missing, and those that nothing reads, are none
/// of its business.
std::string wrong_type(const nlohmann::ordered_json& summary);

}  // namespace liesl::output
