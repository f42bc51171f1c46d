#ifdef LIESL_OPTIM

#include "apps/tasks/cycle_loads.hpp"

#include <map>
#include <variant>

#include "apps/output/csv_writer.hpp"
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

std::string loads_table(const std::vector<LoadsOfCycle>& loads, SimulationType type) {
  const bool dynamic = type == SimulationType::Dynamic;
  std::vector<output::TextColumn> columns = {
      {"cycle", "", {}},
      {"scenario", "", {}},
      {"body", "", {}},
      {dynamic ? "time" : "load_factor", dynamic ? "s" : "-", {}},
      {"node", "", {}}};
  for (const char* name : {"Fx", "Fy", "Fz"}) columns.push_back({name, "N", {}});
  for (const char* name : {"Mx", "My", "Mz"}) columns.push_back({name, "N m", {}});
  for (const char* name : {"x", "y", "z"}) columns.push_back({name, "m", {}});
  for (const LoadsOfCycle& part : loads)
    for (std::size_t n = 0; n < part.kept.times.size(); ++n)
      for (Eigen::Index k = 0; k < part.kept.loads[n].cols(); ++k) {
        columns[0].cells.push_back(std::to_string(part.cycle));
        columns[1].cells.push_back(part.scenario);
        columns[2].cells.push_back(part.body);
        columns[3].cells.push_back(output::cell(part.kept.times[n]));
        columns[4].cells.push_back(std::to_string(k));
        for (Eigen::Index c = 0; c < 6; ++c)
          columns[static_cast<std::size_t>(5 + c)].cells.push_back(
              output::cell(part.kept.loads[n](c, k)));
        for (Eigen::Index c = 0; c < 3; ++c)
          columns[static_cast<std::size_t>(11 + c)].cells.push_back(
              k < part.places.cols() ? output::cell(part.places(c, k)) : "");
      }
  return output::columns_csv(columns);
}

}  // namespace liesl

#endif
