#pragma once
/// @file
/// Internal forces of a chain of segments in the plane (`SegmentBeam`), four segments at once.

#include "mbs/bodies/body.hpp"
#include "mbs/bodies/segment_law.hpp"

namespace liesl {

/// What forces depend on, by segment and by node.
struct SegmentLaw {
  AxialPotential potential;
  double damping;          ///< stiffness-proportional, s
  const double *L, *EA;    ///< by segment: m, N
  const double *c, *phi0;  ///< by node: N m, rad
  int segments;
};

/// r += N_e dl_e + M_i dphi_i of the segments in `range` and of their nodes, with the springs
/// there.
void add_segment_forces(const SegmentLaw& law, SegmentRange range, const BodyState<SE2>& s,
                        double* r, ForceScale& scale);

}  // namespace liesl
