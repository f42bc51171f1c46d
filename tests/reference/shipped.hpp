#pragma once
/// @file
/// Shipped scenes and studies, simulated: what the tests of loads and sizing work on.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/study/study.hpp"
#include "mbs/solvers/simulation.hpp"
#include "reference/places.hpp"

namespace liesl::test {

using Changes = std::vector<std::string>;  ///< key.path=value

inline Scene shipped_scene(const std::string& name, const Changes& changes = {}) {
  return load_scene(std::filesystem::path(kDataDir) / "scenes" / (name + ".toml"), changes);
}

inline Study shipped_study(const std::string& name, const Changes& changes = {}) {
  return load_study(std::filesystem::path(kDataDir) / "studies" / (name + ".toml"), changes);
}

/// Of data/stability, where methods fail.
inline Study stability_study(const std::string& name, const Changes& changes = {}) {
  const auto folder = std::filesystem::path(kDataDir) / "stability" / "studies";
  return load_study(folder / (name + ".toml"), changes);
}

template <FrameGroup G>
Space<G> space_of(const Mechanism& mechanism) {
  if constexpr (G::dim == 3)
    return find_plane(mechanism).plane.value();
  else
    return {};
}

/// A mechanism and its motion.
template <FrameGroup G>
struct Motion {
  Mechanism mechanism;
  Model<G> model;
  Simulation<G> simulation;

  Motion(const Mechanism& m, const SimulationOptions& options)
      : mechanism(m),
        model(Model<G>::build(mechanism, space_of<G>(mechanism))),
        simulation(run_simulation(model, options)) {}
  bool good() const { return simulation.report.status == SolveStatus::Converged; }
  const Trajectory<G>& trajectory() const { return simulation.trajectory; }
};

}  // namespace liesl::test
