#pragma once
/// @file
/// The motions of a study, one a scenario, on one group.

#include "apps/input/problem.hpp"
#include "apps/scene/space.hpp"
#include "apps/study/study.hpp"
#include "optim/cycle/motion_model.hpp"

namespace liesl {

/// @throws InputError if some scenarios are planar and others are not
template <FrameGroup G>
std::vector<Scenario<G>> motions_of(const Study& study, const Space<G>& space) {
  std::vector<Scenario<G>> out{{study.scene.mechanism, space, study.scene.simulation}};
  for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
    const Scene& scene = study.scenarios[s];
    const ChosenSpace chosen = choose_space(scene);
    if (!std::holds_alternative<Space<G>>(chosen.space))
      throw InputError(
          {{study.file, 0, 0,
            "scenario '" + study.spec.scenarios[s + 1] + "' is " + chosen.name +
                ", the first one is not",
            "all scenarios planar, or all spatial", "simulation.space = \"spatial\""}});
    out.push_back({scene.mechanism, std::get<Space<G>>(chosen.space), scene.simulation});
  }
  return out;
}

}  // namespace liesl
