#pragma once
/// @file
/// Runs of one scene with other keys, and how far their responses are apart.

#include <map>
#include <string>
#include <vector>

#include "apps/output/series.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/solvers/dynamics.hpp"

namespace liesl {

/// How one run went.
struct Trial {
  bool ok = false;
  std::string reason;  ///< if not: why
  std::string space;   ///< "planar" or "spatial"
  std::string space_reason;
  output::Series series;
  double cpu_s = 0;  ///< processor time of the simulation alone
  long corrections = 0;
  long factorizations = 0;
  long rejected = 0;  ///< steps that were tried again with half their length
};

/// A scene, a response of it, and the runs made so far.
class Trials {
 public:
  /// Why the whole run of a scene cannot be relied on, be its response as it may; empty: it can.
  using Fault = std::function<std::string(const Scene&)>;

  /// @param overrides of the user, for all runs  @param fault null: none has one
  /// @throws InputError as read_scene
  Trials(std::string text, std::string file, std::vector<std::string> overrides,
         std::string response, Progress progress, Fault fault = {});

  /// Runs the scene with changes "key.path=value"; the same changes are not run twice.
  /// A scene that is refused or does not reach its end is a trial that is not ok.
  /// @throws output::Interrupted if the progress function asks to stop
  const Trial& run(const std::vector<std::string>& changes);
  /// Medians of the processor time of further runs of two models, s; in turns, so that a machine
  /// that is busy for a while is so for both.
  struct Times {
    double first, second;
  };
  Times times(const std::vector<std::string>& first, const std::vector<std::string>& second);
  /// Of the scene with changes, which runs.
  std::string fault(const std::vector<std::string>& changes);
  /// The scene with changes. @throws InputError
  Scene scene(const std::vector<std::string>& changes) const;
  int runs() const { return runs_; }

 private:
  Trial simulate(const std::vector<std::string>& changes);

  std::string text_, file_, response_;
  std::vector<std::string> overrides_;
  Progress progress_;
  Fault fault_;
  std::map<std::vector<std::string>, Trial> known_;
  int runs_ = 0;
};

}  // namespace liesl
