#include "apps/cli/known_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "apps/input/problem.hpp"

namespace liesl {
namespace {

/// The first word that looks like a long option and is none. What follows "--" is no option.
std::string unknown_option(const CLI::App& command, const std::vector<std::string>& arguments) {
  const std::vector<std::string> known = option_names(command);
  for (const std::string& argument : arguments) {
    if (argument == "--") break;
    const std::string word = argument.substr(0, argument.find('='));
    if (word.starts_with("--") && std::find(known.begin(), known.end(), word) == known.end())
      return word;
  }
  return "";
}

}  // namespace

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

CLI::Validator one_of(const std::vector<std::string>& words) {
  return {[words](const std::string& word) {
            if (std::find(words.begin(), words.end(), word) != words.end()) return std::string();
            return fmt::format("there is no '{}'; {}", word, suggestion(word, words));
          },
          fmt::format("{{{}}}", fmt::join(words, ","))};
}

std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // "TEXT:{peaks,all}"
  const std::size_t begin = type.find(":{");
  std::vector<std::string> words;
  if (begin == std::string::npos || !type.ends_with('}')) return words;
  std::istringstream list(type.substr(begin + 2, type.size() - begin - 3));
  for (std::string word; std::getline(list, word, ',');) words.push_back(word);
  return words;
}

std::string unknown_word(const CLI::App& app, const std::vector<std::string>& arguments) {
  const std::string first = arguments.empty() ? "" : arguments.front();
  const std::vector<std::string> names = command_names(app);
  const bool is_command = std::find(names.begin(), names.end(), first) != names.end();
  if (!is_command && !first.empty() && !first.starts_with('-'))
    return "liesl: there is no command '" + first + "'; " + suggestion(first, names) +
           "\nliesl --help lists the commands\n";
  const std::string whole = is_command ? "liesl " + first : "liesl";
  const CLI::App& asked = is_command ? *app.get_subcommand(first) : app;
  const std::string option = unknown_option(asked, arguments);
  if (option.empty()) return "";
  return fmt::format("{}: there is no option '{}'; {}\n{} --help lists the options\n", whole,
                     option, suggestion(option, option_names(asked)), whole);
}

}  // namespace liesl
