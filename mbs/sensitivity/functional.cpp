#include "mbs/sensitivity/functional.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace liesl {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Weights of the trapezoidal rule.
VectorXd weights_of(const VectorXd& t) {
  VectorXd w = VectorXd::Zero(t.size());
  for (Index n = 0; n + 1 < t.size(); ++n) {
    const double half = 0.5 * (t[n + 1] - t[n]);
    w[n] += half;
    w[n + 1] += half;
  }
  return w;
}

/// dJ/dy_n = dJ/dv_n y_n/|y_n|.
MatrixXd through_norms(const VectorXd& by_v, const MatrixXd& y, const VectorXd& v) {
  MatrixXd by_y = MatrixXd::Zero(y.rows(), y.cols());
  for (Index n = 0; n < y.cols(); ++n)
    if (v[n] > 0) by_y.col(n) = by_v[n] / v[n] * y.col(n);
  return by_y;
}

/// Weights of a mean: those of the trapezoidal rule by their sum, equal ones where no time passes.
VectorXd shares_of(const VectorXd& w) {
  const double T = w.sum();
  if (T > 0) return w / T;
  return VectorXd::Constant(w.size(), 1. / static_cast<double>(w.size()));
}

/// (sum share v^p)^(1/p), with v in units of its peak m.
double mean_power(double p, const VectorXd& share, const VectorXd& v, double m, VectorXd& by_v) {
  if (m == 0) return 0;
  const double mean = share.dot((v / m).array().pow(p).matrix());
  const double value = m * std::pow(mean, 1 / p);
  by_v = (value / (mean * m) * share.array() * (v / m).array().pow(p - 1)).matrix();
  return value;
}

double kreisselmeier_steinhauser(double rho, const VectorXd& v, int peak, VectorXd& by_v) {
  const double m = v[peak];
  if (m == 0) return 0;
  const VectorXd e = (rho * (v.array() / m - 1)).exp().matrix();
  const double sum = e.sum();
  by_v = e / sum;
  by_v[peak] += 1 + std::log(sum) / rho - by_v.dot(v) / m;
  return m * (1 + std::log(sum) / rho);
}

struct Word {
  FunctionalKind kind;
  const char* text;
  const char* number;  ///< what its number is to be; null: it has none
};
constexpr Word kWords[] = {
    {FunctionalKind::Peak, "peak", nullptr},         {FunctionalKind::At, "at", "a time"},
    {FunctionalKind::Integral, "integral", nullptr}, {FunctionalKind::Mean, "mean", nullptr},
    {FunctionalKind::Rms, "rms", nullptr},           {FunctionalKind::PNorm, "p", "at least 1"},
    {FunctionalKind::Ks, "ks", "above 0"},
};

bool in_range(FunctionalKind kind, double number) {
  if (!std::isfinite(number)) return false;
  if (kind == FunctionalKind::PNorm) return number >= 1;
  return kind == FunctionalKind::Ks ? number > 0 : number >= 0;
}

}  // namespace

const std::vector<std::string>& functional_words() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    for (const Word& w : kWords) all.emplace_back(w.text);
    return all;
  }();
  return words;
}

std::string to_string(const FunctionalSpec& functional) {
  const Word& word = kWords[static_cast<int>(functional.kind)];
  return word.number ? fmt::format("{}={}", word.text, functional.number) : word.text;
}

std::optional<FunctionalSpec> functional_of(const std::string& text) {
  const auto equals = text.find('=');
  for (const Word& word : kWords) {
    if (text.substr(0, equals) != word.text) continue;
    if ((word.number != nullptr) != (equals != std::string::npos)) return {};
    if (!word.number) return FunctionalSpec{word.kind, 0};
    double number = 0;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + equals + 1, last, number);
    if (error != std::errc{} || end != last || !in_range(word.kind, number)) return {};
    return FunctionalSpec{word.kind, number};
  }
  return {};
}

std::string unit(const FunctionalSpec& functional, const std::string& unit) {
  return functional.kind == FunctionalKind::Integral ? unit + " s" : unit;
}

FunctionalValue evaluate(const FunctionalSpec& functional, const VectorXd& t, const MatrixXd& y,
                         int peak) {
  const VectorXd w = weights_of(t), v = y.colwise().norm().transpose();
  const bool scalar = y.rows() == 1;
  if (peak < 0) v.maxCoeff(&peak);
  VectorXd by_v = VectorXd::Zero(y.cols());
  const auto of_norms = [&](double value, int step = -1) {
    return FunctionalValue{value, step, through_norms(by_v, y, v)};
  };
  const auto linear = [&](const VectorXd& weights, int step = -1) {
    by_v = weights;
    if (!scalar) return of_norms(weights.dot(v), step);
    return FunctionalValue{y.row(0).dot(weights), step, weights.transpose()};
  };
  switch (functional.kind) {
    case FunctionalKind::Peak:
      by_v[peak] = 1;
      return of_norms(v[peak], peak);
    case FunctionalKind::At: {
      int step = 0;
      (t.array() - functional.number).abs().minCoeff(&step);
      return linear(VectorXd::Unit(t.size(), step), step);
    }
    case FunctionalKind::Integral:
      return linear(w);
    case FunctionalKind::Mean:
      return linear(shares_of(w));
    case FunctionalKind::Rms:
      return of_norms(mean_power(2, shares_of(w), v, v[peak], by_v));
    case FunctionalKind::PNorm:
      return of_norms(mean_power(functional.number, shares_of(w), v, v[peak], by_v));
    case FunctionalKind::Ks:
      return of_norms(kreisselmeier_steinhauser(functional.number, v, peak, by_v));
  }
  return {};
}

}  // namespace liesl
