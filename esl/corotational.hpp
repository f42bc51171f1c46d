#pragma once
/// @file
/// Internal forces as the classical formalism has them: a reference stiffness times the
/// displacements in a corotational frame (thesis eq. 3.21), here one frame an element.
///
/// With one frame for the whole part, K_ref u holds the axial force EA w'^2/2 that a bent axis of
/// unchanged length would need at small displacements. In the frame of an element of length h that
/// part is of order h^2, and loads agree with those of the other formalisms as the mesh refines.

#include "mbs/bodies/beam.hpp"

namespace liesl {

/// f += sum over the elements; element e with nodes A, B:
///   H_e = (R_A exp(log(R_A^T R_B)/2), (x_A + x_B)/2)              its frame, H_e0 at reference
///   Y_k = H_e0 H_e^-1 H_k,  u_k = [R_k0^T (y_k - x_k0); log(R_k0^T R(Y_k))]
///   f_k = (R_k0^T R(Y_k))^T (K_e u)_k                             in the axes of node k
/// @param H frames of the nodes  @param f dim * nodes, [N; N m] a node
template <FrameGroup G>
void add_corotational_force(const BeamChain<G>& beam, const G* H, double* f);

extern template void add_corotational_force(const BeamChain<SE2>&, const SE2*, double*);
extern template void add_corotational_force(const BeamChain<SE3>&, const SE3*, double*);

}  // namespace liesl
