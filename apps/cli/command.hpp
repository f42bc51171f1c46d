#pragma once
/// @file
/// The commands of the program. Each returns the exit code: 0 done, 1 ran but did not converge or
/// is infeasible. Input that is refused throws InputError (2), files that cannot be read or written
/// output::IoError (3).

#include <string>
#include <variant>
#include <vector>

#include "apps/scene/scene.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

struct CommandOptions {
  std::string file;    ///< scene, study or results folder
  std::string out;     ///< -o
  bool force = false;  ///< replace an earlier result
  bool quiet = false;
  bool resume = false;             ///< optimize: go on with an interrupted run
  bool check_derivatives = false;  ///< optimize: sweep the gradients of the first static problem
  int threads = 0;                 ///< 0 = as many as there are processors
  std::vector<std::string> set;    ///< key.path=value
  int jobs = 0;                    ///< batch: processes at once, 0 = a processor each
  std::string shard;               ///< batch: "i/n", only every n-th case from the i-th on
  std::string x, y;                ///< plot: columns of a batch
};

int check_command(const CommandOptions& options);
int run_command(const CommandOptions& options);
int esl_command(const CommandOptions& options);
int optimize_command(const CommandOptions& options);
int batch_command(const CommandOptions& options);
int compare_command(const CommandOptions& options);
int plot_command(const CommandOptions& options);

/// Where a scene is computed, and why.
struct ChosenSpace {
  std::variant<Space<SE2>, Space<SE3>> space;
  std::string name;  ///< "planar" or "spatial"
  std::string reason;
};
/// @throws InputError if the scene asks for "planar" and leaves the plane
ChosenSpace choose_space(const Scene& scene);

}  // namespace liesl
