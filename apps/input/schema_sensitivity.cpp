/// @file
/// Table of the keys of a sensitivity. Rows: path, type, unit, preset, range, doc, size, options,
/// when.
#include "apps/input/schema.hpp"

namespace liesl {

// clang-format off
std::vector<Key> sensitivity_keys() {
  return {
    {"name", Type::Text, "", "\"sensitivity\"", kAny, "Title; without it the name of its file."},
    {"scene", Type::Text, "", kRequired, kAny, "File of the scene, relative to this one; a motion with responses g."},
    {"set", Type::Named, "", kOptional, kAny, "Keys of the scene to change, as in \"simulation.duration\" = 0.5."},
    {"set.*", Type::Any, "", kOptional, kAny, "Value of a scene key."},
    {"by", Type::Texts, "", kRequired, kAny, "Numbers of the scene that are the parameters, by their keys, as in \"sections.rod.diameter\"; \"KEY+KEY\": numbers that change by the same amount, as the end of a rod and the place of what it carries."},
    {"functionals", Type::Texts, "", kOptional, kAny, "Of each response: integral (psi, the integral of g over the motion), mean, peak, rms, at=TIME, p=P, ks=RHO. Default: peak, integral, mean, rms."},
    {"method", Type::Choice, "", "\"auto\"", kAny, "Form of the sensitivities; auto: what is faster.", 0, "auto direct adjoint"},
  };
}
// clang-format on

}  // namespace liesl
