#include "apps/cli/command_line.hpp"

#include <string>
#include <vector>

#include "apps/cli/known_words.hpp"
#include "apps/input/schema.hpp"

namespace liesl {

namespace {

constexpr int kMostThreads = 1024;

struct CommandRow {
  const char *name, *file, *what;
  Command* function;
  bool writes;
};

void add_sensitivity_options(CLI::App& command, CommandOptions& o) {
  command
      .add_option("--by", o.by,
                  "Keys of the scene to differentiate by, as in sections.rod.diameter (a study has "
                  "its variables); KEY+KEY change by the same amount")
      ->delimiter(',');
  command.add_option("--method", o.method, "Form of the sensitivities")
      ->check(one_of({"auto", "direct", "adjoint"}))
      ->default_val("auto");
  command
      .add_option("--functionals", o.functionals,
                  "Of each response: peak, integral, mean, rms, at=TIME, p=P, ks=RHO")
      ->delimiter(',')
      ->default_str("peak,integral,mean,rms");
  auto* check = command.add_flag("--check", o.check,
                                 "Compare the gradients with finite differences and stop");
  command
      .add_flag("--fits", o.fits,
                "With --check: with polynomials fitted to many differences, too, 240 motions a "
                "parameter; they average round-off")
      ->needs(check);
}

void add_map_options(CLI::App& command, CommandOptions& o) {
  command
      .add_option("--over", o.over,
                  "Two variables of the study, over their bounds or a part of them: a,b or "
                  "a=0.005:0.010,b")
      ->delimiter(',')
      ->required();
  command
      .add_option("--of", o.of,
                  "What to map: the objective, limits by name (default: all of the study)")
      ->delimiter(',');
  command.add_option("--points", o.points, "Points along both axes, or along each: 15 or 20,10")
      ->delimiter(',')
      ->default_val(std::vector<int>{15});
  command.add_option("--path", o.path, "Results of liesl optimize, whose path is drawn");
  command
      .add_option("--cycle", o.cycle,
                  "Cycle of the path where the local model is made (default: the final design)")
      ->check(CLI::PositiveNumber);
}

void add_batch_options(CLI::App& command, CommandOptions& o) {
  command.add_option("-j,--jobs", o.jobs, "Cases at once, 0 = as many as processors")
      ->check(CLI::Range(0, 10000));
  command.add_option("--shard", o.shard, "i/n: only every n-th case, from the i-th on")
      ->check([](const std::string& text) {
        return text.empty() ? std::string("expected i/n, as in --shard 3/20") : std::string();
      });
}

void add_export_options(CLI::App& command, CommandOptions& o) {
  command
      .add_option(
          "--to", o.to,
          "xdmf: deformed meshes of a results folder for ParaView; calculix, nastran: a "
          "part of a scene with the static loads of its motion; matrices: stiffness, mass and "
          "nodes of a meshed part")
      ->default_val("xdmf")
      ->check(one_of({"xdmf", "calculix", "nastran", "matrices"}));
  command.add_option("--part", o.part, "Beam or meshed part of the scene");
  command.add_option("--cases", o.cases, "Instants: where the bending is largest, or every record")
      ->default_val("peaks")
      ->check(one_of({"peaks", "all"}));
  command.add_option("--set", o.set, "Change a key of the scene: key.path=value (repeatable)")
      ->allow_extra_args(false);
  command.add_option("-o,--output", o.out, "Folder of the deck (default: SCENE_PART_PROGRAM)");
  command.add_flag("-f,--force", o.force, "Replace an earlier deck");
}

/// Options that one command has, or few.
void add_options(CLI::App& command, const std::string& name, CommandOptions& o) {
  if (name == "run" || name == "optimize") {
    auto* verify =
        command.add_flag("--verify", o.verify,
                         name == "run" ? "Errors of peaks by mesh and step, from finer runs"
                                       : "Errors of limits by mesh and step, from finer runs of "
                                         "the final design (as by default)");
    if (name == "optimize")
      command.add_flag("--no-verify", o.no_verify, "Leave the errors of the limits out")
          ->excludes(verify);
  }
  if (name == "batch")
    command.add_flag("--no-verify", o.no_verify,
                     "Leave the errors of the limits of a study's cases out");
  if (name == "run" || name == "optimize" || name == "batch" || name == "compare")
    command.add_flag("--no-report", o.no_report, "Write no report.html");
  if (name == "optimize") {
    command.add_flag("--resume", o.resume, "Continue an interrupted run in the same folder");
    command.add_flag("--check-derivatives", o.check_derivatives,
                     "Compare the gradients with finite differences and stop");
    command
        .add_option_function<std::string>(
            "--method",
            [&o](const std::string& method) { o.set.push_back("cycle.method=\"" + method + "\""); },
            "How a cycle finds the next design, as cycle.method")
        ->check(one_of({"auto", "esl", "esl1", "full", "direct"}));
    command
        .add_flag("--nucleate{10}", o.nucleate,
                  "Insert new holes where they reduce the objective, --nucleate=N at most N "
                  "(experimental)")
        ->check(CLI::Range(1, 100));
  }
  if (name == "sensitivity") add_sensitivity_options(command, o);
  if (name == "map") add_map_options(command, o);
  if (name == "batch") add_batch_options(command, o);
  if (name == "lean") {
    command.add_option("--response", o.response, "Response of the scene that has to be right")
        ->required();
    command.add_option("--tolerance", o.tolerance, "Error of its largest value: 1% or 0.01")
        ->default_val("1%");
    command.add_flag("--no-verify", o.no_verify,
                     "Leave out the error of the lean model's peak by mesh and step");
  }
  if (name == "export") add_export_options(command, o);
  if (name == "new") {
    command.add_option("--like", o.like, "Name of a shipped scene or study: four_bar, ...");
    command.add_option("-o,--output", o.out, "File to write (default: the same name, here)");
    command.add_flag("-f,--force", o.force, "Replace a file");
  }
  if (name == "plot") {
    auto* x = command.add_option("--x", o.x, "Column of a batch's table, across");
    command.add_option("--y", o.y, "Column of a batch's table, upwards")->needs(x);
    x->needs("--y");
  }
}

/// What a command is of: a file, a folder or, of those that write texts, a kind of file.
void add_file(CLI::App& command, const CommandRow& entry, CommandOptions& o) {
  std::vector<std::string> kinds;
  if (entry.function == new_command) kinds = {"scene", "study"};
  if (entry.function == schema_command)
    for (const FileKind kind : kFileKinds) kinds.emplace_back(name_of(kind));
  auto* file =
      command.add_option(entry.file, o.file, kinds.empty() ? "file or folder" : "kind of file");
  file->required();
  if (!kinds.empty()) file->check(one_of(kinds));
}

}  // namespace

void add_commands(CLI::App& app, CommandOptions& o, Command*& run) {
  static const CommandRow kCommands[] = {
      {"check", "FILE", "Validate a scene, study, batch, comparison or sensitivity", check_command,
       false},
      {"run", "SCENE", "Simulate a scene", run_command, true},
      {"esl", "SCENE", "Simulate and write the equivalent static loads", esl_command, true},
      {"sensitivity", "FILE", "Derivatives of the responses of a motion by parameters",
       sensitivity_command, true},
      {"optimize", "STUDY", "Size parts under the loads of their motion", optimize_command, true},
      {"map", "STUDY", "Objective and limits of a study over two of its variables", map_command,
       true},
      {"batch", "BATCH", "Run many cases of a study or scene, each in a process of its own",
       batch_command, true},
      {"compare", "COMPARISON", "Run a scene under many formalisms, meshes and steps",
       compare_command, true},
      {"lean", "SCENE", "Find the cheapest model of a scene that is good enough", lean_command,
       true},
      {"report", "DIR", "Write report.html, a page to look at what a results folder holds",
       report_command, false},
      {"plot", "DIR", "Draw what a results folder holds", plot_command, false},
      {"export", "FILE",
       "Write the motion of a results folder, or a part of a scene or results "
       "folder with its loads, for another program",
       export_command, false},
      {"new", "KIND", "Write a scene or study that runs, like a shipped one", new_command, false},
      {"schema", "KIND",
       "Print the JSON Schema of a scene, study, batch, comparison or sensitivity", schema_command,
       false},
  };
  for (const auto& entry : kCommands) {
    auto* command = app.add_subcommand(entry.name, entry.what);
    add_file(*command, entry, o);
    command->add_flag("-q,--quiet", o.quiet, "Print nothing but errors");
    const std::string name = entry.name;
    const bool of_file = entry.writes || name == "check";
    if (of_file)
      command->add_option("--set", o.set, "Change a key: key.path=value (repeatable)")
          ->allow_extra_args(false);
    if (entry.writes) {
      command->add_option("-o,--output", o.out,
                          "Folder of the results (default: name of the file)");
      command->add_flag("-f,--force", o.force, "Replace an earlier result");
      command->add_option("--threads", o.threads, "Threads to use, 0 = all processors")
          ->check(CLI::Range(0, kMostThreads));
    }
    add_options(*command, name, o);
    command->callback([&run, &entry] { run = entry.function; });
  }
}
}  // namespace liesl
