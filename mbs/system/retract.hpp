#pragma once
/// @file
/// A state moved by increments of its unknowns: steps in time, corrections of statics and of the
/// start, equilibria of isolated parts.

#include <span>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/system/state.hpp"

namespace liesl {

/// Nodes by what moves them; those that follow others are in none of the lists.
struct MovedNodes {
  std::span<const int> frames, positions, amplitudes;
};

/// Moves a state by increments dq of its unknowns, dim a node. Frames H = (R, x), dq = [dx; dphi]:
///
///   Screw           H exp(dq): left-invariant increments
///   R3SO3           x + dx, R exp(dphi)
///   RotationVector  x + dx, psi + dphi, R = exp(psi); psi: the last components of w
///
/// Of every update: positions x + R dx, R held; amplitudes w + dq. `to` may be `from`; of another
/// state all else stays as it is, nodes that follow others (Model::complete), velocities and forces
/// among it. Allocates nothing. @pre `to` has the size of `from`; update is not AsFormalism
template <FrameGroup G>
void retract(const State<G>& from, const Eigen::Ref<const Eigen::VectorXd>& dq, NodeUpdate update,
             const MovedNodes& nodes, State<G>& to);

extern template void retract(const State<SE2>&, const Eigen::Ref<const Eigen::VectorXd>&,
                             NodeUpdate, const MovedNodes&, State<SE2>&);
extern template void retract(const State<SE3>&, const Eigen::Ref<const Eigen::VectorXd>&,
                             NodeUpdate, const MovedNodes&, State<SE3>&);

}  // namespace liesl
