#pragma once
/// @file
/// The manual page, written from the commands and their options.

#include <CLI/CLI.hpp>
#include <string>

namespace liesl {

/// Source of liesl(1) in the macros of man(7).
std::string man_page(const CLI::App& app, const std::string& version);

}  // namespace liesl
