#include "apps/cli/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/input/problem.hpp"

namespace liesl {
namespace {

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

}  // namespace

std::string completion(const CLI::App& app, const std::string& shell) {
  if (shell != "bash" && shell != "zsh")
    throw InputError(
        {{"completion", 0, 0, "there is no completion for '" + shell + "'", "bash or zsh", ""}});
  std::vector<std::string> commands;
  std::string cases;
  for (const CLI::App* command : app.get_subcommands({})) {
    commands.push_back(command->get_name());
    cases += fmt::format("    {}) words=\"{}\" ;;\n", commands.back(),
                         fmt::join(options_of(*command), " "));
  }
  std::string text =
      "# liesl completion " + shell + ": source it, or put it where the shell looks.\n";
  if (shell == "zsh") text += "autoload -U +X bashcompinit && bashcompinit\n";
  text += fmt::format(R"(_liesl() {{
  local words word=${{COMP_WORDS[COMP_CWORD]}}
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{} --help --version" -- "$word"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  case $word in
    -*) COMPREPLY=($(compgen -W "$words" -- "$word")) ;;
    *) COMPREPLY=($(compgen -f -- "$word")) ;;
  esac
}}
complete -o filenames -F _liesl liesl
)",
                      fmt::join(commands, " "), cases);
  return text;
}

}  // namespace liesl
