#pragma once
/// @file
/// Which beams can have elements of fourth order: the one table of reasons that refusals and the
/// default of scenes are taken from.

#include <optional>
#include <string>
#include <vector>

#include "mbs/model/mechanism.hpp"

namespace liesl {

/// Why a beam cannot be of order 4: "beam 'rod' of order 4 " + what, and what is expected.
struct OrderObjection {
  std::string what;
  std::string expected;
};

/// All that a beam itself has against order 4 under a formalism; empty: nothing.
std::vector<OrderObjection> against_order_4(const BeamSpec& beam, Formalism formalism);

/// What a load has against order 4 of the beam over which it is spread: "load 'wind' over a beam of
/// order 4 " + what.
std::optional<OrderObjection> against_order_4(const LoadSpec& spread);

/// The order of the elements of body `body` where none is asked for: 4 if neither the beam nor a
/// load over it has anything against it, else 2. @pre the body is a beam
int default_order(const Mechanism& mechanism, int body);

}  // namespace liesl
