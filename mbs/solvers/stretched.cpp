#include "mbs/solvers/stretched.hpp"

namespace liesl {

SimulationOptions stretched(SimulationOptions options, double factor) {
  options.duration *= factor;
  options.step *= factor;
  options.step_min *= factor;
  return options;
}

Mechanism stretched(Mechanism mechanism, double factor) {
  for (auto& drive : mechanism.drives) drive.motion = drive.motion.at_speed(1 / factor);
  return mechanism;
}

std::vector<std::string> follows_time(const Mechanism& mechanism) {
  std::vector<std::string> names;
  for (const LoadSpec& load : mechanism.loads)
    if (!load.scale.is_constant()) names.push_back("load '" + load.name + "'");
  if (!mechanism.gravity_scale.is_constant()) names.emplace_back("gravity_scale");
  for (const ForceSpec& force : mechanism.forces)
    if (!force.force.is_constant()) names.push_back("force '" + force.name + "'");
  return names;
}

}  // namespace liesl
