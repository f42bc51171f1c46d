#pragma once
/// @file
/// The commands of the program. Each returns the exit code: 0 done, 1 ran but did not converge or
/// is infeasible. Input that is refused throws InputError (2), files that cannot be read or written
/// output::IoError (3).

#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene/space.hpp"

namespace liesl {

struct CommandOptions {
  std::string file;    ///< scene, study or results folder
  std::string out;     ///< -o
  bool force = false;  ///< replace an earlier result
  bool quiet = false;
  bool resume = false;             ///< optimize: resume an interrupted run
  bool check_derivatives = false;  ///< optimize: sweep the gradients of the first static problem
  int nucleate = 0;                ///< optimize: new holes to insert at most
  int threads = 0;                 ///< 0 = as many as there are processors
  std::vector<std::string> set;    ///< key.path=value
  int jobs = 0;                    ///< batch: processes at once, 0 = a processor each
  std::string shard;               ///< batch: "i/n", only every n-th case from the i-th on
  bool verify = false;             ///< run: errors by mesh and step; optimize: refuse to go without
  bool no_verify = false;          ///< optimize, batch, lean: leave them out
  bool no_report = false;          ///< commands that write results: leave report.html out
  std::string x, y;                ///< plot: columns of a batch
  std::string response;            ///< lean: name of a response of the scene
  std::string tolerance;           ///< lean: "1%" or "0.01"
  std::string to;                  ///< export: "xdmf", "calculix", "nastran", "matrices"
  std::string part, cases;         ///< export: body of a scene; "peaks" or "all"
  std::string like;                ///< new: name of a shipped scene or study
  std::vector<std::string> by;     ///< sensitivity: keys of the scene
  std::string method;              ///< sensitivity: "auto", "direct" or "adjoint"
  std::vector<std::string> functionals;  ///< sensitivity: "peak", "p=8", ...
  bool check = false;                    ///< sensitivity: compare with differences and stop
  bool fits = false;                     ///< sensitivity --check: fit polynomials to them, too
  std::vector<std::string> over, of;     ///< map: variables, quantities
  std::vector<int> points;               ///< map: along the axes
  std::string path;                      ///< map: results folder of optimize
  int cycle = 0;                         ///< map: of the path; 0: its last design
};

int check_command(const CommandOptions& options);
int run_command(const CommandOptions& options);
int esl_command(const CommandOptions& options);
int sensitivity_command(const CommandOptions& options);
int optimize_command(const CommandOptions& options);
int map_command(const CommandOptions& options);
int batch_command(const CommandOptions& options);
int compare_command(const CommandOptions& options);
int lean_command(const CommandOptions& options);
int plot_command(const CommandOptions& options);
int report_command(const CommandOptions& options);
int export_command(const CommandOptions& options);
int new_command(const CommandOptions& options);
int schema_command(const CommandOptions& options);

/// The page of results at the end of a command, unless its options leave it out, into the folder
/// that holds them now. A page that cannot be written is a note on the terminal; the results stay.
void add_report(const std::filesystem::path& folder, const CommandOptions& options);

}  // namespace liesl
