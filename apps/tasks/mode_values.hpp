#pragma once
/// @file
/// What responses, section forces and stresses are in a mode.

#include "apps/output/results.hpp"
#include "apps/scene/scene.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// Sets responses and the strains, section forces and stresses of bodies in `results`, a record a
/// mode, to their changes from the equilibrium as linear in the shape: the derivative at the
/// equilibrium along the shape times its size. Sizes (norms, von Mises stresses) have that to the
/// side of the shape. Energies, which begin quadratically, are taken to second order.
/// @param shapes increments of the nodes, in the size that is shown; columns: modes
template <FrameGroup G>
void set_mode_values(const Scene& scene, const Model<G>& model, const State<G>& equilibrium,
                     const Eigen::MatrixXd& shapes, output::Results& results);

extern template void set_mode_values(const Scene&, const Model<SE2>&, const State<SE2>&,
                                     const Eigen::MatrixXd&, output::Results&);
extern template void set_mode_values(const Scene&, const Model<SE3>&, const State<SE3>&,
                                     const Eigen::MatrixXd&, output::Results&);

}  // namespace liesl
