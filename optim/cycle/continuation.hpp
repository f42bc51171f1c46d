#pragma once
/// @file
/// Motions at a share of their speed, for the continuation of a study that ends infeasible: where
/// they are slow, inertia forces are small.

#include <vector>

#include "optim/cycle/motion_model.hpp"

namespace liesl {

/// The same motions at a share of their speed: every function of time is f(speed t), velocities at
/// the start are speed times as large, duration and steps 1/speed times as long; weight and the
/// size of loads stay. @param speed > 0
template <FrameGroup G>
std::vector<Scenario<G>> at_speed(std::vector<Scenario<G>> scenarios, double speed);

extern template std::vector<Scenario<SE2>> at_speed(std::vector<Scenario<SE2>>, double);
extern template std::vector<Scenario<SE3>> at_speed(std::vector<Scenario<SE3>>, double);

}  // namespace liesl
