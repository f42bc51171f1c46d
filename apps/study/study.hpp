#pragma once
/// @file
/// A study as data: a scene and what to vary, to limit and to minimise. Read by load_study.hpp.

#include <string>

#include "apps/scene/scene.hpp"
#include "optim/study/study.hpp"

namespace liesl {

struct Study {
  Scene scene;
  StudySpec spec;
  std::string file;
  std::string input;  ///< text of study and scene and the overrides, for the input's hash
};

}  // namespace liesl
