#pragma once
/// @file
/// A study as data: a scene and what to vary, to limit and to minimise. Read by load_study.hpp.

#include <string>
#include <vector>

#include "apps/scene/scene.hpp"
#include "optim/study/study.hpp"

namespace liesl {

struct Study {
  Scene scene;                   ///< of the first scenario
  std::vector<Scene> scenarios;  ///< further ones, with the same bodies; names: spec.scenarios
  StudySpec spec;
  std::string file;
  std::string input;  ///< text of study and scene and the overrides, for the input's hash
  /// The same without layout, and without what only says when a run ends: what a run that goes on
  /// has to share with the interrupted one.
  std::string resumable;
  /// Scenes of the scenarios, the first one's first, with all changes, without layout.
  std::vector<std::string> scene_texts;
  /// On finer models from the final design on, until it holds on the converged one, where its
  /// limits are verified (`cycle.refine`).
  bool refine = true;
};

}  // namespace liesl
