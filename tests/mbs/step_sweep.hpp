#pragma once
/// @file
/// Derivatives against differences: the error must fall with the square of the step.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <string>

namespace liesl::test {

using VectorOf = std::function<Eigen::VectorXd(double)>;

/// Checks that `exact` is the limit of `difference(h)` with an error C h^2: over h, h/2, h/4 each
/// halving divides the error by 4 (slope 2 +- 0.15), or the error is round-off already.
/// Each component is judged relative to `scale`.
inline void expect_second_order(const VectorOf& difference, const Eigen::VectorXd& exact,
                                const Eigen::VectorXd& scale, double h, double round_off,
                                const std::string& what) {
  Eigen::VectorXd found[3];  // by level, when it is asked for
  for (Eigen::Index i = 0; i < exact.size(); ++i) {
    double previous = 0;
    for (int level = 0; level < 3; ++level) {
      if (found[level].size() == 0) found[level] = difference(h / std::pow(2, level));
      const double error = std::abs(found[level][i] - exact[i]) / scale[i];
      if (error < round_off) break;
      if (level > 0) {
        EXPECT_NEAR(std::log2(previous / error), 2, 0.15) << what << ", component " << i;
      }
      EXPECT_LT(error, 1) << what << ", component " << i;
      previous = error;
    }
  }
}

/// d f / dx by central differences, error C h^2.
inline VectorOf central_first(const VectorOf& f, double x) {
  return [=](double h) -> Eigen::VectorXd { return (f(x + h) - f(x - h)) / (2 * h); };
}

/// d^2 f / dx^2 by central differences, error C h^2.
inline VectorOf central_second(const VectorOf& f, double x) {
  return [=](double h) -> Eigen::VectorXd { return (f(x + h) - 2 * f(x) + f(x - h)) / (h * h); };
}

}  // namespace liesl::test
