/// @file
/// liesl: simulate flexible mechanisms on SE(3), size their parts under the loads of the motion.

#include <malloc.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>

#include "apps/cli/command.hpp"
#include "apps/cli/completion.hpp"
#include "apps/cli/io_message.hpp"
#include "apps/cli/known_words.hpp"
#include "apps/cli/man_page.hpp"
#include "apps/input/problem.hpp"
#include "apps/input/schema.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/memory_limit.hpp"
#include "apps/output/summary.hpp"
#include "apps/output/versions.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace {

constexpr int kRefused = 2, kFailed = 3;
constexpr int kMostThreads = 1024;

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : liesl::output::versions()) text += name + " " + version + "\n";
  text.pop_back();
  return text;
}

struct Entry {
  const char *name, *file, *what;
  int (*function)(const liesl::CommandOptions&);
  bool writes;
};

void add_sensitivity_options(CLI::App& command, liesl::CommandOptions& o) {
  command
      .add_option("--by", o.by,
                  "Keys of the scene to differentiate by, as in sections.rod.diameter (a study has "
                  "its variables); KEY+KEY change by the same amount")
      ->delimiter(',');
  command.add_option("--method", o.method, "Form of the sensitivities")
      ->check(liesl::one_of({"auto", "direct", "adjoint"}))
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

void add_map_options(CLI::App& command, liesl::CommandOptions& o) {
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

void add_batch_options(CLI::App& command, liesl::CommandOptions& o) {
  command.add_option("-j,--jobs", o.jobs, "Cases at once, 0 = as many as processors")
      ->check(CLI::Range(0, 10000));
  command.add_option("--shard", o.shard, "i/n: only every n-th case, from the i-th on")
      ->check([](const std::string& text) {
        return text.empty() ? std::string("expected i/n, as in --shard 3/20") : std::string();
      });
}

void add_export_options(CLI::App& command, liesl::CommandOptions& o) {
  command
      .add_option(
          "--to", o.to,
          "xdmf: deformed meshes of a results folder for ParaView; calculix, nastran: a "
          "part of a scene with the static loads of its motion; matrices: stiffness, mass and "
          "nodes of a meshed part")
      ->default_val("xdmf")
      ->check(liesl::one_of({"xdmf", "calculix", "nastran", "matrices"}));
  command.add_option("--part", o.part, "Beam or meshed part of the scene");
  command.add_option("--cases", o.cases, "Instants: where the bending is largest, or every record")
      ->default_val("peaks")
      ->check(liesl::one_of({"peaks", "all"}));
  command.add_option("--set", o.set, "Change a key of the scene: key.path=value (repeatable)")
      ->allow_extra_args(false);
  command.add_option("-o,--output", o.out, "Folder of the deck (default: SCENE_PART_PROGRAM)");
  command.add_flag("-f,--force", o.force, "Replace an earlier deck");
}

/// Options that one command has, or few.
void add_options(CLI::App& command, const std::string& name, liesl::CommandOptions& o) {
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
        ->check(liesl::one_of({"auto", "esl", "esl1", "full", "direct"}));
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
void add_file(CLI::App& command, const Entry& entry, liesl::CommandOptions& o) {
  std::vector<std::string> kinds;
  if (entry.function == liesl::new_command) kinds = {"scene", "study"};
  if (entry.function == liesl::schema_command)
    for (const liesl::FileKind kind : liesl::kFileKinds) kinds.emplace_back(liesl::name_of(kind));
  auto* file =
      command.add_option(entry.file, o.file, kinds.empty() ? "file or folder" : "kind of file");
  file->required();
  if (!kinds.empty()) file->check(liesl::one_of(kinds));
}

/// The commands with their options; the chosen one is stored in `run`.
void add_commands(CLI::App& app, liesl::CommandOptions& o,
                  int (*&run)(const liesl::CommandOptions&)) {
  static const Entry kEntries[] = {
      {"check", "FILE", "Validate a scene, study, batch, comparison or sensitivity",
       liesl::check_command, false},
      {"run", "SCENE", "Simulate a scene", liesl::run_command, true},
      {"esl", "SCENE", "Simulate and write the equivalent static loads", liesl::esl_command, true},
      {"sensitivity", "FILE", "Derivatives of the responses of a motion by parameters",
       liesl::sensitivity_command, true},
      {"optimize", "STUDY", "Size parts under the loads of their motion", liesl::optimize_command,
       true},
      {"map", "STUDY", "Objective and limits of a study over two of its variables",
       liesl::map_command, true},
      {"batch", "BATCH", "Run many cases of a study or scene, each in a process of its own",
       liesl::batch_command, true},
      {"compare", "COMPARISON", "Run a scene under many formalisms, meshes and steps",
       liesl::compare_command, true},
      {"lean", "SCENE", "Find the cheapest model of a scene that is good enough",
       liesl::lean_command, true},
      {"report", "DIR", "Write report.html, a page to look at what a results folder holds",
       liesl::report_command, false},
      {"plot", "DIR", "Draw what a results folder holds", liesl::plot_command, false},
      {"export", "FILE",
       "Write the motion of a results folder, or a part of a scene or results "
       "folder with its loads, for another program",
       liesl::export_command, false},
      {"new", "KIND", "Write a scene or study that runs, like a shipped one", liesl::new_command,
       false},
      {"schema", "KIND",
       "Print the JSON Schema of a scene, study, batch, comparison or sensitivity",
       liesl::schema_command, false},
  };
  for (const auto& entry : kEntries) {
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

/// What the program is for, for whoever starts it without a command.
constexpr const char* kOverview =
    R"(liesl: flexible mechanisms on SE(3), sized under the loads of their motion.

  liesl new study --like slider_crank_rod    write a study and its scene, to begin with
  liesl optimize slider_crank_rod.toml       size the rod; results and report.html in slider_crank_rod/
  liesl run slider_crank.toml                simulate a scene

)";

/// Does a command write a results folder?
bool writes_folder(int (*run)(const liesl::CommandOptions&)) {
  using namespace liesl;
  for (auto* command : {run_command, esl_command, sensitivity_command, optimize_command,
                        map_command, batch_command, compare_command, lean_command})
    if (run == command) return true;
  return false;
}

void print_overview(const CLI::App& app) {
  std::cout << kOverview << "Commands:\n";
  for (const auto* command : app.get_subcommands({}))
    std::cout << "  " << std::left << std::setw(13) << command->get_name()
              << command->get_description() << "\n";
  std::cout << "\nliesl COMMAND --help lists the options of a command.\n";
}

/// Could a thread not begin because the address space is limited? Its stack takes some.
bool lacks_memory(const std::exception& error) {
  rlimit space{};
  if (::getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return false;
  const std::string_view what = error.what();
  return dynamic_cast<const std::system_error*>(&error) ||
         what.find("pthread_create") != what.npos || what.find("annot allocate") != what.npos;
}

constexpr const char* kOutOfMemory =
    "liesl: out of memory; use fewer elements, a larger step or output_every\n";

int guarded(int (*run)(const liesl::CommandOptions&), const liesl::CommandOptions& o) {
  try {
    return run(o);
  } catch (const liesl::InputError& e) {
    std::cerr << e.what() << "\n";
    return kRefused;
  } catch (const std::invalid_argument& e) {
    std::cerr << o.file << ": " << e.what() << "\n";
    return kRefused;
  } catch (const liesl::output::IoError& e) {
    std::cerr << "liesl: " << liesl::message(e) << "\n";
  } catch (const liesl::Stopped&) {
    std::cerr << "liesl: interrupted\n";
  } catch (const liesl::output::Interrupted&) {
    std::cerr << "liesl: interrupted\n";
  } catch (const std::filesystem::filesystem_error& e) {
    std::cerr << "liesl: cannot use '" << e.path1().string() << "': " << e.code().message() << "\n";
  } catch (const std::bad_alloc&) {
    std::cerr << kOutOfMemory;
  } catch (const std::exception& e) {
    if (lacks_memory(e))
      std::cerr << kOutOfMemory;
    else
      std::cerr << "liesl: internal error: " << e.what() << "\n";
  }
  return kFailed;
}

/// Memory that is freed stays with the process, as much as the C library keeps by itself once it
/// has freed a block of 32 MB: a short run spends much of its time on pages that it gives back and
/// is given again; it is taken 1 MB at a time. Not where the address space is limited.
void keep_freed_memory() {
  if (liesl::output::memory_is_limited()) return;
  constexpr int kOwnPages = 32 << 20;  // bytes of a block that is given back on its own
  ::mallopt(M_MMAP_THRESHOLD, kOwnPages);
  ::mallopt(M_TRIM_THRESHOLD, 2 * kOwnPages);
  ::mallopt(M_TOP_PAD, 1 << 20);
}

/// To the end of the process: where the limit is lifted, TBB starts threads for the work that it
/// has seen, and aborts if memory is short.
void limit_threads(int threads) {
  // Volatile: reachable, and so no leak.
  [[maybe_unused]] static const tbb::global_control* volatile kept = new tbb::global_control(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Flexible mechanisms on SE(3), sized under the loads of their motion.", "liesl");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  liesl::CommandOptions options;
  int (*run)(const liesl::CommandOptions&) = nullptr;
  add_commands(app, options, run);
  std::string shell;
  auto* completes = app.add_subcommand("completion", "Print what bash or zsh completes");
  completes->add_option("SHELL", shell, "bash or zsh")
      ->required()
      ->check(liesl::one_of({"bash", "zsh"}));
  const auto* manual = app.add_subcommand("man", "Print the manual page, as man reads it");
  if (argc == 1) return print_overview(app), 0;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const std::string unknown = liesl::unknown_word(app, {argv + 1, argv + argc});
    if (!unknown.empty()) return std::cerr << unknown, kRefused;
    return app.exit(e) == 0 ? 0 : kRefused;
  }
  if (manual->parsed()) {
    std::cout << liesl::man_page(app, liesl::output::versions().front().second);
    return 0;
  }
  if (!run) {
    std::cout << liesl::completion(app, shell);
    return 0;
  }
  if (options.out.empty() && writes_folder(run))
    options.out = std::filesystem::path(options.file).stem().string();
  liesl::output::set_arguments({argv + 1, argv + argc});
  liesl::output::catch_interrupts();
  liesl::ask_for_stop([] { return liesl::output::interrupted() != 0; });
  if (options.threads > 0) limit_threads(options.threads);
  keep_freed_memory();
  return guarded(run, options);
}
