#pragma once
/// @file
/// What this program was built from.

#include <string>
#include <utility>
#include <vector>

namespace liesl::output {

/// liesl first, then the compiler and every library: (name, version), as found when the build was
/// configured.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace liesl::output
