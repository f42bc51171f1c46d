#pragma once
/// @file
/// A TOML table against the schema.

#include <set>
#include <string>

#include "apps/input/problem.hpp"
#include "apps/input/schema.hpp"

namespace liesl {

/// Tables that have a problem, as "bodies.rod"; they are not read further, so that one mistake is
/// reported once.
using Broken = std::set<std::string>;

/// Checks a whole file: unknown, missing and superfluous keys, types, finite numbers, ranges,
/// options. Puts the defaults of missing keys into the table. Does not stop at the first problem.
Broken validate(toml::table& root, FileKind kind, Problems& problems);

}  // namespace liesl
