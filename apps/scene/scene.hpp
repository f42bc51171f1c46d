#pragma once
/// @file
/// A scene as data: a mechanism, what to compute and what to report. Read by load_scene.hpp.

#include <string>
#include <vector>

#include "mbs/model/mechanism.hpp"
#include "mbs/model/response.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// A file that a scene names: a mesh, matrices.
struct NamedInput {
  std::string path;    ///< as the scene names it, from where the program runs
  std::string sha256;  ///< of its bytes
};

struct Scene {
  Mechanism mechanism;
  SimulationOptions simulation;
  std::vector<ResponseSpec> responses;
  std::vector<std::string> warnings;    ///< what is accepted but looks like a mistake
  std::vector<std::string> unfollowed;  ///< of these, drives that change within a step
  std::string file;                     ///< where it was read
  std::string input;                    ///< the file's text and the overrides, for the input's hash
  std::vector<NamedInput> files;        ///< that it names; their texts are in `input`, too
};

}  // namespace liesl
