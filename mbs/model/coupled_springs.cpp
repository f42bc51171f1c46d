#include "mbs/model/coupled_springs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace liesl {
namespace {

constexpr double kRoundOff = 1e-9;  // of a diagonal entry: nothing of it is left

}  // namespace

std::vector<CoupledSpring> coupled_springs(const Eigen::MatrixXd& K) {
  const auto n = K.rows();
  const Eigen::VectorXd size = K.diagonal().cwiseAbs();
  Eigen::MatrixXd rest = K;
  std::vector<CoupledSpring> springs;
  const auto refuse = [&size](Eigen::Index i, double left) {
    throw std::invalid_argument(fmt::format(
        "what the others leave of the {:.4g} of coordinate {} is {:.2g}", size[i], i, left));
  };
  for (Eigen::Index i = 0; i < n; ++i) {
    const double pivot = rest(i, i);
    if (!(pivot >= -kRoundOff * size[i])) refuse(i, pivot);
    const bool none = pivot <= kRoundOff * size[i];
    CoupledSpring spring{static_cast<int>(i), pivot, {}};
    for (Eigen::Index j = i + 1; j < n; ++j) {
      const double entry = rest(j, i);
      if (std::abs(entry) <= kRoundOff * std::sqrt(size[i] * size[j])) continue;
      if (none) refuse(i, pivot);
      spring.shares.push_back({static_cast<int>(j), entry / pivot});
    }
    if (none) continue;
    for (Eigen::Index j = i + 1; j < n; ++j)
      for (Eigen::Index k = i + 1; k <= j; ++k) rest(j, k) -= rest(j, i) * rest(k, i) / pivot;
    springs.push_back(std::move(spring));
  }
  return springs;
}

}  // namespace liesl
