#ifdef LIESL_OPTIM

#include "apps/tasks/cycle_loads.hpp"

#include <map>
#include <variant>

#include "esl/load_patches.hpp"

namespace liesl {
namespace {

/// Interfaces, then patches; empty of a beam.
Eigen::Matrix3Xd places_of(const BodySpec& body) {
  const auto* spec = std::get_if<SolidSpec>(&body.kind);
  if (!spec) return {3, 0};
  const Eigen::Matrix3Xd patches = load_patches(*spec->model).places;
  Eigen::Matrix3Xd places(3, spec->model->ports() + patches.cols());
  for (int k = 0; k < spec->model->ports(); ++k)
    places.col(k) = spec->model->interfaces()[static_cast<std::size_t>(k)].point;
  places.rightCols(patches.cols()) = patches;
  return places;
}

}  // namespace

std::vector<LoadsOfCycle> loads_of_cycles(const RoundHistory& rounds, const Study& study) {
  std::vector<LoadsOfCycle> out;
  std::map<int, Eigen::Matrix3Xd> places;  // by body: of its mesh, the same in all cycles
  int number = 0;
  for (const auto& round : rounds)
    for (const Cycle& cycle : round) {
      ++number;
      for (const CycleLoads& part : cycle.loads) {
        const auto scenario = static_cast<std::size_t>(part.scenario);
        const auto& body = study.scene.mechanism.bodies[static_cast<std::size_t>(part.body)];
        if (places.count(part.body) == 0) places[part.body] = places_of(body);
        out.push_back({number, body.name,
                       study.spec.scenarios.empty() ? "" : study.spec.scenarios[scenario], part,
                       places[part.body]});
      }
    }
  return out;
}

std::vector<LoadsOfCycle> joined_loads(std::vector<LoadsOfCycle> before,
                                       std::vector<LoadsOfCycle> now, std::size_t cycles_before) {
  for (LoadsOfCycle& part : now) {
    part.cycle += static_cast<int>(cycles_before);
    before.push_back(std::move(part));
  }
  return before;
}

}  // namespace liesl

#endif
