#pragma once
/// @file
/// What `SpatialSegmentBeam` is made of: directions of segments, angles between them, axes that the
/// smallest rotations carry from one to the next.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "liegroup/se3.hpp"
#include "liegroup/smallest_rotation.hpp"
#include "mbs/bodies/segment_law.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

/// The part of a vector across a direction t, and across x.
inline Vec3 across(const Vec3& t, const Vec3& a) { return a - t.dot(a) * t; }
inline Vec3 across_x(const Vec3& a) { return {0, a[1], a[2]}; }

/// Turn of the axes that the smallest rotation takes from a to b, by the turn of the axes at a (x
/// along a) and the change db of b, inertial: b x db + b (turn . (a + b) - (a x b) . db)/(1 + a .
/// b). It is linear; rates obey it as changes do.
inline Vec3 carried_turn(const Vec3& a, const Vec3& turn, const Vec3& b, const Vec3& db) {
  const double about = (turn.dot(a + b) - a.cross(b).dot(db)) / (1 + a.dot(b));
  return b.cross(db) + about * b;
}

/// A quantity and its rate.
struct RatedScalar {
  double x = 0, d = 0;
};
struct Rated {
  Vec3 x, d;

  Rated(const Vec3& value = Vec3::Zero(), const Vec3& rate = Vec3::Zero()) : x(value), d(rate) {}
  RatedScalar dot(const Rated& b) const { return {x.dot(b.x), d.dot(b.x) + x.dot(b.d)}; }
  Rated cross(const Rated& b) const { return {x.cross(b.x), d.cross(b.x) + x.cross(b.d)}; }
  RatedScalar norm() const {
    const double n = x.norm();
    return {n, x.dot(d) / n};
  }
};
inline RatedScalar operator+(double a, const RatedScalar& b) { return {a + b.x, b.d}; }
inline RatedScalar operator/(const RatedScalar& a, const RatedScalar& b) {
  return {a.x / b.x, (a.d - a.x / b.x * b.d) / b.x};
}
inline Rated operator+(const Rated& a, const Rated& b) { return {a.x + b.x, a.d + b.d}; }
inline Rated operator-(const Rated& a, const Rated& b) { return {a.x - b.x, a.d - b.d}; }
inline Rated operator*(const RatedScalar& a, const Rated& b) {
  return {a.x * b.x, a.d * b.x + a.x * b.d};
}
inline Rated operator/(const Rated& a, const RatedScalar& b) { return RatedScalar{1, 0} / b * a; }
/// The part of a across a direction t.
inline Rated across(const Rated& t, const Rated& a) { return a - t.dot(a) * t; }

/// y . carried_turn = on_direction . db + on_turn . turn.
struct CarriedBack {
  Rated on_direction, on_turn;

  CarriedBack(const Rated& a, const Rated& b, const Rated& y) {
    const RatedScalar about = y.dot(b) / (1 + a.dot(b));
    on_direction = y.cross(b) - about * a.cross(b);
    on_turn = about * (a + b);
  }
};

/// Length and direction.
struct SpatialSegment {
  double l;
  Vec3 t;  ///< along it
};

/// Of neighbouring directions a, b with angle phi: q = k a x b, k = phi/sin phi as a function of z
/// = cos phi. With w = tan(phi/2)^2 and g = atan(sqrt w)/sqrt w it is k = 2 g/(1 + z), dk/dz = -2
/// (g + 2 g'/(1 + z))/(1 + z)^2: -1/3 in line.
struct Misalignment {
  Vec3 a, b, cross;
  double z, k, slope;

  Misalignment(const Vec3& before, const Vec3& after) : a(before), b(after) {
    cross = a.cross(b);
    z = a.dot(b);
    const double in = 1 / (1 + z), w = cross.squaredNorm() * in * in;
    double g, g_w;
    if (w < kSeries) {  // to w^7: exact to round-off
      g = -1. / 15, g_w = 0;
      for (const double c : {1. / 13, -1. / 11, 1. / 9, -1. / 7, 1. / 5, -1. / 3, 1.}) {
        g_w = g + w * g_w;
        g = c + w * g;
      }
    } else {
      const double u = std::sqrt(w);
      g = std::atan(u) / u;
      g_w = (1 / (1 + w) - g) / (2 * w);
    }
    k = 2 * g * in;
    slope = -2 * in * in * (g + 2 * in * g_w);
  }
  Vec3 q() const { return k * cross; }

 private:
  static constexpr double kSeries = 0.01;
};

/// Of a vector in inertial axes, by the increments of up to four neighbouring nodes.
struct NodalGradient {
  using Block = Eigen::Matrix<double, 3, 6>;
  int first = 0, count = 0;
  std::array<Block, 4> at = {Block::Zero(), Block::Zero(), Block::Zero(), Block::Zero()};

  /// X (increment of x_{e+1} - x_e)
  void add(const SE3* H, int e, const Mat3& X) {
    at[e - first].leftCols<3>() -= X * H[e].R;
    at[e + 1 - first].leftCols<3>() += X * H[e + 1].R;
    count = std::max(count, e + 2 - first);
  }
  /// X (change of the x axis of a frame)
  void add_axis(const SE3* H, int node, const Mat3& X) {
    at[node - first].rightCols<3>() -= X * H[node].R * hat(Vec3::UnitX());
    count = std::max(count, node + 1 - first);
  }
  void add(const NodalGradient& other, const Mat3& X) {
    for (int k = 0; k < other.count; ++k) at[other.first + k - first] += X * other.at[k];
    count = std::max(count, other.first + other.count - first);
  }
  /// Change of the vector by increments of all nodes.
  Vec3 product(const double* delta) const {
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < count; ++k)
      sum += at[k] * Eigen::Map<const SE3::Tangent>(delta + 6 * (first + k));
    return sum;
  }
  /// h += gradient of y . vector
  void add_transposed(const Vec3& y, double* h) const {
    for (int k = 0; k < count; ++k)
      Eigen::Map<SE3::Tangent>(h + 6 * (first + k)) += at[k].transpose() * y;
  }
};

}  // namespace liesl
