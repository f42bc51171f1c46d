#include "mbs/solvers/richardson.hpp"

#include <algorithm>
#include <cmath>

namespace liesl {

namespace {

constexpr double kRounding = 1e-9;
constexpr double kWidest = 200;  // of the logarithm of a multiplier
constexpr int kHalvings = 60;

/// Its n at a multiplier, as a logarithm; not of a mesh without error.
double log_elements(const MeshError& m, double log_lambda) {
  return (log_lambda + std::log(m.order * m.at(1))) / (m.order + 1);
}

/// ln lambda at which the errors add up to the budget, by bisection.
double log_multiplier(const std::vector<MeshError>& meshes, double budget) {
  double low = -kWidest, high = kWidest;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    double sum = 0;
    for (const auto& m : meshes)
      if (m.error > 0) sum += m.at(1) * std::exp(-m.order * log_elements(m, middle));
    (sum <= budget ? high : low) = middle;  // of an unknown error: the finest
  }
  return high;
}

/// Numbers of elements that share a budget at the least sum, each a multiple of its own.
std::vector<int> share(const std::vector<MeshError>& meshes, double budget) {
  const double log_lambda = log_multiplier(meshes, budget);
  std::vector<int> elements;
  for (const auto& m : meshes) {
    const double n = m.error > 0 ? std::exp(log_elements(m, log_lambda)) : 0;
    const double count = std::ceil(std::min(n, static_cast<double>(m.most)) / m.multiple);
    elements.push_back(std::min(m.most, m.multiple * std::max(1, static_cast<int>(count))));
  }
  return elements;
}

}  // namespace

double observed_order(double coarse, double fine) { return std::log2(coarse / fine); }

double error_of_finer(double difference, std::optional<double> before) {
  if (!std::isfinite(difference)) return HUGE_VAL;
  if (difference < kRounding) return difference;
  const double p = before ? std::min(kOrder, observed_order(*before, difference)) : kOrder;
  return p < 0.5 ? HUGE_VAL : difference / (std::exp2(p) - 1);
}

double error_of_coarser(double difference, double order) {
  return std::isfinite(difference) ? difference / (1 - std::exp2(-order)) : HUGE_VAL;
}

double MeshError::at(int n) const {
  return error * std::pow(static_cast<double>(elements) / n, order);
}

Plan cheapest(const std::vector<long>& step_counts, long steps, double step_error,
              const std::vector<MeshError>& meshes, double others, double budget) {
  const auto error_of_steps = [&](long n) {
    const double ratio = n > 0 ? static_cast<double>(steps) / static_cast<double>(n) : 0;
    return step_error * ratio * ratio;
  };
  Plan best{step_counts.back(), {}, 0};
  for (const auto& m : meshes) best.elements.push_back(m.most);
  double least = HUGE_VAL;
  for (const long n : step_counts) {
    const double left = budget - error_of_steps(n);
    if (left <= 0) continue;
    const auto elements = share(meshes, left);
    double cost = others;
    for (const int e : elements) cost += e;
    if (n > 0) cost *= static_cast<double>(n);
    if (cost >= least) continue;
    least = cost;
    best = {n, elements, 0};
  }
  best.error = error_of_steps(best.steps);
  for (std::size_t i = 0; i < meshes.size(); ++i) best.error += meshes[i].at(best.elements[i]);
  return best;
}

std::vector<long> divisors(long n) {
  std::vector<long> list;
  for (long d = 1; d * d <= n; ++d) {
    if (n % d != 0) continue;
    list.push_back(d);
    if (d * d != n) list.push_back(n / d);
  }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace liesl
