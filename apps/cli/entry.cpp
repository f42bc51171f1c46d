#include "apps/cli/entry.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>

#include "apps/cli/command_line.hpp"
#include "apps/cli/completion.hpp"
#include "apps/cli/io_message.hpp"
#include "apps/cli/known_words.hpp"
#include "apps/cli/man_page.hpp"
#include "apps/input/problem.hpp"
#include "apps/output/interrupt.hpp"
#include "apps/output/memory_limit.hpp"
#include "apps/output/summary.hpp"
#include "apps/output/versions.hpp"
#include "mbs/linalg/stop_request.hpp"

namespace liesl {

namespace {

constexpr int kRefused = 2, kFailed = 3;

std::string version_text() {
  std::string text;
  for (const auto& [name, version] : output::versions()) text += name + " " + version + "\n";
  text.pop_back();
  return text;
}
/// What the program is for, for whoever starts it without a command.
constexpr const char* kOverview =
    R"(liesl: flexible mechanisms on SE(3), sized under the loads of their motion.

  liesl new study --like slider_crank_rod    write a study and its scene, to begin with
  liesl optimize slider_crank_rod.toml       size the rod; results and report.html in slider_crank_rod/
  liesl run slider_crank.toml                simulate a scene

)";

/// Does a command write a results folder?
bool writes_folder(Command* run) {
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

int guarded(Command* run, const CommandOptions& o) {
  try {
    return run(o);
  } catch (const InputError& e) {
    std::cerr << e.what() << "\n";
    return kRefused;
  } catch (const std::invalid_argument& e) {
    std::cerr << o.file << ": " << e.what() << "\n";
    return kRefused;
  } catch (const output::IoError& e) {
    std::cerr << "liesl: " << message(e) << "\n";
  } catch (const Stopped&) {
    std::cerr << "liesl: interrupted\n";
  } catch (const output::Interrupted&) {
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
  if (output::memory_is_limited()) return;
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

int run_program(int argc, char** argv) {
  CLI::App app("Flexible mechanisms on SE(3), sized under the loads of their motion.", "liesl");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  CommandOptions options;
  Command* run = nullptr;
  add_commands(app, options, run);
  std::string shell;
  auto* completes = app.add_subcommand("completion", "Print what bash or zsh completes");
  completes->add_option("SHELL", shell, "bash or zsh")->required()->check(one_of({"bash", "zsh"}));
  const auto* manual = app.add_subcommand("man", "Print the manual page, as man reads it");
  if (argc == 1) return print_overview(app), 0;
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    const std::string unknown = unknown_word(app, {argv + 1, argv + argc});
    if (!unknown.empty()) return std::cerr << unknown, kRefused;
    return app.exit(e) == 0 ? 0 : kRefused;
  }
  if (manual->parsed()) {
    std::cout << man_page(app, output::versions().front().second);
    return 0;
  }
  if (!run) {
    std::cout << completion(app, shell);
    return 0;
  }
  if (options.out.empty() && writes_folder(run))
    options.out = std::filesystem::path(options.file).stem().string();
  output::set_arguments({argv + 1, argv + argc});
  output::catch_interrupts();
  ask_for_stop([] { return output::interrupted() != 0; });
  if (options.threads > 0) limit_threads(options.threads);
  keep_freed_memory();
  return guarded(run, options);
}

}  // namespace liesl
