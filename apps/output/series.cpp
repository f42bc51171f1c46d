#include "apps/output/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "apps/output/file.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::output {
namespace {

constexpr double kSame = 1e-9;  // instants this far apart, relative to the duration, are one

double duration(const Series& s) { return s.t.empty() ? 0 : s.t.back() - s.t.front(); }

/// Norm of the columns that `difference(k)` gives over n instants.
template <class Difference>
double norm_over(std::size_t n, Norm norm, const Difference& difference) {
  if (n == 0) return 0;
  double largest = 0, sum = 0;
  for (std::size_t k = norm == Norm::Final ? n - 1 : 0; k < n; ++k) {
    const double square = difference(k).squaredNorm();
    largest = std::max(largest, std::sqrt(square));
    sum += square;
  }
  return norm == Norm::Rms ? std::sqrt(sum / static_cast<double>(n)) : largest;
}

auto column(const Series& s, std::size_t k) { return s.values.col(static_cast<long>(k)); }

}  // namespace

const char* name_of(Norm norm) {
  return norm == Norm::Final ? "final" : norm == Norm::Max ? "max" : "rms";
}

Eigen::VectorXd Series::at(double time) const {
  const std::size_t n = t.size();
  const auto above =
      static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  for (std::size_t k : {above, above - 1})
    if (k < n && std::abs(t[k] - time) <= kSame * duration(*this)) return column(*this, k);
  const std::size_t points = std::min<std::size_t>(4, n);
  const std::size_t first = std::clamp<std::size_t>(above, 2, n - points + 2) - 2;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.rows());
  for (std::size_t i = first; i < first + points; ++i) {  // Lagrange
    double weight = 1;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (time - t[j]) / (t[i] - t[j]);
    sum += weight * column(*this, i);
  }
  return sum;
}

template <FrameGroup G>
Series record(const ResponseSpec& response, const Mechanism& mechanism, const Model<G>& model,
              const Trajectory<G>& trajectory) {
  const ResponseValues<G> values(mechanism, model);
  Series series;
  series.values.resize(components(response, G::space_dim == 2), trajectory.size());
  State<G> s = model.initial_state();
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    series.t.push_back(s.t);
    series.values.col(n) = values(response, s);
  }
  return series;
}

Series combine(const std::vector<double>& weights, const std::vector<Series>& series) {
  Series sum =
      *std::min_element(series.begin(), series.end(),
                        [](const Series& a, const Series& b) { return a.t.size() < b.t.size(); });
  sum.values.setZero();
  for (std::size_t k = 0; k < sum.t.size(); ++k)
    for (std::size_t i = 0; i < series.size(); ++i)
      sum.values.col(static_cast<long>(k)) += weights[i] * series[i].at(sum.t[k]);
  return sum;
}

Series thinned(const Series& series, long k) {
  Series thin;
  const auto n = static_cast<long>(series.t.size());
  thin.values.resize(series.values.rows(), (n - 1 + k - 1) / k + 1);
  for (long i = 0; i < thin.values.cols(); ++i) {
    const long from = std::min(i * k, n - 1);
    thin.t.push_back(series.t[static_cast<std::size_t>(from)]);
    thin.values.col(i) = series.values.col(from);
  }
  return thin;
}

double distance(const Series& a, const Series& b, Norm norm) {
  Eigen::VectorXd difference(std::max(a.values.rows(), b.values.rows()));
  return norm_over(a.t.size(), norm, [&](std::size_t k) -> const Eigen::VectorXd& {
    difference.setZero();
    difference.head(a.values.rows()) = column(a, k);
    difference.head(b.values.rows()) -= b.at(a.t[k]);
    return difference;
  });
}

double size_of(const Series& a, Norm norm) {
  return norm_over(a.t.size(), norm, [&](std::size_t k) { return column(a, k); });
}

double relative_distance(const Series& series, const Series& reference) {
  const double same = kSame * duration(reference);
  if (series.t.empty() || reference.t.empty() || series.t.back() < reference.t.back() - same)
    return std::numeric_limits<double>::infinity();
  return distance(reference, series, Norm::Max) / size_of(reference, Norm::Max);
}

void write_series(const std::filesystem::path& path, const Series& a, const Series& b) {
  std::string text = "time [s]";
  for (const char* side : {"a", "b"})
    for (int c = 0; c < a.components(); ++c) text += fmt::format(",{}{}", side, c);
  for (std::size_t k = 0; k < a.t.size(); ++k) {
    text += fmt::format("\n{}", a.t[k]);
    for (const double value : column(a, k)) text += fmt::format(",{}", value);
    for (const double value : b.at(a.t[k])) text += fmt::format(",{}", value);
  }
  replace_file(path, text + "\n");
}

std::pair<Series, Series> read_series(const std::filesystem::path& path) {
  std::istringstream text(read_file(path));
  std::string line;
  std::getline(text, line);
  const auto components = std::count(line.begin(), line.end(), ',') / 2;
  std::vector<double> t, values;
  while (std::getline(text, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double x = 0;
    numbers >> x;
    t.push_back(x);
    while (numbers >> x) values.push_back(x);
  }
  const auto n = static_cast<long>(t.size());
  values.resize(static_cast<std::size_t>(2 * components * n));
  const Eigen::Map<const Eigen::MatrixXd> both(values.data(), 2 * components, n);
  return {{t, both.topRows(components)}, {t, both.bottomRows(components)}};
}

template Series record(const ResponseSpec&, const Mechanism&, const Model<SE2>&,
                       const Trajectory<SE2>&);
template Series record(const ResponseSpec&, const Mechanism&, const Model<SE3>&,
                       const Trajectory<SE3>&);

}  // namespace liesl::output
