#pragma once
/// @file
/// A load per length over a body.

#include "liegroup/concepts.hpp"

namespace liesl {

template <FrameGroup G>
struct SpreadLoad {
  typename G::Tangent wrench;  ///< [force; moment], N/m and N m/m
  bool follower = false;       ///< in the axes of the sections; else in inertial ones
};

}  // namespace liesl
