#include "mbs/model/beam_order.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <optional>

#include "mbs/sections/section_law.hpp"

namespace liesl {
namespace {

using Objection = std::optional<OrderObjection>;

Objection against(const Section& section, const Material& material) {
  const SectionLaw law = section_law(section, material);
  const auto of = [&section](const std::string& which) {
    return "has the section '" + section.name + "', " + which;
  };
  if (law.K.llt().info() != Eigen::Success)
    return OrderObjection{of("whose stiffness is not positive definite"), "order = 2"};
  if (!law.M.topRightCorner<3, 3>().isZero(0))
    return OrderObjection{of("whose inertia couples translation and rotation"),
                          "order = 2, or an axis through the centres of mass"};
  if (!law.M.topLeftCorner<3, 3>().isApprox(law.M(0, 0) * Mat3::Identity()))
    return OrderObjection{of("whose mass is not the same in all directions"), "order = 2"};
  return {};
}

const char* as_text(BeamModel as) {
  return as == BeamModel::Rigid ? "rigid" : as == BeamModel::Modal ? "modal" : "segments";
}

}  // namespace

std::vector<OrderObjection> against_order_4(const BeamSpec& beam, Formalism formalism) {
  std::vector<OrderObjection> all;
  if (formalism != Formalism::SE3)
    all.push_back({std::string("in the formalism ") + to_string(formalism),
                   "order = 2, or simulation.formalism = \"se3\""});
  if (beam.as != BeamModel::AsFormalism)
    all.push_back({std::string("as \"") + as_text(beam.as) + "\"", "order = 2"});
  const Section* before = nullptr;  // neighbours of one name share it
  for (const Section& section : beam.sections) {
    if (before && before->name == section.name && beam.ends.empty()) continue;
    before = &section;
    if (Objection found = against(section, beam.material)) {
      all.push_back(std::move(*found));
      break;
    }
  }
  return all;
}

int default_order(const Mechanism& mechanism, int body) {
  const auto& spec = mechanism.bodies[static_cast<std::size_t>(body)];
  const auto& beam = std::get<BeamSpec>(spec.kind);
  const auto& loads = mechanism.loads;
  const bool moment = std::any_of(loads.begin(), loads.end(), [body](const LoadSpec& load) {
    return load.spread && load.port.body == body && load.moment.norm() > 0;
  });
  const bool second =
      moment || beam.damping > 0 || !against_order_4(beam, mechanism.formalism).empty();
  return second ? 2 : 4;
}

}  // namespace liesl
