#pragma once
/// @file
/// Equivalent static loads of a meshed part at every instant of the motion: f_n = K(v) u_n with
/// the displacements u_n = Psi e_n of the full mesh in the floating frame (thesis eq. 3.20 for a
/// reduced body).

#include "esl/load_set.hpp"
#include "mbs/solids/solid_spec.hpp"

namespace liesl {

/// Loads in the coordinates q of `SolidModel`: forces on the free nodes, [force; moment] on the
/// ports, in the axes of the mesh; of static equilibrium each. They are combinations of a few:
/// f_n = shapes e_n, so that a static problem of any design needs as many solutions as e has
/// components, whatever the number of cases.
struct SolidLoadSet {
  int body = 0;
  std::vector<double> t;   ///< s, one a load case
  Eigen::MatrixXd e;       ///< motions of the further ports and amplitudes x load cases
  Eigen::MatrixXd shapes;  ///< K(v) Psi, q x components of e
  Eigen::MatrixXd basis;   ///< Psi: dynamic displacements are u_n = basis e_n; first port held

  Eigen::VectorXd load(int n) const { return shapes * e.col(n); }
};

/// The loads of one part at every record. Elastic part only, as of beams.
/// @throws std::invalid_argument if the body is no flexible meshed part
template <FrameGroup G>
SolidLoadSet extract_solid_loads(const Model<G>& model, const Trajectory<G>& trajectory, int body);

/// sum_n |f_n - f_n,before| / sum_n |f_n,before| (thesis eq. 3.25), norms over the coordinates q;
/// 0 if both are zero, infinity if only those before are. @pre the same coordinates and times
double load_change(const SolidLoadSet& f, const SolidLoadSet& before);

/// Solves the full mesh, held at its first port, under `cases` of its loads spread over time, the
/// largest among them, and compares displacements with the motion's: `linear` = `nonlinear` =
/// largest difference over the largest displacement. NaN never: infinity if the mesh is not held.
/// @param fractions of the cells, those of the motion
Identity check_identity(const SolidModel& solid, const Eigen::VectorXd& fractions,
                        const SolidLoadSet& loads, int cases = 8);

extern template SolidLoadSet extract_solid_loads(const Model<SE2>&, const Trajectory<SE2>&, int);
extern template SolidLoadSet extract_solid_loads(const Model<SE3>&, const Trajectory<SE3>&, int);

}  // namespace liesl
