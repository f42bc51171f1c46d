#pragma once
/// @file
/// The height of a connecting rod of few cells in a short motion, within limits of the tests.

#include <filesystem>
#include <string>

#include "apps/scene/space.hpp"
#include "apps/study/load_study.hpp"
#include "optim/cycle/motion_cycle.hpp"
#include "reference/places.hpp"

namespace liesl::test {

/// @param limits tables of them
inline std::string rod_text(const std::string& limits) {
  return R"(scene = "connecting_rod.toml"
[set]
"bodies.rod.solid.mesh.cells" = [40, 8]
"simulation.duration" = 0.034
"simulation.step" = 5e-5
[design]
height = { of = "rod", parameters = ["plate.height", "plate.fillet"], factors = [1, 0.5], bounds = [0.032, 0.044] }
[objective]
of = "rod"
)" + limits;
}

inline Study read_rod(const std::string& text, const std::string& file = "study.toml") {
  return read_study(text, file, std::filesystem::path(kDataDir) / "scenes");
}

inline CycleResult<SE2> optimise(const Study& study) {
  const ChosenSpace space = choose_space(study.scene);
  return run_cycle<SE2>(study.scene.mechanism, std::get<Space<SE2>>(space.space),
                        study.scene.simulation, study.spec);
}

}  // namespace liesl::test
