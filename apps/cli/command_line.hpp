#pragma once
/// @file
/// The command line: commands, what they are of, and their options.

#include <CLI/CLI.hpp>

#include "apps/cli/command.hpp"

namespace liesl {

using Command = int(const CommandOptions&);

/// The commands with their options; what is parsed goes to `options`, the chosen command to `run`.
/// Both and `app` have to live until it is parsed.
void add_commands(CLI::App& app, CommandOptions& options, Command*& run);

}  // namespace liesl
