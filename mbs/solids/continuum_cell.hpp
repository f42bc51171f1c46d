#pragma once
/// @file
/// Forces of one cell of a mesh whose nodes all move, total Lagrangian: with positions x_a of its
/// nodes at shape functions N_a of the reference X,
///   F = sum_a x_a grad N_a^T,  E = (F^T F - I)/2 + sum_k alpha_k M_k,  V = sum_g w_g W(E_g),
/// M_k enhanced Green-Lagrange strains of the 4-node quadrilateral and the 8-node hexahedron (other
/// kinds have none): the symmetric gradients of the incompatible modes of
/// `cell_matrices`, so that the cell at rest has its stiffness (J. C. Simo, M. S. Rifai, A class of
/// mixed assumed strain methods and the method of incompatible modes, Int. J. Numer. Meth. Engng 29
/// (1990) 1595-1638; S. Klinkel, W. Wagner, A geometrical non-linear brick element based on the
/// EAS-method, IJNME 40 (1997) 4529-4545). alpha makes V stationary, sum_g w_g M_g^T S_g = 0, and
/// is condensed: V is a function of the positions alone, and the same in all axes.

#include <Eigen/Core>
#include <vector>

#include "mbs/sections/section.hpp"
#include "mbs/solids/solid_law.hpp"

namespace liesl {

/// @tparam D 2: plane stress, 3: space. Stresses and strains are ordered as in `CellMatrices`, with
/// twice the shear strains; all points of a cell side by side in one column.
template <int D>
class ContinuumCell {
 public:
  static constexpr int kStrains = D == 2 ? 3 : 6;
  using Positions = Eigen::Matrix<double, D, Eigen::Dynamic>;  ///< m, one column a node

  /// What one state of the cell is to a law.
  struct Response {
    double energy = 0;        ///< J
    Eigen::VectorXd stress;   ///< w_g S_g, second Piola-Kirchhoff, Pa m^3
    Eigen::MatrixXd tangent;  ///< d(stress)/d(strain), condensed; only where it was asked for
    Eigen::VectorXd alpha;    ///< of laws that are not linear
    bool converged = true;    ///< false: no alpha was found (neo-Hookean, far from any rest)
  };

  /// @param nodes D x n at rest  @param thickness of a planar cell, m
  /// @throws std::invalid_argument for nu = 0.5 or a material without stiffness
  ContinuumCell(const Positions& nodes, const Material& material, double thickness, SolidLaw law);

  int nodes() const { return static_cast<int>(gradient_.front().cols()); }
  int points() const { return static_cast<int>(weight_.size()); }
  int strains() const { return kStrains * points(); }
  double volume() const { return volume_; }  ///< m^3

  /// Green-Lagrange strains of the positions, without the enhancement, of all points.
  void strain(const Positions& x, Eigen::VectorXd& E) const;
  /// Their rate sym(F^T Fdot).
  void strain_rate(const Positions& x, const Positions& v, Eigen::VectorXd& rate) const;
  /// @param factor that all of the response is multiplied by
  void respond(const Eigen::VectorXd& E, bool tangent, Response& out, double factor = 1) const;
  /// Linear law about the undeformed cell, condensed: d(stress)/d(strain) at rest.
  const Eigen::MatrixXd& stiffness() const { return linear_; }

  /// f += sum_g F_g S_g grad N^T: forces on the nodes, D x n, N.
  void add_force(const Positions& x, const Eigen::VectorXd& stress, Positions& f) const;
  /// d(strain)/d(positions) = B(x), strains() x D n, at D * node + component; the rate of strain
  /// has B(x) by v and B(v) by x.
  void strain_matrix(const Positions& x, Eigen::MatrixXd& B) const;
  /// K += sum_g grad N_a . S_g grad N_b I.
  void add_geometric(const Eigen::VectorXd& stress, Eigen::MatrixXd& K) const;

  /// What the reference changes by with a parameter that moves the nodes at rest by dX:
  /// d(grad N) = -(grad N dX^T) grad N, d(w) = w tr(grad N dX^T), and d(M).
  struct Variation {
    std::vector<Positions> gradient;  ///< by point
    Eigen::VectorXd weight;
    Eigen::MatrixXd enhanced;
  };
  /// @param nodes of this cell at rest or of one of equal shape  @param change dX/dp
  Variation variation(const Positions& nodes, const Positions& change) const;
  /// d(strain_rate)/dp of positions x and rates v that change by dx and dv; with v = x and dv = dx
  /// twice d(strain)/dp.
  Eigen::VectorXd rate_variation(const Positions& x, const Positions& v, const Positions& dx,
                                 const Positions& dv, const Variation& by) const;
  /// d(stress)/dp of a strain that changes by dE, of the law and of the linear one:
  ///   dsigma = dw S + w D (dE + dM alpha + M dalpha),  sum_g dM^T sigma + M^T dsigma = 0.
  Eigen::VectorXd stress_variation(const Eigen::VectorXd& E, const Eigen::VectorXd& dE,
                                   const Variation& by) const;
  Eigen::VectorXd linear_variation(const Eigen::VectorXd& E, const Eigen::VectorXd& dE,
                                   const Variation& by) const;
  /// df += d(add_force)/dp of a stress that changes by dstress.
  void add_force_variation(const Positions& x, const Eigen::VectorXd& stress, const Positions& dx,
                           const Eigen::VectorXd& dstress, const Variation& by,
                           Positions& df) const;
  SolidLaw law() const { return law_; }
  const Material& material() const { return material_; }

  /// Deformation gradient at the centre, and the smallest determinant of the points of quadrature:
  /// <= 0 where the cell is inverted there (its corners may be before).
  Eigen::Matrix<double, D, D> central_gradient(const Positions& x) const;
  double smallest_determinant(const Positions& x) const;
  /// Cauchy stress F S F^T/J at the centre in the axes of x, Pa; zero where the cell is inverted
  /// there. Enhanced strains are zero at the centre.
  Eigen::Matrix<double, kStrains, 1> central_stress(const Positions& x) const;
  /// g += gradient of f . central_stress with respect to the positions, D x n.
  void add_central_stress_gradient(const Positions& x, const Eigen::Matrix<double, kStrains, 1>& f,
                                   Positions& g) const;

 private:
  using Square = Eigen::Matrix<double, D, D>;
  using Strain = Eigen::Matrix<double, kStrains, 1>;
  static Strain green_lagrange(const Square& F);
  void respond_linearly(const Eigen::VectorXd& E, bool tangent, Response& out) const;
  struct Evaluation;
  void evaluate(const Eigen::VectorXd& E, Response& out, Evaluation& at) const;
  void respond_iterated(const Eigen::VectorXd& E, bool tangent, Response& out) const;
  Eigen::VectorXd variation_of(SolidLaw law, const Eigen::VectorXd& E, const Eigen::VectorXd& alpha,
                               const Eigen::VectorXd& dE, const Variation& by) const;

  Material material_;
  SolidLaw law_;
  std::vector<Positions> gradient_;  ///< grad N by point, 1/m
  Positions central_;                ///< that at the centre
  Eigen::VectorXd weight_;           ///< m^3
  double volume_ = 0;
  Eigen::MatrixXd enhanced_;  ///< M: strains() x modes
  Eigen::MatrixXd linear_;
  Eigen::MatrixXd to_alpha_;  ///< alpha = to_alpha E of the linear law
};

extern template class ContinuumCell<2>;
extern template class ContinuumCell<3>;

}  // namespace liesl
