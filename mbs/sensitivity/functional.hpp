#pragma once
/// @file
/// Functionals of a response over a motion: one number of its whole history, and the derivative of
/// that number by each value of the history. Chained with dy/dp of the direct form, or as
/// cotangents of the adjoint form, they give gradients.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace liesl {

/// v_n = |y_n|, the norm of vectors; s_n = y_n of scalars, v_n of vectors; w_n: trapezoidal
/// weights.
enum class FunctionalKind {
  Peak,      ///< max v_n; at a peak dy/dt = 0, so that its time may be held
  At,        ///< s at a given time, at the step that is nearest
  Integral,  ///< sum w_n s_n
  Mean,      ///< the same, divided by the duration; of no duration that of the values
  Rms,       ///< root of the mean of v^2
  PNorm,     ///< (mean of v^p)^(1/p)
  Ks  ///< m (1 + ln(sum exp(rho (v_n/m - 1)))/rho), m the peak: between m and m (1 + ln N/rho)
};

struct FunctionalSpec {
  FunctionalKind kind = FunctionalKind::Peak;
  double number = 0;  ///< At: time, s; PNorm: p >= 1; Ks: rho > 0
};

/// "peak", "at", "integral", "mean", "rms", "p", "ks".
const std::vector<std::string>& functional_words();
/// As a user writes it: "peak", "at=0.05", "p=8", "ks=500".
std::string to_string(const FunctionalSpec& functional);
/// @returns nothing if the text is none, see `to_string`
std::optional<FunctionalSpec> functional_of(const std::string& text);
/// Its unit, of a response in `unit`: an integral is in "unit s".
std::string unit(const FunctionalSpec& functional, const std::string& unit);

struct FunctionalValue {
  double value = 0;
  int step = -1;         ///< where the peak, or the given time, is; -1: everywhere
  Eigen::MatrixXd by_y;  ///< components x steps
};

/// Value, and derivative by every y_n. Of a vector that vanishes the derivative is zero.
/// @param t times of all steps, s; increasing  @param y components x steps, at least one step
/// @param peak held at this step, for differences; -1: where v is largest
FunctionalValue evaluate(const FunctionalSpec& functional, const Eigen::VectorXd& t,
                         const Eigen::MatrixXd& y, int peak = -1);

}  // namespace liesl
