#include "optim/problems/treatment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace liesl {
namespace {

constexpr int kBeside = 3;        // records on either side of a maximum that KS sums up
constexpr int kNear = 10;         // records beside a maximum where one of another design counts
constexpr double kLeast = 0.5;    // of the largest maximum: those that count
constexpr double kSmooth = 1e-8;  // e_0 of a mean excess: of a maximum about 1e-5 above the limit
constexpr double kRho = 500;  // of KS: with 7 records at most ln(7)/500 = 0.4 % above the largest

int largest(const std::vector<double>& v) {
  return static_cast<int>(std::max_element(v.begin(), v.end()) - v.begin());
}

/// Local maxima above half of the largest.
std::vector<int> maxima(const std::vector<double>& v) {
  std::vector<int> out;
  const int size = static_cast<int>(v.size());
  const double least = kLeast * v[static_cast<std::size_t>(largest(v))];
  for (int n = 0; n < size; ++n) {
    const bool rises = n == 0 || v[n] >= v[n - 1], falls = n + 1 == size || v[n] > v[n + 1];
    if (rises && falls && v[n] >= least) out.push_back(n);
  }
  return out;
}

/// Records about a maximum, the nearest maxima on both sides not passed.
std::pair<int, int> window(int n, std::size_t size) {
  return {std::max(0, n - kBeside), std::min(static_cast<int>(size) - 1, n + kBeside)};
}

/// limit (1 + e/(e + e_0)^(1/3)), e the mean of <v/limit - 1>. Of a maximum that exceeds the limit
/// by d, e is of order d^(3/2): e^(2/3) is as far above the limit as the maximum, and e_0 keeps it
/// smooth where the limit begins to be exceeded.
Aggregate mean_excess(const std::vector<double>& t, const std::vector<double>& v, double limit) {
  Aggregate out{largest(v), limit, {}};
  const std::vector<double> w = time_weights(t);
  double e = 0;
  for (std::size_t n = 0; n < v.size(); ++n)
    if (v[n] > limit) e += w[n] * (v[n] / limit - 1);
  const double root = std::cbrt(e + kSmooth);
  out.value += limit * e / root;
  const double slope = (2 * e / 3 + kSmooth) / ((e + kSmooth) * root);
  out.by_limit = 0;
  for (std::size_t n = 0; n < v.size(); ++n) {
    if (v[n] <= limit) continue;
    out.weight[static_cast<int>(n)] = slope * w[n];
    out.by_limit += slope * w[n] * v[n] / limit;
  }
  return out;
}

/// (mean of v^p)^(1/p), scaled by the largest value against overflow.
Aggregate p_norm(const std::vector<double>& t, const std::vector<double>& v, double p) {
  Aggregate out{largest(v), 0, {}};
  const double most = v[static_cast<std::size_t>(out.record)];
  if (!(most > 0)) return out;
  const std::vector<double> w = time_weights(t);
  double sum = 0;
  for (std::size_t n = 0; n < v.size(); ++n) sum += w[n] * std::pow(v[n] / most, p);
  out.value = most * std::pow(sum, 1 / p);
  for (std::size_t n = 0; n < v.size(); ++n)
    if (v[n] > 0) out.weight[static_cast<int>(n)] = w[n] * std::pow(v[n] / out.value, p - 1);
  return out;
}

/// KS = max + ln(sum exp(rho (v - max)/max)) max/rho about each maximum; value: the maximum itself.
std::vector<Aggregate> smooth_maxima(const std::vector<double>& v) {
  std::vector<Aggregate> out;
  for (const int n : maxima(v)) {
    Aggregate a{n, v[n], {}};
    const auto [first, last] = window(n, v.size());
    double sum = 0;
    for (int k = first; k <= last; ++k) sum += std::exp(kRho * (v[k] / v[n] - 1));
    for (int k = first; k <= last; ++k) a.weight[k] = std::exp(kRho * (v[k] / v[n] - 1)) / sum;
    out.push_back(std::move(a));
  }
  return out;
}

}  // namespace

std::vector<double> time_weights(const std::vector<double>& t) {
  std::vector<double> w(t.size(), 1.0 / static_cast<double>(t.size()));
  if (t.size() < 2 || !(t.back() > t.front())) return w;
  const double duration = t.back() - t.front();
  for (std::size_t n = 0; n < t.size(); ++n)
    w[n] = 0.5 * (t[std::min(n + 1, t.size() - 1)] - t[n > 0 ? n - 1 : 0]) / duration;
  return w;
}

std::set<int> treated_records(Treatment treatment, const std::vector<double>& v) {
  std::set<int> out;
  if (treatment == Treatment::Worst) return {largest(v)};
  const double least = kLeast * v[static_cast<std::size_t>(largest(v))];
  if (treatment == Treatment::All || aggregates(treatment)) {
    for (std::size_t n = 0; n < v.size(); ++n)
      if (v[n] >= least || aggregates(treatment)) out.insert(static_cast<int>(n));
    return out;
  }
  const std::vector<int> largest_nearby = maxima(v);
  return {largest_nearby.begin(), largest_nearby.end()};
}

std::vector<std::set<int>> maxima_of(const std::vector<Eigen::VectorXd>& series) {
  std::vector<std::set<int>> out;
  for (const Eigen::VectorXd& v : series)
    out.push_back(v.size() == 0 ? std::set<int>()
                                : treated_records(Treatment::Maxima, {v.begin(), v.end()}));
  return out;
}

std::vector<std::set<int>> near_maxima(std::vector<std::set<int>> records,
                                       const std::vector<Eigen::VectorXd>& series) {
  const std::vector<std::set<int>> now = maxima_of(series);
  for (std::size_t r = 0; r < records.size(); ++r)
    std::erase_if(records[r], [&](int n) {
      const auto next = now[r].lower_bound(n - kNear);
      return n >= series[r].size() || next == now[r].end() || *next > n + kNear;
    });
  return records;
}

double treated_value(const ConstraintSpec& limit, const std::vector<double>& times,
                     const std::vector<double>& v) {
  if (v.empty()) return 0;
  if (limit.treatment == Treatment::Functional) return mean_excess(times, v, limit.limit).value;
  if (limit.treatment == Treatment::PNorm) return p_norm(times, v, limit.p).value;
  return v[static_cast<std::size_t>(largest(v))];
}

std::vector<Aggregate> aggregates_of(const ConstraintSpec& limit, const std::vector<double>& times,
                                     const std::vector<double>& v) {
  if (limit.treatment == Treatment::Functional) return {mean_excess(times, v, limit.limit)};
  if (limit.treatment == Treatment::PNorm) return {p_norm(times, v, limit.p)};
  return smooth_maxima(v);
}

}  // namespace liesl
