#include "mbs/levelset/closed_curve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace liesl::levelset {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Points = Eigen::Matrix2Xd;

constexpr int kSamples = 8;  // chords a span in the search for the nearest point
constexpr int kNewton = 12;

double cross(const Vector2d& a, const Vector2d& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Uniform cubic B-spline: the four functions of a span at t in [0, 1] and two derivatives.
struct Cubic {
  std::array<double, 4> b, d, dd;
  explicit Cubic(double t) {
    const double s = 1 - t;
    b = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6,
         t * t * t / 6};
    d = {-s * s / 2, (3 * t * t - 4 * t) / 2, -(3 * s * s - 4 * s) / 2, t * t / 2};
    dd = {s, 3 * t - 2, 3 * s - 2, t};
  }
};

struct CurvePoint {
  Vector2d at, d, dd;
  double weight = 1;  ///< W of the rational curve
};

struct Nearest {
  Vector2d at, normal;        ///< inward
  double phi = 0, place = 0;  ///< curve parameter: span + t
};

class ClosedCurve final : public LevelSet {
 public:
  ClosedCurve(CurveKind kind, const std::vector<Vector2d>& points, std::vector<double> weights)
      : kind_(kind), n_(static_cast<int>(points.size())) {
    if (n_ < (kind == CurveKind::Polyline ? 3 : 4))
      throw std::invalid_argument("a closed curve needs at least " +
                                  std::to_string(kind == CurveKind::Polyline ? 3 : 4) +
                                  " points, got " + std::to_string(n_));
    if (kind == CurveKind::Nurbs && weights.empty()) weights.assign(n_, 1.0);
    if (weights.size() != (kind == CurveKind::Nurbs ? points.size() : 0))
      throw std::invalid_argument("a NURBS curve has one weight a point, other curves have none");
    for (int i = 0; i < n_; ++i) {
      parameters_.push_back({"p" + std::to_string(i) + ".x", points[i][0]});
      parameters_.push_back({"p" + std::to_string(i) + ".y", points[i][1]});
    }
    for (std::size_t i = 0; i < weights.size(); ++i)
      parameters_.push_back({"w" + std::to_string(i), weights[i], "-", 0});
    if (kind == CurveKind::Spline) {  // control points c: (c_{i-1} + 4 c_i + c_{i+1})/6 = p_i
      Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n_, n_);
      for (int i = 0; i < n_; ++i) {
        A(i, i) += 4.0 / 6;
        A(i, (i + 1) % n_) += 1.0 / 6;
        A(i, (i + n_ - 1) % n_) += 1.0 / 6;
      }
      control_of_points_ = A.inverse();
    }
    set(start().data());
  }

  using LevelSet::set;
  void set(const double* p) override {
    c_ = Eigen::Map<const Points>(p, 2, n_);
    if (kind_ == CurveKind::Spline) c_ = (c_ * control_of_points_.transpose()).eval();
    w_ = kind_ == CurveKind::Nurbs
             ? Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(p + 2 * n_, n_))
             : Eigen::VectorXd::Ones(n_);
    sample();
  }

  double value(const Vector3d& x) const override { return nearest(x.head<2>()).phi; }

  double evaluate(const Vector3d& x, Vector3d& dx, double* dp) const override {
    const Nearest f = nearest(x.head<2>());
    dx << f.normal, 0;
    if (dp) parameter_gradient(f, dp);
    return f.phi;
  }

  std::string error() const override {
    for (int i = 0; i < n_; ++i)
      if (!(w_[i] > 0)) return "weight w" + std::to_string(i) + " is not positive";
    const int m = static_cast<int>(samples_.cols());
    for (int i = 0; i < m; ++i)
      for (int j = i + 2; j < m - (i == 0 ? 1 : 0); ++j)
        if (chords_cross(i, j)) return "the outline crosses itself";
    return std::abs(area_) > 0 ? "" : "the outline encloses nothing";
  }

 private:
  bool smooth() const { return kind_ != CurveKind::Polyline; }
  int per_span() const { return smooth() ? kSamples : 1; }
  Vector2d sample_at(int i) const { return samples_.col(i % samples_.cols()); }
  int control(int span, int k) const { return (span + k + n_ - 1) % n_; }

  bool chords_cross(int i, int j) const {
    const Vector2d a = sample_at(i), b = sample_at(i + 1), c = sample_at(j), d = sample_at(j + 1);
    return cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
           cross(d - c, a - c) * cross(d - c, b - c) < 0;
  }

  /// gamma = sum b_k w_k c_k / sum b_k w_k and two derivatives at place = span + t.
  CurvePoint point(double place) const {
    place -= n_ * std::floor(place / n_);
    const int span = std::min(static_cast<int>(place), n_ - 1);
    const Cubic cubic(place - span);
    Vector2d a = Vector2d::Zero(), a1 = a, a2 = a;
    double W = 0, W1 = 0, W2 = 0;
    for (int k = 0; k < 4; ++k) {
      const int i = control(span, k);
      const Vector2d wc = w_[i] * c_.col(i);
      a += cubic.b[k] * wc, a1 += cubic.d[k] * wc, a2 += cubic.dd[k] * wc;
      W += cubic.b[k] * w_[i], W1 += cubic.d[k] * w_[i], W2 += cubic.dd[k] * w_[i];
    }
    CurvePoint c;
    c.weight = W;
    c.at = a / W;
    c.d = (a1 - W1 * c.at) / W;
    c.dd = (a2 - 2 * W1 * c.d - W2 * c.at) / W;
    return c;
  }

  void sample() {
    const int m = n_ * per_span();
    samples_.resize(2, m);
    for (int i = 0; i < m; ++i)
      samples_.col(i) = smooth() ? point(static_cast<double>(i) / kSamples).at : c_.col(i);
    area_ = 0;
    for (int i = 0; i < m; ++i) area_ += 0.5 * cross(sample_at(i), sample_at(i + 1));
  }

  Nearest nearest(const Vector2d& x) const {
    double best = std::numeric_limits<double>::infinity(), along = 0;
    int chord = 0;
    const int m = static_cast<int>(samples_.cols());
    for (int i = 0; i < m; ++i) {
      const Vector2d a = samples_.col(i), ab = sample_at(i + 1) - a;
      const double t = std::clamp((x - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
      const double dd = (x - a - t * ab).squaredNorm();
      if (dd < best) best = dd, chord = i, along = t;
    }
    return smooth() ? on_curve(x, (chord + along) / kSamples) : on_polyline(x, chord, along);
  }

  /// Newton on (gamma - x) . gamma' = 0, from the nearest chord and held to its neighbourhood.
  Nearest on_curve(const Vector2d& x, double place) const {
    const double low = place - 1.5 / kSamples, high = place + 1.5 / kSamples;
    CurvePoint c = point(place);
    for (int k = 0; k < kNewton; ++k) {
      const double f = (c.at - x).dot(c.d), slope = c.d.squaredNorm() + (c.at - x).dot(c.dd);
      const double step = -f / (slope > 0.1 * c.d.squaredNorm() ? slope : c.d.squaredNorm());
      const double next = std::clamp(place + step, low, high);
      const double moved = std::abs(next - place);
      place = next;
      c = point(place);
      if (moved < 1e-15 * n_) break;
    }
    const Vector2d inward = Vector2d(-c.d[1], c.d[0]).normalized() * (area_ < 0 ? -1 : 1);
    return {c.at, inward, inward.dot(x - c.at), place};
  }

  Nearest on_polyline(const Vector2d& x, int chord, double along) const {
    const Vector2d a = c_.col(chord), ab = sample_at(chord + 1) - a;
    const Vector2d inward = Vector2d(-ab[1], ab[0]).normalized() * (area_ < 0 ? -1 : 1);
    const Vector2d at = a + along * ab;
    if (along > 0 && along < 1) return {at, inward, inward.dot(x - at), chord + along};
    const double distance = (x - at).norm();
    if (distance == 0) return {at, inward, 0, chord + along};
    const double sign = inside(x) ? 1 : -1;
    return {at, sign / distance * (x - at), sign * distance, chord + along};
  }

  /// Even-odd rule on the polygon.
  bool inside(const Vector2d& x) const {
    bool in = false;
    for (int i = 0; i < n_; ++i) {
      const Vector2d a = c_.col(i), b = sample_at(i + 1);
      if ((a[1] > x[1]) != (b[1] > x[1]) &&
          x[0] < a[0] + (x[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        in = !in;
    }
    return in;
  }

  void parameter_gradient(const Nearest& f, double* dp) const {
    std::fill_n(dp, size(), 0.0);
    Eigen::Map<Points> dpoints(dp, 2, n_);
    const double place = f.place - n_ * std::floor(f.place / n_);
    const int span = std::min(static_cast<int>(place), n_ - 1);
    if (!smooth()) {
      dpoints.col(span) -= (1 - (place - span)) * f.normal;
      dpoints.col((span + 1) % n_) -= (place - span) * f.normal;
      return;
    }
    const Cubic cubic(place - span);
    double W = 0;
    for (int k = 0; k < 4; ++k) W += cubic.b[k] * w_[control(span, k)];
    for (int k = 0; k < 4; ++k) {
      const int i = control(span, k);
      dpoints.col(i) -= cubic.b[k] * w_[i] / W * f.normal;
      if (kind_ == CurveKind::Nurbs)
        dp[2 * n_ + i] -= cubic.b[k] / W * f.normal.dot(c_.col(i) - f.at);
    }
    if (kind_ == CurveKind::Spline) dpoints = (dpoints * control_of_points_).eval();
  }

  CurveKind kind_;
  int n_;
  Eigen::MatrixXd control_of_points_;
  Points c_, samples_;
  Eigen::VectorXd w_;
  double area_ = 0;  ///< signed; > 0 counter-clockwise
};

}  // namespace

LevelSetPtr closed_curve(CurveKind kind, const std::vector<Vector2d>& points,
                         std::vector<double> weights) {
  return std::make_unique<ClosedCurve>(kind, points, std::move(weights));
}

}  // namespace liesl::levelset
