#pragma once
/// @file
/// Von Mises stress at the points of the sections at both ends of a beam element, and its
/// gradients.

#include <vector>

#include "mbs/bodies/beam.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

/// sigma_vm = sqrt(s^T diag(1, 3, 3) s), s = [sigma_x; tau_xy; tau_xz] = S B K_s eps at each of the
/// `element_stress_points`, K_s of the element, S of the section at that end, eps the strain of the
/// element on G; B K_s eps is the section force at that end (`Body::section_force`), B = T^-T(-d0)
/// at the first node and T^-T(d0) at the last. Points are counted over the first end, then the
/// last. Made once for a section, asked for many strains.
template <FrameGroup G>
class ElementStress {
 public:
  using Strain = typename G::Tangent;
  using Matrix = typename G::Matrix;
  /// What a variable does to the sections: dK_s, and dS at each stress point (in space).
  struct Change {
    Matrix dK = Matrix::Zero();
    std::vector<Eigen::Matrix<double, 3, 6>> dS;
  };

  /// @param beam, e the element, at the design whose d0 it has  @param spec with its sections
  /// @param align of the element's axes to those of G, as in Space::alignment
  ElementStress(const BeamChain<G>& beam, int e, const BeamSpec& spec, const Space<G>& space,
                const SE3& align);

  /// Pairs (B K_s) eps -> eps: the strain whose stress at an end is that of the section force n.
  static Strain strain_of(const BeamChain<G>& beam, int e, ElementPlace end, const Strain& n);

  /// Pa; `slope`: gradient with respect to the strain.
  double value(int point, const Strain& strain, Strain* slope) const;
  /// Part of d(stress)/dx at fixed strain, Pa per unit of x: the section itself changes.
  double explicit_slope(int point, const Strain& strain, const Change& change) const;

 private:
  using Rows = Eigen::Matrix<double, 3, G::dim>;
  static Matrix to_end(const BeamChain<G>& beam, int e, ElementPlace end);
  const Matrix& B(int point) const { return B_[2 * std::size_t(point) / S_.size()]; }

  std::vector<Rows, Eigen::aligned_allocator<Rows>> S_;   ///< by point
  std::vector<Rows, Eigen::aligned_allocator<Rows>> SK_;  ///< S B K_s by point
  Matrix K_, B_[2];
  Eigen::Matrix<double, 6, G::dim> embed_;  ///< section forces of G to those in space
};

extern template class ElementStress<SE2>;
extern template class ElementStress<SE3>;

}  // namespace liesl
