#pragma once
/// @file
/// What is said of an iteration that fails, and of forces that are not finite.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "mbs/system/model.hpp"

namespace liesl {

/// "the iteration diverged", and why where a body knows.
template <FrameGroup G>
std::string divergence(const Model<G>& model, const State<G>& s) {
  std::string what = "the iteration diverged";
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (const auto why =
            model.bodies[b]->no_forces(s.H.data() + model.first_node(static_cast<int>(b)));
        !why.empty())
      what += "; " + why;
  return what;
}

/// "(relative residual 1e-3)"
inline std::string relative_residual(double residual) {
  return std::isfinite(residual) ? fmt::format("(relative residual {:.2g})", residual)
                                 : "(relative residual beyond all numbers)";
}

}  // namespace liesl
