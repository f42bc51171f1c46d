#pragma once
/// @file
/// What a shell completes, written from the commands and their options.

#include <CLI/CLI.hpp>
#include <string>

namespace liesl {

/// Script for "bash" or "zsh", to be sourced.
std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace liesl
