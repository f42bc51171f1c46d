/// @file
/// Second derivatives by the usual tridiagonal system (C. de Boor, A Practical Guide to Splines,
/// ch. IV), arc length by Gauss-Legendre quadrature.

#include "mbs/model/cubic_spline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mbs/linalg/dense.hpp"

namespace liesl {

using Eigen::Vector3d;

CubicSpline::CubicSpline(std::vector<Vector3d> points) : points_(std::move(points)) {
  if (points_.size() < 2)
    throw std::invalid_argument(
        fmt::format("spline: expected at least two points, got {}", points_.size()));
  knots_ = {0};
  for (std::size_t i = 1; i < points_.size(); ++i) {
    const double chord = (points_[i] - points_[i - 1]).norm();
    if (!(chord > 0 && std::isfinite(chord)))
      throw std::invalid_argument(fmt::format(
          "spline: expected neighbouring points that differ, got a distance of {} m between points "
          "{} and {}; leave one out",
          chord, i, i + 1));
    knots_.push_back(knots_.back() + chord);
  }
  solve_curvatures();
  tabulate_length();
}

/// h_{i-1} M_{i-1} + 2 (h_{i-1} + h_i) M_i + h_i M_{i+1} = 6 (d_i - d_{i-1}), d = slopes of chords.
void CubicSpline::solve_curvatures() {
  const Eigen::Index n = Eigen::Index(points_.size());
  second_ = Eigen::MatrixX3d::Zero(n, 3);
  if (n == 2) return;
  const auto h = [&](Eigen::Index i) {
    return knots_[std::size_t(i + 1)] - knots_[std::size_t(i)];
  };
  const auto chord = [&](Eigen::Index i) -> Vector3d {
    return (points_[std::size_t(i + 1)] - points_[std::size_t(i)]) / h(i);
  };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX3d b = Eigen::MatrixX3d::Zero(n, 3);
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    A.block<1, 3>(i, i - 1) << h(i - 1), 2 * (h(i - 1) + h(i)), h(i);
    b.row(i) = 6 * (chord(i) - chord(i - 1));
  }
  if (n == 3) {
    A.block<1, 2>(0, 0) << 1, -1;
    A.block<1, 2>(2, 1) << 1, -1;
  } else {  // (M_1 - M_0)/h_0 = (M_2 - M_1)/h_1, likewise at the end
    A.block<1, 3>(0, 0) << h(1), -h(0) - h(1), h(0);
    A.block<1, 3>(n - 1, n - 3) << h(n - 2), -h(n - 3) - h(n - 2), h(n - 3);
  }
  second_ = linalg::solve(A, b);
}

void CubicSpline::tabulate_length() {
  constexpr int parts = 8;
  fine_ = {0};
  arc_length_ = {0};
  for (std::size_t i = 1; i < knots_.size(); ++i)
    for (int k = 1; k <= parts; ++k) {
      const double tau = knots_[i - 1] + (knots_[i] - knots_[i - 1]) * k / parts;
      arc_length_.push_back(arc_length_.back() + length_between(fine_.back(), tau));
      fine_.push_back(tau);
    }
}

std::size_t CubicSpline::segment(double tau) const {
  const auto inner = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, tau);
  return std::size_t(inner - knots_.begin()) - 1;
}

Vector3d CubicSpline::position(double tau) const {
  const std::size_t i = segment(tau);
  const double h = knots_[i + 1] - knots_[i], a = (knots_[i + 1] - tau) / h, b = 1 - a;
  const Eigen::Index k = Eigen::Index(i);
  const Vector3d M0 = second_.row(k), M1 = second_.row(k + 1);
  return a * points_[i] + b * points_[i + 1] -
         h * h / 6 * (a * (1 - a * a) * M0 + b * (1 - b * b) * M1);
}

Vector3d CubicSpline::derivative(double tau) const {
  const std::size_t i = segment(tau);
  const double h = knots_[i + 1] - knots_[i], a = (knots_[i + 1] - tau) / h, b = 1 - a;
  const Eigen::Index k = Eigen::Index(i);
  const Vector3d M0 = second_.row(k), M1 = second_.row(k + 1);
  return (points_[i + 1] - points_[i]) / h + h / 6 * ((1 - 3 * a * a) * M0 + (3 * b * b - 1) * M1);
}

/// Five Gauss points. @pre both ends in one segment
double CubicSpline::length_between(double tau0, double tau1) const {
  constexpr std::array<double, 5> x = {-0.9061798459386640, -0.5384693101056831, 0,
                                       0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 5> w = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889,
                                       0.4786286704993665, 0.2369268850561891};
  const double middle = (tau0 + tau1) / 2, half = (tau1 - tau0) / 2;
  double sum = 0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += w[k] * derivative(middle + half * x[k]).norm();
  return half * sum;
}

/// Newton from the linear guess within one part of the table; |r'| is near 1.
double CubicSpline::parameter(double s) const {
  const auto inner = std::upper_bound(arc_length_.begin() + 1, arc_length_.end() - 1, s);
  const std::size_t i = std::size_t(inner - arc_length_.begin()) - 1;
  const double tau0 = fine_[i], tau1 = fine_[i + 1], rest = s - arc_length_[i];
  double tau = tau0 + (tau1 - tau0) * rest / (arc_length_[i + 1] - arc_length_[i]);
  for (int iteration = 0; iteration < 20; ++iteration) {
    const double error = length_between(tau0, tau) - rest;
    if (std::abs(error) <= 1e-15 * length()) break;
    tau = std::clamp(tau - error / derivative(tau).norm(), tau0, tau1);
  }
  return tau;
}

}  // namespace liesl
