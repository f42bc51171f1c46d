#pragma once
/// @file
/// Internal forces of a chain of segments in the plane (`SegmentBeam`) and the axes of its nodes,
/// four segments at once.

#include <vector>

#include "mbs/bodies/body.hpp"
#include "mbs/bodies/segment_law.hpp"

namespace liesl {

/// What forces depend on, by segment and by node.
struct SegmentLaw {
  AxialPotential potential;
  double damping;          ///< stiffness-proportional, s
  const double *L, *k;     ///< by segment: m; EA/L, N/m
  const double *c, *phi0;  ///< by node: N m, rad
  int segments;
};

/// r += N_e dl_e + M_i dphi_i of the segments in `range` and of their nodes, with the springs
/// there.
void add_segment_forces(const SegmentLaw& law, SegmentRange range, const BodyState<SE2>& s,
                        double* r, ForceScale& scale);

/// Turns the axes of inner nodes to the bisector of the segments beside them. @param from_bisector
/// by node: its axes at rest in those of the bisector
void turn_segment_axes(const std::vector<Eigen::Matrix2d>& from_bisector, int segments, SE2* H);

}  // namespace liesl
