#pragma once
/// @file
/// The axes in which chains of segments are differentiated.

#include "mbs/system/model.hpp"

namespace liesl {

/// Changes of positions, n rows or more and a column each, from inertial axes into those of their
/// nodes in `s`; `back`: from these into inertial ones.
template <FrameGroup G>
void turn_positions(const Model<G>& model, const State<G>& s, bool back,
                    Eigen::Ref<Eigen::MatrixXd> x) {
  for (const int k : model.positions()) {
    SquareMatrix<G::space_dim> R = s.H[static_cast<std::size_t>(k)].R;
    if (!back) R.transposeInPlace();
    auto rows = x.template middleRows<G::space_dim>(G::dim * k);
    rows = (R * rows).eval();
  }
}

/// The state with all positions in inertial axes: those of a node turn from step to step, its
/// sensitivities do not.
template <FrameGroup G>
State<G> in_inertial_axes(const Model<G>& model, const State<G>& s) {
  State<G> out = s;
  for (auto* x : {&out.v, &out.vdot, &out.a}) turn_positions(model, s, true, *x);
  for (const int k : model.positions()) out.H[k].R.setIdentity();
  return out;
}

}  // namespace liesl
