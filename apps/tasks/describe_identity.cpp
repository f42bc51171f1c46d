#ifdef LIESL_OPTIM

#include "apps/tasks/describe_identity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace liesl {
namespace {

nlohmann::ordered_json number_or_null(double difference) {
  if (!std::isfinite(difference)) return nullptr;
  return difference;
}

}  // namespace

nlohmann::ordered_json describe_identity(const Identity& identity, const std::string& part,
                                         std::vector<std::string>& warnings) {
  if (!std::isfinite(identity.nonlinear) || !std::isfinite(identity.linear))
    warnings.push_back(
        fmt::format("'{}': the static problem under its equivalent static loads was not solved for "
                    "all of the {} "
                    "load cases tried, so that nothing shows that they give its deformation back; "
                    "more elements "
                    "or a stiffer part may help",
                    part, identity.cases));
  return {{"nonlinear", number_or_null(identity.nonlinear)},
          {"linear", number_or_null(identity.linear)},
          {"cases", identity.cases}};
}

std::string difference_text(double difference) {
  return std::isfinite(difference) ? fmt::format("{:.1e}", difference) : "no solution";
}

}  // namespace liesl

#endif
