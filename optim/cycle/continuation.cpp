#include "optim/cycle/continuation.hpp"

namespace liesl {

template <FrameGroup G>
std::vector<Scenario<G>> at_speed(std::vector<Scenario<G>> scenarios, double speed) {
  const auto slow = [speed](TimeFunction& f) { f = f.at_speed(speed); };
  for (Scenario<G>& s : scenarios) {
    for (BodySpec& b : s.mechanism.bodies) {
      b.velocity *= speed;
      b.angular_velocity *= speed;
    }
    for (DriveSpec& d : s.mechanism.drives) slow(d.motion);
    for (ForceSpec& f : s.mechanism.forces) slow(f.force);
    for (LoadSpec& l : s.mechanism.loads) slow(l.scale);
    slow(s.mechanism.gravity_scale);
    s.simulation.duration /= speed;
    s.simulation.step /= speed;
    s.simulation.step_min /= speed;
    s.mechanism.penalty.step /= speed;
  }
  return scenarios;
}

template std::vector<Scenario<SE2>> at_speed(std::vector<Scenario<SE2>>, double);
template std::vector<Scenario<SE3>> at_speed(std::vector<Scenario<SE3>>, double);

}  // namespace liesl
