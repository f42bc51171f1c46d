#pragma once
/// @file
/// The stress that a beam's sections bear, at every record.

#include <vector>

#include "liegroup/lanes.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// Largest von Mises stress of a section under [N, V_y, V_z, M_x, M_y, M_z], at its stress points;
/// none for a section without a shape.
class SectionStress {
 public:
  /// One an element of a beam; empty for other bodies.
  explicit SectionStress(const BodySpec& body);
  bool empty() const { return of_end_.empty(); }
  /// @param force in the axes of that end, N and N m  @returns Pa
  double operator()(std::size_t element, ElementPlace end, const SE3::Tangent& force) const;

 private:
  /// Their rows [sigma_x; tau_xy; tau_xz]; the last point fills up the four.
  using FourPoints = Eigen::Matrix<Lanes, 3, 6>;

  void add_end(std::vector<FourPoints> points);

  std::vector<std::vector<FourPoints>> points_;  ///< neighbours that are equal once
  std::vector<std::size_t> of_end_;  ///< of `points_`, by element, the first end and the last
};

}  // namespace liesl
