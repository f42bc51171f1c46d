#pragma once
/// @file
/// Limits over all of a motion as constraints (thesis section 3.3.2; Kreisselmeier & Steinhauser
/// 1979 for KS): which records count, and functions of all of them.

#include <set>

#include "optim/cycle/motion_gradients.hpp"

namespace liesl {

/// The records of a limit that become rows. @param v values, not empty
std::set<int> treated_records(Treatment treatment, const std::vector<double>& v);

/// What a limit is compared with: the largest value, or the number that stands for all.
double treated_value(const ConstraintSpec& limit, const std::vector<double>& times,
                     const std::vector<double>& v);

/// The functions of an aggregating treatment, with their derivatives by the values.
std::vector<MotionGradients::Aggregate> aggregates_of(const ConstraintSpec& limit,
                                                      const std::vector<double>& times,
                                                      const std::vector<double>& v);

}  // namespace liesl
