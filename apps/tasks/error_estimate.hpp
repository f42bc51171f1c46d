#pragma once
/// @file
/// Error of a figure by a refinement (Richardson 1911, see mbs/solvers/richardson.hpp): with R the
/// given one and R_f that of half the mesh or step, p the order,
///
///   error = |R - R_f| / (1 - 2^-p).
///
/// One of twice the mesh or step shows the order; where it is lower, it counts.

#include <optional>

namespace liesl {

constexpr double kLeastOrder = 0.5;   ///< below, nothing converges
constexpr double kResolution = 1e-9;  ///< of the largest value: differences below are rounding

/// One figure on meshes (or steps) of the given and half the length, and twice it.
struct Refinement {
  double given = 0, finer = 0;
  std::optional<double> coarser = {};
};

/// What a refinement says of the error of the given figure.
struct ErrorEstimate {
  double error = 0;                     ///< >= 0
  bool below = false;                   ///< the given figure is below the finer one
  std::optional<double> observed = {};  ///< order, where three figures show one
  bool as_expected = true;              ///< within a half of the order, or nothing to see
};

/// @param order expected  @param resolution differences below are rounding
ErrorEstimate estimate_error(const Refinement& r, double order, double resolution);

}  // namespace liesl
