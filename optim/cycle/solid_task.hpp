#pragma once
/// @file
/// The static problem of a meshed part as a study states it.

#include "optim/cycle/static_shape.hpp"
#include "optim/design/part_shape.hpp"

namespace liesl {

/// Support, outputs, limits, objective and fixed loads of a part; no loads of a motion yet.
/// `part` and its parts must outlive it. Default support: all directions of the first interface.
/// @throws std::invalid_argument: a support that is no interface, set or "inertia_relief", loads
/// that fit no side, an elongation of two bodies
SolidTask solid_task(const StudySpec& study, PartShape& part);

}  // namespace liesl
