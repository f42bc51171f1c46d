#include "apps/cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/cli/known_words.hpp"
#include "apps/cli/templates.hpp"
#include "apps/input/problem.hpp"

namespace liesl {
namespace {

/// A branch of the shell's `case`: the values of an option, or of the word after the command.
std::string branch(const std::string& command, const std::string& before,
                   const std::vector<std::string>& values) {
  if (values.empty()) return "";
  return fmt::format("    \"{} {}\") values=\"{}\" ;;\n", command, before, fmt::join(values, " "));
}

/// What options and files of a command may be, where only a few words are allowed.
std::string values_of_command(const CLI::App& command) {
  const std::string& name = command.get_name();
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string> values = values_of(*option);
    if (option->get_positional()) text += branch(name, name, values);
    for (const std::string& word : option->get_lnames()) text += branch(name, "--" + word, values);
  }
  return text;
}

/// The shipped files of a kind, which `new --like` takes.
std::vector<std::string> shipped(std::string_view kind) {
  std::vector<std::string> names;
  for (const Template& t : templates())
    if (t.kind == kind) names.emplace_back(t.name);
  return names;
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell) {
  std::string options, values;
  for (const CLI::App* command : app.get_subcommands({})) {
    options += fmt::format("    {}) options=\"{}\" ;;\n", command->get_name(),
                           fmt::join(option_names(*command), " "));
    values += values_of_command(*command);
  }
  for (const char* kind : {"scene", "study"})
    values += branch("new", fmt::format("{} --like", kind), shipped(kind));
  std::string text =
      "# liesl completion " + shell + ": source it, or put it where the shell looks.\n";
  if (shell == "zsh") text += "autoload -U +X bashcompinit && bashcompinit\n";
  text += fmt::format(R"(_liesl() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} options values
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{} --help --version" -- "$word"))
    return
  fi
  # --to=cal is three words: --to, = and cal
  if [ "$word" = "=" ]; then word=""
  elif [ "$before" = "=" ]; then before=${{COMP_WORDS[COMP_CWORD-2]}}; fi
  if [ "${{COMP_WORDS[1]}} $before" = "new --like" ]; then before="${{COMP_WORDS[2]}} --like"; fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case "${{COMP_WORDS[1]}} $before" in
{}  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$options" -- "$word")) ;;
    *) if [ -n "$values" ]; then COMPREPLY=($(compgen -W "$values" -- "$word"))
       else COMPREPLY=($(compgen -f -- "$word")); fi ;;
  esac
}}
complete -o filenames -F _liesl liesl
)",
                      fmt::join(command_names(app), " "), options, values);
  return text;
}

}  // namespace liesl
