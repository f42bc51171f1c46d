#pragma once
/// @file
/// What a limit with `surrogate = "mechanism"` needs of its study. Inline: whoever reads studies
/// asks, also a program without Ipopt.

#include <optional>
#include <variant>

#include "mbs/model/mechanism.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// Why a limit has no static problem of the whole mechanism, and what is expected instead.
struct NoMechanismStatics {
  const char* why;
  const char* expected;
};

/// Of a limit with SurrogateKind::Mechanism; none if the study has nothing against it.
inline std::optional<NoMechanismStatics> without_mechanism_statics(const StudySpec& study,
                                                                   const ConstraintSpec& limit,
                                                                   const Mechanism& mechanism) {
  using enum ResponseKind;
  const CycleMethod method = study.cycle.method;
  if (method != CycleMethod::Auto && method != CycleMethod::Esl1)
    return NoMechanismStatics{"this cycle.method takes no static problem of the mechanism",
                              "cycle.method = \"esl1\""};
  if (aggregates(limit.treatment))
    return NoMechanismStatics{"its treatment has the motion's own gradients",
                              "treatment = \"auto\""};
  if (!study.shapes.empty() || without_statics(study))
    return NoMechanismStatics{"outlines or constants of the mechanism change with the design",
                              "sizes of sections as the only variables"};
  const ResponseKind kind = limit.response.kind;
  if (kind == Velocity || kind == AngularVelocity || kind == Acceleration ||
      kind == AngularAcceleration || kind == JointForce || kind == DriveForce || kind == Energy)
    return NoMechanismStatics{
        "statics has no velocities, and the loads give the forces in joints, whatever bends",
        "a limit on positions, deformation, section forces or stress"};
  for (const DesignSpec& design : study.design)
    for (const int body : design.bodies) {
      const auto* beam =
          std::get_if<BeamSpec>(&mechanism.bodies.at(static_cast<std::size_t>(body)).kind);
      if (beam && model_of(*beam, mechanism.formalism) == BeamModel::Modal)
        return NoMechanismStatics{"the modes of a beam in a floating frame change with its section",
                                  "beams of another formalism"};
    }
  return {};
}

}  // namespace liesl
