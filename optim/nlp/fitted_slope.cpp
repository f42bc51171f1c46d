#include "optim/nlp/fitted_slope.hpp"

#include <Eigen/QR>
#include <cassert>
#include <cmath>
#include <numbers>

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

OddFits::OddFits() : points_(kPairs) {
  for (int i = 0; i < kPairs; ++i)
    points_[i] = std::cos(std::numbers::pi * (i + 0.5) / (2 * kPairs));
  for (int terms = 1; terms <= kMostTerms; ++terms) {
    MatrixXd A(kPairs, terms);
    for (int m = 0; m < terms; ++m) A.col(m) = points_.array().pow(2 * m + 1);
    const Eigen::HouseholderQR<MatrixXd> qr(A);
    const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(kPairs, terms);
    const MatrixXd R = qr.matrixQR().topRows(terms);
    const VectorXd first =
        R.triangularView<Eigen::Upper>().transpose().solve(VectorXd::Unit(terms, 0));
    fits_.push_back({basis, basis * first});
  }
}

FittedSlope OddFits::operator()(const VectorXd& odd, double window) const {
  assert(odd.size() == kPairs && window > 0);
  FittedSlope best;
  for (const Fit& fit : fits_) {
    const VectorXd rest = odd - fit.basis * (fit.basis.transpose() * odd);
    const double variance = rest.squaredNorm() / static_cast<double>(kPairs - fit.basis.cols());
    const double deviation = std::sqrt(variance) * fit.slope.norm() / window;
    if (deviation < best.deviation) best = {fit.slope.dot(odd) / window, deviation};
  }
  return best;
}

}  // namespace liesl
