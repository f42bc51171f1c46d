#pragma once
/// @file
/// The static problem K(v) u = f of a meshed part for many load cases together, linear outputs
/// y = C^T u and their gradients with respect to the fractions (thesis eq. 3.23-3.24).

#include <string>
#include <vector>

#include "mbs/linalg/sparse_cholesky.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {

/// What holds a part: coordinates at zero, or inertia relief, where loads are balanced by the rigid
/// acceleration of the part, f - M R (R^T M R)^-1 R^T f, and displacements are those without mean
/// rigid motion, R^T M u = 0.
struct SolidSupport {
  std::vector<int> fixed;  ///< coordinates of q
  bool inertia_relief = false;

  static SolidSupport relief() { return {{}, true}; }
};

/// Adds components of a port to the fixed coordinates: letters of "xyr" (plane) or "xyz" and "r",
/// all rotations. @throws std::invalid_argument for other letters
void fix_port(SolidSupport& support, const SolidModel& model, int interface,
              const std::string& letters);
/// The same for single nodes ("xyz"). @throws std::invalid_argument if an interface took a node
void fix_nodes(SolidSupport& support, const SolidModel& model, const std::vector<int>& nodes,
               const std::string& letters);

/// Output vectors C in q. Relative displacement of two ports along their connecting line
/// (elongation, positive when they part), m.
Eigen::VectorXd elongation_output(const SolidModel& model, int interface_a, int interface_b);
/// Motion of the port of b relative to the rigid motion of the port of a, component 0..2 (0..5) of
/// [u; w]: zero in a rigid motion.
Eigen::VectorXd relative_output(const SolidModel& model, int interface_a, int interface_b,
                                int component);
/// Displacement of a node along an axis, also of one that an interface took.
Eigen::VectorXd node_output(const SolidModel& model, int node, int component);

/// Load of a constant traction (Pa; force per area of plane cells' sides times the thickness, in
/// the axes of the mesh) on the sides of cells all of whose nodes are in a set, in q: exact for
/// the displacements of the cells. @throws std::invalid_argument if no side is
Eigen::VectorXd traction_load(const SolidModel& model, const std::vector<int>& nodes,
                              const Eigen::Vector3d& traction);

enum class SolidStatus { Solved, Unsupported, NotFinite };
std::string reason(SolidStatus status);

class SolidStatics {
 public:
  /// @param outputs C, q x m (m may be 0). The model must outlive this and its mesh not change.
  SolidStatics(const SolidModel& model, SolidSupport support, Eigen::MatrixXd outputs);

  /// Loads of the cases, q x n; nodal forces f_nodes enter as T^T f_nodes.
  void set_loads(const Eigen::MatrixXd& f) { f_ = f; }
  /// One factorisation, all cases and outputs solved together. Unsupported: a rigid motion is
  /// left (the stiffness matrix is not positive definite).
  SolidStatus solve(const Eigen::VectorXd& v);

  int cases() const { return static_cast<int>(f_.cols()); }
  int outputs() const { return static_cast<int>(C_.cols()); }
  const SolidModel& model() const { return model_; }
  const Eigen::VectorXd& fractions() const { return v_; }

  auto q() const { return all_.q.leftCols(cases()); }  ///< q x cases
  auto u() const { return all_.u.leftCols(cases()); }  ///< node freedoms x cases
  const Eigen::MatrixXd& y() const { return y_; }      ///< outputs x cases
  Eigen::VectorXd compliance() const;                  ///< f^T u by case, J
  bool inertia_relief() const { return support_.inertia_relief; }
  /// Displacements of the nodes under the load C of an output: node freedoms.
  auto adjoint(int output) const { return all_.u.col(cases() + output); }
  /// Rigid accelerations that balance the cases, then the outputs, at the nodes: node freedoms x
  /// (cases + outputs), zero without inertia relief.
  Eigen::MatrixXd acceleration() const { return TR_ * all_.acceleration; }

  /// d y(output, case)/d p for all cases [cases x parameters], from d v/d p [cells x parameters]:
  /// -s'(v) mu_e^T K_e u_e summed over cells; with inertia relief also
  /// -mu_e^T M_e (R a)_e - u_e^T M_e (R b)_e, where a, b are the rigid accelerations that balance
  /// loads and output. Only cells with an entry in dv cost anything.
  Eigen::MatrixXd output_gradient(int output, const FractionGradient& dv) const;
  /// d (f^T u)/dp, cases x parameters.
  Eigen::MatrixXd compliance_gradient(const FractionGradient& dv) const;

  /// Gradient of any function S_n of the displacements of case n: `dS_dq` [q x cases] is solved for
  /// with the factor, and what is left is added: out(n, :) += -sum_e (s' mu_n,e^T K_e u_n,e + ...)
  /// dv_e. Explicit dependence on v is the caller's.
  void add_adjoint_gradient(const Eigen::MatrixXd& dS_dq, const FractionGradient& dv,
                            Eigen::MatrixXd& out) const;

 private:
  /// Solutions, and the rigid accelerations taken off their right-hand sides.
  struct Solved {
    Eigen::MatrixXd rhs, q;        ///< q x columns
    Eigen::MatrixXd u;             ///< freedoms x columns
    Eigen::MatrixXd acceleration;  ///< rigid x columns; without inertia relief zero
  };
  /// What a change of a cell's fraction does to an output: -(P . u_n + Q . (R a_n)).
  using CellVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 60, 1>;
  struct CellWeights {
    CellVector P, Q;
  };

  void solve_columns(Solved& s) const;
  void hold_determinately(const SolidModel::Sparse& M);
  CellWeights cell_weights(int e, const double* mu, const double* rigid_b) const;
  /// out(n, :) -= sum_e (P . u_n + Q . (R a_n)) dv_e, for one adjoint column or one a case (-1).
  void accumulate(const Solved& mu, int column, const FractionGradient& dv,
                  Eigen::MatrixXd& out) const;

  const SolidModel& model_;
  SolidSupport support_;
  Eigen::MatrixXd C_, f_, y_;
  Solved all_;  ///< cases, then outputs
  Eigen::VectorXd v_;
  std::vector<int> held_;  ///< coordinates at zero in the factor
  SolidModel::Sparse K_;   ///< with the held rows replaced
  Eigen::MatrixXd MR_, RMR_inverse_, TR_;
  SparseCholesky factor_;
};

}  // namespace liesl
