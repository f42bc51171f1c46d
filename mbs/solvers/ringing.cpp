#include "mbs/solvers/ringing.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {
namespace {

constexpr double kRings = 0.01;    // of the multipliers
constexpr double kOpposite = 0.5;  // cosine between one difference and the next

}  // namespace

void Ringing::step(const Eigen::VectorXd& lambda, double h) {
  known_ = h == h_ ? known_ + 1 : 1;
  h_ = h;
  ++steps_;
  if (known_ > 2) difference_ = lambda - 2 * before_ + earlier_;
  if (known_ > 3 && difference_.dot(last_) < -kOpposite * difference_.norm() * last_.norm() &&
      difference_.norm() > 4 * kRings * lambda.norm()) {
    ++rings_;
    share_ += std::min(1.0, difference_.norm() / (4 * lambda.norm()));
  }
  last_ = difference_;
  earlier_.swap(before_);
  before_ = lambda;
}

double Ringing::calm_rho() const {
  const double half = 0.5 * static_cast<double>(steps_);
  return std::floor(100 * std::pow(kRings / (share() * half), 1 / half)) / 100;
}

}  // namespace liesl
