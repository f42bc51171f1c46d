#pragma once
/// @file
/// The static problem of one isolated part, K(p) u = f, for many load cases and many linear
/// outputs y = C^T u; gradients of all outputs in all cases from one more solution an output
/// (thesis eq. 3.23-3.24).
///
/// A beam that is held determinately is solved by statics, not by factoring K: equilibrium gives
/// the reactions and section forces, K_s^-1 the strains, and their sum along the chain the
/// displacement. That costs less than a factorisation and keeps all digits; K of n slender elements
/// loses n^3 kGA L^2/EI of them (nine with 100 elements and shear that is made rigid).

#include <string>
#include <vector>

#include "mbs/bodies/beam.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// What holds the part while its rigid motions are out of the way.
struct PartSupport {
  std::vector<int> fixed;       ///< increments held at zero, dim of them
  bool inertia_relief = false;  ///< loads are balanced by rigid accelerations first
};

/// Reads {"start"}, {"node3:xyz,rx", "end:yz"} or {"inertia_relief"} for a beam body; x, y, z, rx,
/// ry, rz are local axes of the node.
/// @throws std::invalid_argument: no such node, letters, not exactly as many as rigid motions, or
///         such that a rigid motion remains
template <FrameGroup G>
PartSupport read_support(const std::vector<std::string>& support, const Mechanism& mechanism,
                         const Model<G>& model, int body);

template <FrameGroup G>
class StaticPart {
 public:
  static constexpr int dim = G::dim;
  using Matrix = typename G::Matrix;
  using Law = std::vector<Matrix, Eigen::aligned_allocator<Matrix>>;  ///< one an element
  using Strain = Eigen::Matrix<double, dim, Eigen::Dynamic>;          ///< of one element, by case

  /// @param outputs C, size of the body x m: gradients of the outputs at the reference shape
  StaticPart(const BeamChain<G>& beam, PartSupport held, Eigen::MatrixXd outputs);

  /// Loads of the cases [size x n] from here on; balanced if the part has inertia relief.
  void set_loads(const Eigen::MatrixXd& f);
  /// Stiffnesses K_s of the elements at rest (BeamChain::rest_stiffness_of; at order 2 those
  /// of the sections). Solves all cases and all outputs.
  /// @returns false if a K_s is singular
  bool solve(const Law& K_s);

  int cases() const { return static_cast<int>(f_.cols()); }
  int outputs() const { return static_cast<int>(C_.cols()); }
  const Eigen::MatrixXd& u() const { return u_; }  ///< size x cases
  const Eigen::MatrixXd& y() const { return y_; }  ///< outputs x cases
  double length(int element) const { return length_[element]; }

  /// dy += -(1/L) (P0 mu)^T dK_s (P0 u) for one element whose section changes by dK_s, in the first
  /// outputs() rows of dy [x cases].
  void add_gradient(int element, const Matrix& dK_s, Eigen::MatrixXd& dy) const;

  /// The same by the direct form, dy -= C^T K^-1 (dK u): one solution a case and variable instead
  /// of one an output. `dK`: change of every element's section.
  void add_gradient_direct(const Law& dK, Eigen::MatrixXd& dy) const;
  /// Which form costs fewer solutions for so many variables.
  bool direct_is_cheaper(int variables) const { return variables * cases() < outputs(); }

  /// f^T u of each case, J, and its change -(1/L) (P0 u)^T dK_s (P0 u) with one element's section.
  Eigen::RowVectorXd compliance() const { return f_.cwiseProduct(u_).colwise().sum(); }
  Eigen::RowVectorXd compliance_gradient(int element, const Matrix& dK_s) const;

  /// Same for one weighted sum: sum_{o,n} w(o, n) d2y(o, n)/dx_i dx_j, all pairs of variables, from
  /// d2y = mu^T (K_i K^-1 K_j + K_j K^-1 K_i - K_ij) u. `dK[i]`: derivative by element (empty
  /// matrix list = variable does not touch this part); `d2K(i, j)` by element.
  using Second = std::vector<std::vector<Law>>;
  void add_second(const std::vector<Law>& dK, const Second& d2K, const Eigen::MatrixXd& w,
                  Eigen::MatrixXd& h) const;

  /// The output that is the strain of one element: dim columns of C.
  static Eigen::MatrixXd strain_output(const BeamChain<G>& beam, int element);

 private:
  /// K' u for a change of sections, [size x columns], from the strains P0 u.
  Eigen::MatrixXd multiply(const Law& dK, const std::vector<Strain>& strain) const;
  /// x <- K^-1 x by columns; `strain`: P0 x by element.
  void solve_columns(Eigen::MatrixXd& x, std::vector<Strain>& strain) const;
  void solve_column(double* x, std::vector<Strain>& strain, int column) const;

  const BeamChain<G>& beam_;
  PartSupport held_;
  Eigen::MatrixXd C_, f_, u_, mu_, y_;
  std::vector<typename BeamElement<G>::Gradient,
              Eigen::aligned_allocator<typename BeamElement<G>::Gradient>>
      P0_;
  std::vector<double> length_;
  std::vector<Strain> strain_u_, strain_mu_;  ///< P0 u, P0 mu by element
  Law T_, back_;         ///< by element: T(d0), Ad(exp(-d0)): u_B = T P0 u + Ad u_A
  Law rigid_;            ///< by node: increments of the rigid motions, about node 0
  Matrix held_inverse_;  ///< (rigid motions at the held increments)^-1
  Law flexibility_;      ///< by element: L K_s^-1
};

extern template PartSupport read_support(const std::vector<std::string>&, const Mechanism&,
                                         const Model<SE2>&, int);
extern template PartSupport read_support(const std::vector<std::string>&, const Mechanism&,
                                         const Model<SE3>&, int);
extern template class StaticPart<SE2>;
extern template class StaticPart<SE3>;

}  // namespace liesl
