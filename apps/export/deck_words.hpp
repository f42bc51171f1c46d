#pragma once
/// @file
/// How the texts of decks name what their loads are of.

#include <fmt/format.h>

#include <string>

namespace liesl {

/// A motion has instants; a scene of statics or modes has an equilibrium, reached along a load
/// factor.
struct DeckWords {
  bool equilibrium = false;

  std::string state() const { return equilibrium ? "equilibrium" : "motion"; }
  std::string a_state() const { return equilibrium ? "an equilibrium" : "a motion"; }
  std::string forces() const { return equilibrium ? "Gravity is" : "Gravity and inertia are"; }
  /// Heading of a column.
  std::string column() const { return equilibrium ? "load factor [-]" : "time [s]"; }
  std::string at(double abscissa) const {
    return equilibrium ? fmt::format("load factor {:.9g}", abscissa)
                       : fmt::format("{:.9g} s", abscissa);
  }
  /// "1 instant", "5 instants".
  std::string count(std::size_t n) const {
    return fmt::format("{} {}{}", n, equilibrium ? "load factor" : "instant", n == 1 ? "" : "s");
  }
};

}  // namespace liesl
