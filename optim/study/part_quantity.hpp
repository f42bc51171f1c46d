#pragma once
/// @file
/// What quantities of meshed parts are called, and their units. Inline: whoever reads studies asks,
/// also a program without Ipopt.

#include <array>
#include <string_view>

#include "mbs/system/response_value.hpp"
#include "optim/study/study.hpp"

namespace liesl {

struct PartQuantity {
  SolidResponse response;
  const char *name, *unit;
};

/// In the order of SolidResponse; stress and compliance as the responses of a motion are.
inline const std::array<PartQuantity, 5>& part_quantities() {
  static const std::array<PartQuantity, 5> rows = [] {
    const auto as = [](SolidResponse response, ResponseKind kind) {
      ResponseSpec of_kind;
      of_kind.kind = kind;
      return PartQuantity{response, name_of(kind), unit(of_kind, Mechanism())};
    };
    return std::array<PartQuantity, 5>{{{SolidResponse::Output, "displacement", "m"},
                                        as(SolidResponse::Compliance, ResponseKind::Compliance),
                                        as(SolidResponse::Stress, ResponseKind::Stress),
                                        {SolidResponse::Mass, "mass", "kg"},
                                        {SolidResponse::Frequency, "frequency", "Hz"}}};
  }();
  return rows;
}

inline const PartQuantity& part_quantity(SolidResponse response) {
  return part_quantities()[static_cast<std::size_t>(response)];
}
/// Mass if no quantity has this name.
inline SolidResponse part_quantity(std::string_view name) {
  for (const PartQuantity& q : part_quantities())
    if (q.name == name) return q.response;
  return SolidResponse::Mass;
}

}  // namespace liesl
