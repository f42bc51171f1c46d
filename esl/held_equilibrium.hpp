#pragma once
/// @file
/// The static problem of one part whose first node is held.

#include "mbs/bodies/body.hpp"
#include "mbs/system/state.hpp"

namespace liesl {

/// Makes node 0 fixed: its rows and columns become those of the identity.
template <int N>
void hold_first_node(BlockTridiagonal<N>& A) {
  A.D[0].setIdentity();
  if (A.blocks() > 1) {
    A.U[0].setZero();
    A.L[0].setZero();
  }
  if (!A.U2.empty()) {
    A.U2[0].setZero();
    A.L2[0].setZero();
  }
}

/// g_int(H) = f with H_0 at rest: f = [n_k; m_k] at each node in its axes [N, N m], which turn with
/// it. From rest by Newton's method with extrapolated stress, the whole load at once or, where it
/// does not get there, in steps down to 1/64 of it. Points of chains move by the stretch and the
/// turn of their segments.
/// @param at the equilibrium  @return whether it was found
template <FrameGroup G>
bool held_equilibrium(const Body<G>& body, const Eigen::VectorXd& f, State<G>& at);

}  // namespace liesl
