#pragma once
/// @file
/// The linear system of statics at one state,
///   [K  B^T] [delta ]     [r  ]
///   [B   0 ] [dlambda] = -[phi],
/// K = exact tangent of bodies, loads, forces and joints with respect to left-invariant nodal
/// increments. What the geometric terms of K act with, section forces and forces of springs, is
/// kept apart from the state: `Prestress`.

#include "mbs/linalg/sparse_assembly.hpp"
#include "mbs/linalg/sparse_lu.hpp"
#include "mbs/system/equations.hpp"

namespace liesl {

/// Forces in the geometric stiffness.
template <FrameGroup G>
struct Prestress {
  using Tangent = typename G::Tangent;
  std::vector<std::vector<Tangent, Eigen::aligned_allocator<Tangent>>>
      section;                         ///< bodies x elements
  std::vector<Eigen::VectorXd> force;  ///< couplings x acting rows; constraints: unused
};

template <FrameGroup G>
class StaticSystem {
 public:
  static constexpr int dim = G::dim;
  using Matrix = SparseAssembly::Matrix;

  explicit StaticSystem(const Model<G>& model);

  /// Prestress of the state itself.
  /// @pre eq was evaluated at s, here and below
  void take_prestress(const Equations<G>& eq, const State<G>& s);
  /// Prestress of the state extrapolated by an increment: sigma + (K/L) P delta for elements,
  /// f + k B delta for springs (mixed-integration-point Newton: Magisano, Leonetti, Garcea 2017,
  /// "How to improve efficiency and robustness of the Newton method in geometrically non-linear
  /// structural problem discretized via displacement-based finite elements", CMAME 313).
  void extrapolate_prestress(const Equations<G>& eq, const State<G>& s,
                             const Eigen::VectorXd& delta);

  /// The saddle-point matrix at s, (n + m) x (n + m), with the prestress last taken.
  const Matrix& assemble(const Equations<G>& eq, const State<G>& s, const LoadLevel& level);
  const Matrix& matrix() const { return *matrix_; }

  /// Factors what was assembled. @returns false if it is singular.
  bool factor() { return lu_.factor(*matrix_); }
  const SparseLu& lu() const { return lu_; }

  int size() const { return model_.size(); }
  int constraints() const { return model_.constraints(); }

 private:
  void add_bodies(const State<G>& s, const LoadLevel& level);
  void add_loads(const State<G>& s, const LoadLevel& level);
  void add_coupling(int index, const Equations<G>& eq, const State<G>& s);

  const Model<G>& model_;
  Prestress<G> prestress_;
  std::vector<BodyMatrix<dim>> K_;  ///< bodies with the loads on them
  SparseAssembly assembly_;
  const Matrix* matrix_ = nullptr;
  SparseLu lu_;
};

extern template class StaticSystem<SE2>;
extern template class StaticSystem<SE3>;

}  // namespace liesl
