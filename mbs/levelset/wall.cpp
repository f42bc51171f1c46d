#include "mbs/levelset/wall.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mbs/linalg/dense.hpp"

namespace liesl::levelset {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kIterations = 40, kFootIterations = 60;
constexpr double kDifference = 1e-4;  // of the spacing of the samples: step of second derivatives
constexpr double kLongestStep = 2;    // of the spacing, in one iteration
constexpr double kConverged = 1e-11;  // residual, slopes being 1 and lengths in spacings
constexpr double kStands = 1e-8;  // residual that may be left where it no longer falls: flat sides
constexpr double kFarthest = 8;   // spacings from the best sample
constexpr double kFlat = 1e-8;    // curvature times spacing that counts as none

/// The void of a feature: signed distance by the nearest point of the outline, or nu = -sign phi.
class Void {
 public:
  Void(const Part& part, double spacing) : part_(part), tolerance_(1e-13 * spacing) {}

  struct Value {
    double d = 0;      ///< positive in the void
    Vector3d n;        ///< grad d
    Vector3d foot;     ///< where derivatives are taken
    double slope = 1;  ///< |grad nu| there
    bool exact = true;
  };

  /// nu itself, as the distance to first order.
  Value as_is(const Vector3d& x) const {
    Value v{0, {}, x, 1, false};
    v.d = nu(x, v.n);
    return v;
  }

  /// Nearest point of the outline: c moves along the outline by the part of x - c that is not
  /// normal to it, by secant steps (Barzilai, Borwein 1988), and is pulled back onto it.
  Value at(const Vector3d& x) const {
    Vector3d c = x, g, before = x, rest_before = Vector3d::Zero();
    double step = 1;
    for (int k = 0; k < kFootIterations; ++k) {
      for (int pull = 0; pull < 8; ++pull) {
        const double phi = nu(c, g);
        const double size = g.squaredNorm();
        if (!(size > 0) || std::abs(phi) <= 1e-2 * tolerance_) break;
        c -= phi / size * g;
      }
      const Vector3d n = g.normalized();
      const Vector3d rest = (x - c) - n * n.dot(x - c);
      if (rest.norm() <= tolerance_) return {n.dot(x - c), n, c, g.norm(), true};
      if (k > 0) {
        const Vector3d moved = c - before, change = rest_before - rest;
        const double product = moved.dot(change);
        step = product > 0 ? std::clamp(moved.squaredNorm() / product, 0.05, 5.0) : 1.0;
      }
      before = c;
      rest_before = rest;
      c += step * rest;
    }
    return as_is(x);
  }

  Matrix3d curvature(const Vector3d& x, double h) const {
    Matrix3d H;
    for (int i = 0; i < 3; ++i)
      H.col(i) = (at(x + h * Vector3d::Unit(i)).n - at(x - h * Vector3d::Unit(i)).n) / (2 * h);
    return 0.5 * (H + H.transpose());
  }

  void add_derivative(const Value& v, double weight, VectorXd& out) const {
    Vector3d g;
    VectorXd dp(part_.shape->size());
    part_.shape->evaluate(v.foot, g, dp.data());
    out.segment(part_.first, dp.size()) -= weight * part_.sign / v.slope * dp;
  }

 private:
  double nu(const Vector3d& x, Vector3d& slope) const {
    const double phi = part_.shape->evaluate(x, slope, nullptr);
    slope *= -part_.sign;
    return -part_.sign * phi;
  }

  const Part& part_;
  double tolerance_;
};

/// Where w a' + (1 - w) b' = 0 and a = b.
struct Saddle {
  Vector3d x;
  double w = 0.5;
};

/// The share w in [0, 1] that makes |w a' + (1 - w) b'| least.
double best_share(const Vector3d& a, const Vector3d& b) {
  const double size = (a - b).squaredNorm();
  return size > 0 ? std::clamp(b.dot(b - a) / size, 0.0, 1.0) : 0.5;
}

/// Newton's method on (x, t, w): w a' + (1 - w) b' = 0, a = t, b = t. Directions without curvature
/// (extruded shapes, parallel sides) are left alone by the least-norm step.
bool newton(const Void& a, const Void& b, double spacing, Saddle& s) {
  double t = 0, before = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kIterations; ++k) {
    const Void::Value va = a.at(s.x), vb = b.at(s.x);
    if (!va.exact || !vb.exact) return false;
    if (k == 0) {
      t = std::min(va.d, vb.d);
      s.w = best_share(va.n, vb.n);
    }
    Eigen::Matrix<double, 5, 5> J = Eigen::Matrix<double, 5, 5>::Zero();
    const double h = kDifference * spacing;
    J.topLeftCorner<3, 3>() =
        spacing * (s.w * a.curvature(s.x, h) + (1 - s.w) * b.curvature(s.x, h));
    J.block<3, 1>(0, 4) = va.n - vb.n;
    J.block<1, 3>(3, 0) = va.n.transpose();
    J.block<1, 3>(4, 0) = vb.n.transpose();
    J(3, 3) = J(4, 3) = -1;
    Eigen::Matrix<double, 5, 1> r;
    r << s.w * va.n + (1 - s.w) * vb.n, (va.d - t) / spacing, (vb.d - t) / spacing;
    if (!J.allFinite() || !r.allFinite()) return false;
    const double residual = r.norm();
    if (residual <= kConverged || (residual <= kStands && residual >= 0.9 * before))
      return s.w > 0 && s.w < 1;
    before = residual;
    const Eigen::Matrix<double, 5, 1> step = -linalg::shortest_least_squares(J, r, kFlat);
    const double cut = std::min(1.0, kLongestStep / std::max(step.head<4>().norm(), 1e-300));
    s.x += cut * spacing * step.head<3>();
    t += cut * spacing * step[3];
    s.w = std::clamp(s.w + cut * step[4], 0.0, 1.0);
  }
  return false;
}

}  // namespace

VectorXd void_at(const Part& part, const Eigen::Matrix3Xd& samples) {
  VectorXd out(samples.cols());
  for (Eigen::Index i = 0; i < samples.cols(); ++i)
    out[i] = -part.sign * part.shape->value(samples.col(i));
  return out;
}

Wall wall_between(const Part& a, const Part& b, const Eigen::Matrix3Xd& samples, int size) {
  return wall_between(a, b, void_at(a, samples), void_at(b, samples), samples, size);
}

Wall wall_between(const Part& a, const Part& b, const VectorXd& in_a, const VectorXd& in_b,
                  const Eigen::Matrix3Xd& samples, int size) {
  const double extent = (samples.rowwise().maxCoeff() - samples.rowwise().minCoeff()).maxCoeff();
  const double spacing = extent / std::max(1.0, std::sqrt(static_cast<double>(samples.cols())));
  const Void void_a(a, spacing), void_b(b, spacing);
  Eigen::Index best = 0;
  in_a.cwiseMin(in_b).maxCoeff(&best);
  Saddle s{samples.col(best)};
  Saddle refined = s;
  const bool found =
      newton(void_a, void_b, spacing, refined) && (refined.x - s.x).norm() <= kFarthest * spacing;
  if (found) s = refined;
  const Void::Value va = found ? void_a.at(s.x) : void_a.as_is(s.x);
  const Void::Value vb = found ? void_b.at(s.x) : void_b.as_is(s.x);
  if (!found) s.w = best_share(va.n, vb.n);
  Wall wall;
  wall.middle = s.x;
  wall.thickness = -2 * (s.w * va.d + (1 - s.w) * vb.d);
  wall.derivative = VectorXd::Zero(size);
  void_a.add_derivative(va, -2 * s.w, wall.derivative);
  void_b.add_derivative(vb, -2 * (1 - s.w), wall.derivative);
  return wall;
}

}  // namespace liesl::levelset
