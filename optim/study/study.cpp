#include "optim/study/study.hpp"

namespace liesl {

bool has_static_image(const ResponseSpec& r, const Mechanism& mechanism) {
  const int body = limited_body(r);
  if (body < 0 || body >= static_cast<int>(mechanism.bodies.size())) return false;
  const auto& kind = mechanism.bodies[static_cast<std::size_t>(body)].kind;
  switch (r.kind) {
    case ResponseKind::Displacement:
    case ResponseKind::Elongation:
      return !std::holds_alternative<RigidSpec>(kind);
    case ResponseKind::Deflection:
    case ResponseKind::Stress:
    case ResponseKind::Compliance:
      return std::holds_alternative<BeamSpec>(kind);
    default:
      return false;
  }
}

}  // namespace liesl
