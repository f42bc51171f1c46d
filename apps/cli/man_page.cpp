#include "apps/cli/man_page.hpp"

#include <fmt/format.h>

namespace liesl {
namespace {

/// Text in which nothing is a request or an escape of roff.
std::string escaped_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  const bool request = out.starts_with('.') || out.starts_with('\'');
  return request ? "\\&" + out : out;
}

std::string names_of(const CLI::Option& option) {
  std::string out;
  const auto add = [&](const std::string& name) {
    out += (out.empty() ? "\\fB" : ", \\fB") + escaped_text(name) + "\\fR";
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  if (option.get_expected_max() > 0) out += " \\fIVALUE\\fR";
  return out;
}

std::string describe(const CLI::Option& option) {
  std::string out = escaped_text(option.get_description());
  if (!option.get_default_str().empty())
    out += " (default: " + escaped_text(option.get_default_str()) + ")";
  return out;
}

std::string describe(const CLI::App& command) {
  std::string places, options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional())
      places += " \\fI" + escaped_text(option->get_name(true)) + "\\fR";
    else
      options += ".TP\n" + names_of(*option) + "\n" + describe(*option) + "\n";
  }
  return fmt::format(".SS \\fBliesl {}\\fR{}\n{}.\n{}", escaped_text(command.get_name()), places,
                     escaped_text(command.get_description()), options);
}

constexpr const char* kEnd = R"(.SH EXIT STATUS
.TP
0
done
.TP
1
ran, but did not converge, or is infeasible
.TP
2
input refused
.TP
3
a file cannot be read or written, or an internal error
.SH EXAMPLES
.nf
liesl new study \-\-like slider_crank_rod
liesl optimize slider_crank_rod.toml
liesl run slider_crank.toml \-\-set simulation.step=5e\-5 \-o fine
.fi
)";

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(
      ".TH LIESL 1 \"\" \"liesl {}\"\n.SH NAME\nliesl \\- {}\n.SH SYNOPSIS\n"
      ".B liesl\n\\fICOMMAND\\fR [\\fIFILE\\fR] [\\fIOPTIONS\\fR]\n.SH COMMANDS\n",
      escaped_text(version), escaped_text(app.get_description()));
  for (const CLI::App* command : app.get_subcommands({})) text += describe(*command);
  return text + kEnd;
}

}  // namespace liesl
