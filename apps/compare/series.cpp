#include "apps/compare/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "apps/output/file.hpp"

namespace liesl {

const char* name_of(Norm norm) {
  return norm == Norm::Final ? "final" : norm == Norm::Max ? "max" : "rms";
}

double Series::at(double time, int c) const {
  const auto value = [&](std::size_t k) {
    return values[k * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
  };
  const std::size_t n = t.size();
  const auto above =
      static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  const double same = 1e-9 * (t.back() - t.front());
  for (std::size_t k : {above, above - 1})
    if (k < n && std::abs(t[k] - time) <= same) return value(k);
  const std::size_t points = std::min<std::size_t>(4, n);
  const std::size_t first = std::clamp<std::size_t>(above, 2, n - points + 2) - 2;
  double sum = 0;
  for (std::size_t i = first; i < first + points; ++i) {  // Lagrange
    double weight = 1;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (time - t[j]) / (t[i] - t[j]);
    sum += weight * value(i);
  }
  return sum;
}

Series combine(const std::vector<double>& weights, const std::vector<Series>& series) {
  const Series& coarsest =
      *std::min_element(series.begin(), series.end(),
                        [](const Series& a, const Series& b) { return a.t.size() < b.t.size(); });
  Series sum{coarsest.components, coarsest.t, std::vector<double>(coarsest.values.size(), 0.0)};
  const auto C = static_cast<std::size_t>(sum.components);
  for (std::size_t k = 0; k < sum.t.size(); ++k)
    for (std::size_t c = 0; c < C; ++c)
      for (std::size_t i = 0; i < series.size(); ++i)
        sum.values[k * C + c] += weights[i] * series[i].at(sum.t[k], static_cast<int>(c));
  return sum;
}

namespace {

/// Norm of what `component(k, c)` gives over n instants.
template <class Component>
double norm_over(const Series& a, Norm norm, const Component& component) {
  const std::size_t n = a.t.size();
  double largest = 0, sum = 0;
  for (std::size_t k = norm == Norm::Final ? n - 1 : 0; k < n; ++k) {
    double square = 0;
    for (int c = 0; c < a.components; ++c) square += std::pow(component(k, c), 2);
    largest = std::max(largest, std::sqrt(square));
    sum += square;
  }
  return norm == Norm::Rms ? std::sqrt(sum / static_cast<double>(n)) : largest;
}

double value(const Series& a, std::size_t k, int c) {
  return a.values[k * static_cast<std::size_t>(a.components) + static_cast<std::size_t>(c)];
}

}  // namespace

double distance(const Series& a, const Series& b, Norm norm) {
  return norm_over(a, norm, [&](std::size_t k, int c) { return value(a, k, c) - b.at(a.t[k], c); });
}

double size_of(const Series& a, Norm norm) {
  return norm_over(a, norm, [&](std::size_t k, int c) { return value(a, k, c); });
}

void write_series(const std::filesystem::path& path, const Series& a, const Series& b) {
  std::string text = "time [s]";
  for (const char* side : {"a", "b"})
    for (int c = 0; c < a.components; ++c) text += fmt::format(",{}{}", side, c);
  for (std::size_t k = 0; k < a.t.size(); ++k) {
    text += fmt::format("\n{}", a.t[k]);
    for (int c = 0; c < a.components; ++c) text += fmt::format(",{}", value(a, k, c));
    for (int c = 0; c < a.components; ++c) text += fmt::format(",{}", b.at(a.t[k], c));
  }
  output::replace_file(path, text + "\n");
}

std::pair<Series, Series> read_series(const std::filesystem::path& path) {
  std::istringstream text(output::read_file(path));
  std::string line;
  std::getline(text, line);
  Series a, b;
  a.components = b.components = static_cast<int>(std::count(line.begin(), line.end(), ',') / 2);
  while (std::getline(text, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double x = 0;
    numbers >> x;
    a.t.push_back(x);
    b.t.push_back(x);
    for (Series* side : {&a, &b})
      for (int c = 0; c < side->components && numbers >> x; ++c) side->values.push_back(x);
  }
  return {a, b};
}

}  // namespace liesl
