#pragma once
/// @file
/// What people and programs read of an Identity.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "esl/load_set.hpp"

namespace liesl {

/// `identity` of one part in `summary.json`. A difference that no solution gives is null, and a
/// warning names the part.
nlohmann::ordered_json describe_identity(const Identity& identity, const std::string& part,
                                         std::vector<std::string>& warnings);

/// A difference as text: "1.2e-10", or "no solution" where the static problem was not solved.
std::string difference_text(double difference);

}  // namespace liesl
