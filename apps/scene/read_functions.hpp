#pragma once
/// @file
/// The two ways to write a function of time that drives share with other functions.

#include <string>

#include "apps/scene/reader.hpp"

namespace liesl {

/// Expression of t; a parse error is reported at the string.
TimeFunction read_expression(Reader& reader, const toml::node& node);

/// "linear", "cubic" or "quintic".
TimeFunction::Interpolation interpolation_named(const std::string& name);

/// Rows [t, f]; t that does not increase is reported at its row.
TimeFunction read_table(Reader& reader, const toml::node& node, const std::string& interpolation);

}  // namespace liesl
