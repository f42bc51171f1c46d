#pragma once
/// @file
/// Von Mises stress at the points of a beam element's section, and its gradients.

#include <vector>

#include "mbs/sections/section.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {

/// sigma_vm = sqrt(s^T diag(1, 3, 3) s), s = [sigma_x; tau_xy; tau_xz] = S K_s eps at each stress
/// point of the section, eps the strain of the element on G. Made once for a section, asked for
/// many strains.
template <FrameGroup G>
class ElementStress {
 public:
  using Strain = typename G::Tangent;
  using Matrix = typename G::Matrix;
  /// What a variable does to the section: dK_s, and dS at each stress point (in space).
  struct Change {
    Matrix dK = Matrix::Zero();
    std::vector<Eigen::Matrix<double, 3, 6>> dS;
  };

  /// @param align of the element's axes to those of G, as in Space::alignment
  ElementStress(const Section& section, const Material& material, const Space<G>& space,
                const SE3& align);

  /// Pa; `slope`: gradient with respect to the strain.
  double value(int point, const Strain& strain, Strain* slope) const;
  /// Part of d(stress)/dx at fixed strain, Pa per unit of x: the section itself changes.
  double explicit_slope(int point, const Strain& strain, const Change& change) const;

 private:
  using Rows = Eigen::Matrix<double, 3, G::dim>;
  std::vector<Rows, Eigen::aligned_allocator<Rows>> S_, SK_;
  Matrix K_;
  Eigen::Matrix<double, 6, G::dim> embed_;  ///< section forces of G to those in space
};

extern template class ElementStress<SE2>;
extern template class ElementStress<SE3>;

}  // namespace liesl
