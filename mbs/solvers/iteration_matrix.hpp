#pragma once
/// @file
/// The matrix of Newton's method at one state, of a step in time and of statics,
///   S = [K + C V + M W   B^T]      S [delta ] = -[r  ]
///       [B              -C_p],       [dlambda]    [phi],
/// K, C, M: exact derivatives of the residual, of bodies, loads, force laws and joints (that of
/// B^T lambda among them), by left-invariant nodal increments, by v and by vdot. V and W give how v
/// and vdot follow an increment within a step (`RateTangents`; Screw: gamma' T^-1(dq) and
/// beta' T^-1(dq)). In statics they are zero. C_p: compliance of penalties, else 0; damped ones
/// have tau (D(B v) + B V) added to B. What the geometric terms of K act with, section forces and
/// forces of springs, is kept apart from the state: `Prestress`.

#include "mbs/linalg/sparse_assembly.hpp"
#include "mbs/linalg/sparse_lu.hpp"
#include "mbs/solvers/node_coordinates.hpp"
#include "mbs/system/equations.hpp"

namespace liesl {

/// Forces in the geometric stiffness.
template <FrameGroup G>
struct Prestress {
  typename Equations<G>::SectionForces section;  ///< bodies x elements
  std::vector<Eigen::VectorXd> force;            ///< couplings x acting rows; constraints: unused
};

template <FrameGroup G>
class IterationMatrix {
 public:
  static constexpr int dim = G::dim;
  using Matrix = SparseAssembly::Matrix;
  using Pair = Eigen::Matrix<double, 2 * dim, 2 * dim>;

  explicit IterationMatrix(const Model<G>& model);

  /// Prestress of the state itself.
  /// @pre eq was evaluated at s, here and below
  void take_prestress(const Equations<G>& eq, const State<G>& s);
  /// The same where no increment is to be added to it: bodies know the stress of a state.
  void take_own_stress(const Equations<G>& eq);
  /// Prestress of the state extrapolated by an increment: sigma + (K/L) P delta for elements,
  /// f + k B delta for springs (mixed-integration-point Newton: Magisano, Leonetti, Garcea 2017,
  /// "How to improve efficiency and robustness of the Newton method in geometrically non-linear
  /// structural problem discretized via displacement-based finite elements", CMAME 313).
  void extrapolate_prestress(const Equations<G>& eq, const State<G>& s,
                             const Eigen::VectorXd& delta);
  const Prestress<G>& prestress() const { return prestress_; }

  /// The blocks of S at s with the prestress last taken. @param rates null: statics
  void linearise(const Equations<G>& eq, const State<G>& s, const LoadLevel& level,
                 const RateTangents<G>* rates = nullptr);
  /// K + C V + M W of a body with the loads on it, and of a coupling, [node of a; node of b],
  /// without B.
  const BodyMatrix<dim>& body(int b) const { return A_[b]; }
  const Pair& coupling(int c) const { return couplings_[c].A; }
  /// tau (D(B v) + B V) of its constraints, [node of a; node of b]. @pre damped()
  using Rates = Eigen::Matrix<double, Eigen::Dynamic, 2 * dim>;
  const Rates& rate(int c) const { return rates_[c]; }
  bool damped() const { return damped_; }

  /// S at s, (n + m) x (n + m): the blocks, and B.
  const Matrix& assemble(const Equations<G>& eq, const State<G>& s, const LoadLevel& level,
                         const RateTangents<G>* rates = nullptr);
  const Matrix& matrix() const { return *matrix_; }
  /// M, n x n. @pre the last linearisation was one with rates, here and below
  const Matrix& mass();
  /// y += M x or M^T x, y += C x or C^T x; n rows, any number of columns
  void add_mass_product(const Eigen::MatrixXd& x, bool transposed, Eigen::MatrixXd& y) const;
  void add_damping_product(const Eigen::MatrixXd& x, bool transposed, Eigen::MatrixXd& y) const;

  /// Factors what was assembled. @returns false if it is singular.
  bool factor() { return lu_.factor(*matrix_); }
  /// The same for solutions that are refined.
  bool factor_kept() { return lu_.factor_kept(*matrix_); }
  const SparseLu& lu() const { return lu_; }
  SparseLu& lu() { return lu_; }

  int size() const { return model_.size(); }
  int constraints() const { return model_.constraints(); }

 private:
  using BodyMatrices = std::vector<BodyMatrix<dim>>;
  struct CouplingBlock {
    Pair A, C;   ///< share of S, and of C
    bool damps;  ///< C is not zero
  };

  void linearise_bodies(const State<G>& s, const LoadLevel& level, const RateTangents<G>* rates);
  void linearise_load(const Load<G>& load, const State<G>& s, const LoadLevel& level);
  void linearise_coupling(int index, const Equations<G>& eq, const State<G>& s,
                          const RateTangents<G>* rates);
  /// f(row, column, block) of the blocks of K of a coupling.
  template <class F>
  void each_block_of(const Coupling<G>& c, const Pair& K, F f) const;
  void add_bodies_product(const BodyMatrices& K, const Eigen::MatrixXd& x, bool transposed,
                          Eigen::MatrixXd& y) const;
  BodyMatrices empty() const;

  const Model<G>& model_;
  Prestress<G> prestress_;
  bool own_stress_ = false;  ///< `prestress_` has none of bodies
  Eigen::VectorXd still_;    ///< no increment
  BodyMatrices A_, C_, M_;   ///< by body
  std::vector<CouplingBlock, Eigen::aligned_allocator<CouplingBlock>> couplings_;
  std::vector<Rates> rates_;
  bool damped_ = false;
  std::vector<int> followers_;  ///< nodes without unknowns: the identity in S
  SparseAssembly assembly_, mass_;
  const Matrix* matrix_ = nullptr;
  SparseLu lu_;
};

extern template class IterationMatrix<SE2>;
extern template class IterationMatrix<SE3>;

}  // namespace liesl
