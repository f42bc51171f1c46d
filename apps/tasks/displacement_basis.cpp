#include "apps/tasks/displacement_basis.hpp"

#include <algorithm>

namespace liesl {

DisplacementBasis::DisplacementBasis(Eigen::Index size, double tolerance)
    : tolerance_(tolerance), shapes_(size, 0) {}

Eigen::VectorXd DisplacementBasis::amplitudes(const Eigen::VectorXd& u) {
  Eigen::VectorXd of_known = basis().transpose() * u, rest = u - basis() * of_known;
  if (rest.size() == 0 || rest.cwiseAbs().maxCoeff() <= tolerance_) return of_known;
  const Eigen::VectorXd again = basis().transpose() * rest;  // what rounding left
  of_known += again;
  rest -= basis() * again;
  if (count_ == shapes_.cols())
    shapes_.conservativeResize(Eigen::NoChange, std::max<Eigen::Index>(8, 2 * count_));
  shapes_.col(count_++) = rest / rest.norm();
  of_known.conservativeResize(count_);
  of_known[count_ - 1] = rest.norm();
  return of_known;
}

}  // namespace liesl
