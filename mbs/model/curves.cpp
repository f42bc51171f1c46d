/// @file
/// Frames on lines, arcs and splines.

#include "mbs/model/curves.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "mbs/model/cubic_spline.hpp"

namespace liesl {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi;

std::string text(const Vector3d& v) { return fmt::format("[{}, {}, {}]", v[0], v[1], v[2]); }

/// The part of `a` normal to the unit vector `t`, normalised; zero if a is parallel to t.
Vector3d normal_part(const Vector3d& a, const Vector3d& t) {
  const Vector3d n = a - a.dot(t) * t;
  return n.norm() > 1e-6 * a.norm() ? Vector3d(n.normalized()) : Vector3d(Vector3d::Zero());
}

/// [x y z] from two unit vectors normal to each other.
Matrix3d axes_from_z(const Vector3d& x, const Vector3d& z) {
  Matrix3d R;
  R << x, z.cross(x), z;
  return R;
}

void check_elements(int n) {
  if (n < 1)
    throw std::invalid_argument(fmt::format("beam: expected at least 1 element, got {}", n));
}

/// Rotation about the section's x axis.
Matrix3d twist(double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::UnitX()).toRotationMatrix();
}

/// Applies the pre-twist and checks that log(H_A^-1 H_B) is well away from its limit pi.
std::vector<SE3> finished(std::vector<SE3> frames, double pre_twist) {
  const double n = double(frames.size() - 1);
  for (std::size_t i = 1; i < frames.size(); ++i) frames[i].R *= twist(pre_twist * double(i) / n);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double angle = SO3::log(frames[i - 1].R.transpose() * frames[i].R).norm();
    const bool many_turns = std::abs(pre_twist) / n >= 0.99 * pi;
    if (angle >= 0.99 * pi || many_turns)
      throw std::invalid_argument(
          fmt::format("beam: expected elements that turn by less than pi, got {} rad in element {} "
                      "of {}; use more elements",
                      many_turns ? std::abs(pre_twist) / n : angle, i, frames.size() - 1));
  }
  return frames;
}

/// The arc's normal or its opposite: along +Z, else +Y, else +X.
Vector3d upward(const Vector3d& normal) {
  for (int axis : {2, 1, 0})
    if (std::abs(normal[axis]) > 1e-6) return normal[axis] > 0 ? normal : Vector3d(-normal);
  return normal;
}

}  // namespace

Matrix3d section_axes(const Vector3d& tangent, const Vector3d& up) {
  if (!(tangent.norm() > 0 && tangent.allFinite()))
    throw std::invalid_argument(
        fmt::format("beam axis: expected a direction, got {}", text(tangent)));
  const Vector3d x = tangent.normalized();
  if (up.norm() > 0) {
    const Vector3d y = normal_part(up, x);
    if (y.isZero())
      throw std::invalid_argument(fmt::format(
          "beam: expected `up` across the axis, got {} parallel to the axis {}; it is the "
          "direction of the section's y axis",
          text(up), text(x)));
    return axes_from_z(x, x.cross(y));
  }
  const Vector3d z = normal_part(Vector3d::UnitZ(), x);
  return axes_from_z(x, z.isZero() ? normal_part(Vector3d::UnitY(), x) : z);
}

std::vector<SE3> straight(const Vector3d& from, const Vector3d& to, int n,
                          const Orientation& orientation) {
  check_elements(n);
  if (!((to - from).norm() > 0))
    throw std::invalid_argument(
        fmt::format("straight beam: expected two different ends, got {} twice", text(from)));
  const Matrix3d R = section_axes(to - from, orientation.up);
  std::vector<SE3> frames;
  for (int i = 0; i <= n; ++i) {
    const double s = double(i) / n;
    frames.emplace_back(R, (1 - s) * from + s * to);
  }
  return finished(std::move(frames), orientation.pre_twist);
}

Arc Arc::with_radius(const Vector3d& from, const Vector3d& tangent, const Vector3d& normal,
                     double radius, double angle) {
  if (!(radius > 0 && std::isfinite(radius)))
    throw std::invalid_argument(fmt::format("arc: expected a radius > 0 (m), got {}", radius));
  const Vector3d side = normal.cross(tangent);
  if (!(side.norm() > 1e-6 * normal.norm() * tangent.norm()))
    throw std::invalid_argument(fmt::format("arc: expected a normal across the tangent {}, got {}",
                                            text(tangent), text(normal)));
  return {from, tangent, from + radius * side.normalized(), angle};
}

/// Centre of the circle through three points: u = b - a, w = c - a, N = u x w,
/// centre - a = (|w|^2 N x u + |u|^2 w x N)/(2 |N|^2).
Arc Arc::through(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d u = b - a, w = c - a, N = u.cross(w);
  if (!(N.norm() > 1e-9 * u.norm() * w.norm()))
    throw std::invalid_argument(
        fmt::format("arc: expected three points that are not on a line, got {}, {}, {}; a straight "
                    "beam needs no "
                    "arc",
                    text(a), text(b), text(c)));
  const Vector3d to_centre =
      (w.squaredNorm() * N.cross(u) + u.squaredNorm() * w.cross(N)) / (2 * N.squaredNorm());
  const Vector3d n = N.normalized(), r0 = -to_centre, r1 = w - to_centre;
  const double angle = std::atan2(n.dot(r0.cross(r1)), r0.dot(r1));
  return {a, n.cross(r0), a + to_centre, angle > 0 ? angle : angle + 2 * pi};
}

/// x = from + radius (sin(theta) t + (1 - cos(theta)) m), R = exp(theta n~) R_0, n = t x m.
std::vector<SE3> arc(const Arc& a, int n, const Orientation& orientation) {
  check_elements(n);
  if (!(a.angle > 0 && a.angle <= 2 * pi * (1 + 1e-12)))
    throw std::invalid_argument(fmt::format(
        "arc: expected an angle in (0, 2 pi] rad, got {}; the arc turns towards its centre",
        a.angle));
  const Vector3d spoke = a.centre - a.from;
  const double radius = spoke.norm();
  if (!(radius > 0 && a.tangent.norm() > 0) ||
      std::abs(spoke.dot(a.tangent)) > 1e-6 * radius * a.tangent.norm())
    throw std::invalid_argument(fmt::format(
        "arc: expected a tangent normal to the line from the start to the centre {}, got {}",
        text(spoke), text(a.tangent)));
  const Vector3d m = spoke.normalized(), t = normal_part(a.tangent, m), normal = t.cross(m);
  const Matrix3d R0 =
      orientation.up.norm() > 0 ? section_axes(t, orientation.up) : axes_from_z(t, upward(normal));
  std::vector<SE3> frames;
  for (int i = 0; i <= n; ++i) {
    const double theta = a.angle * i / n, half = std::sin(theta / 2);
    const Matrix3d R = Eigen::AngleAxisd(theta, normal).toRotationMatrix() * R0;
    frames.emplace_back(R, a.from + radius * (std::sin(theta) * t + 2 * half * half * m));
  }
  return finished(std::move(frames), orientation.pre_twist);
}

/// Minimal twist by the double reflection method, error O(step^4)
/// [W. Wang, B. Juettler, D. Zheng, Y. Liu, ACM Trans. Graph. 27 (2008) 2].
std::vector<SE3> spline(const std::vector<Vector3d>& points, int n,
                        const Orientation& orientation) {
  check_elements(n);
  const CubicSpline curve(points);
  const int parts = std::max(16, 16 * int(points.size()) / n);  // reflections an element
  Vector3d x = points.front(), t = curve.derivative(0).normalized();
  const Matrix3d R0 = section_axes(t, orientation.up);
  Vector3d z = R0.col(2);
  std::vector<SE3> frames = {{R0, x}};
  for (int i = 1; i <= n * parts; ++i) {
    const double tau = curve.parameter(curve.length() * i / (n * parts));
    const Vector3d x1 = curve.position(tau), t1 = curve.derivative(tau).normalized();
    const Vector3d v = (x1 - x).normalized();
    const Vector3d z_reflected = z - 2 * v.dot(z) * v, t_reflected = t - 2 * v.dot(t) * v;
    const Vector3d w = (t1 - t_reflected).normalized();
    z = normal_part(z_reflected - 2 * w.dot(z_reflected) * w, t1);
    x = x1, t = t1;
    if (i % parts == 0) frames.emplace_back(axes_from_z(t, z), x);
  }
  return finished(std::move(frames), orientation.pre_twist);
}

}  // namespace liesl
