#pragma once
/// @file
/// Text of tables whose order means something.

#include <string>

#include "apps/input/problem.hpp"

namespace liesl {

/// "text" and not 'text', as scenes are written.
inline constexpr auto kQuoted =
    toml::toml_formatter::default_flags & ~toml::format_flags::allow_literal_strings;

/// A table as TOML, with keys in the order of the file that they were read from, new ones last by
/// name: bodies, joints and the interfaces of a part are numbered in it. Comments are not kept.
std::string ordered_text(toml::table table);

}  // namespace liesl
