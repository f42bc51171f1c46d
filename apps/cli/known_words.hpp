#pragma once
/// @file
/// Words of the command line that are known: commands, options, values.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace liesl {

std::vector<std::string> command_names(const CLI::App& app);

/// "--force", "-f", ... of a command, or of the program.
std::vector<std::string> option_names(const CLI::App& command);

/// An option is one of some words; other words are refused with the nearest of them.
CLI::Validator one_of(const std::vector<std::string>& words);

/// The words that `one_of` gave an option; none if it takes others, too.
std::vector<std::string> values_of(const CLI::Option& option);

/// "there is no command 'runn'; did you mean 'run'?", or so of an option; empty if the command line
/// is wrong in another way.
std::string unknown_word(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace liesl
