#pragma once
/// @file
/// Which beams can have elements of fourth order: the one table of reasons that refusals and the
/// default of scenes are taken from.

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

/// The order of the elements of body `body` where none is asked for: 4 if the beam has nothing
/// against it, else 2; 2 with damping, too, and under a moment per length, beside which the shear
/// forces of elements of order 4 are not those of the sections (LineLoad). @pre the body is a beam
int default_order(const Mechanism& mechanism, int body);

}  // namespace liesl
