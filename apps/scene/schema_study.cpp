/// @file
/// Table of the keys of a study. Rows: path, type, unit, preset, range, doc, size, options, when.
#include "apps/scene/schema.hpp"

namespace liesl {

// clang-format off
std::vector<Key> study_keys() {
  std::vector<Key> keys{
    {"name", Type::Text, "", "\"study\"", kAny, "Title of the study."},
    {"scene", Type::Text, "", kRequired, kAny, "File of the scene, relative to the study."},
    {"set", Type::Named, "", kOptional, kAny, "Keys of the scene to change in this study, as in \"simulation.step\" = 5e-5."},
    {"set.*", Type::Any, "", kOptional, kAny, "Value of a scene key."},

    {"design", Type::Named, "", kRequired, kAny, "What may change, by name."},
    {"design.*", Type::Table, "", kOptional, kAny, "One dimension of the sections of a beam."},
    {"design.*.of", Type::Texts, "", kRequired, kAny, "Beam, or several beams that share the values."},
    {"design.*.property", Type::Texts, "", kRequired, kAny, "Dimension of the section (diameter, thickness, width, ...), or several that share the value."},
    {"design.*.groups", Type::Integer, "", "1", {.lower = 1}, "Runs of neighbouring elements with a value each, as even as possible."},
    {"design.*.bounds", Type::Vector, "m", kRequired, kPositive, "Least and largest value.", 2},
    {"design.*.start", Type::NumberOrList, "m", kOptional, kPositive, "First value, or one a group. Default: as in the scene."},

    {"objective", Type::Table, "", kRequired, kAny, "What is minimised."},
    {"objective.minimize", Type::Choice, "", "\"mass\"", kAny, "Quantity.", 0, "mass"},
    {"objective.of", Type::Texts, "", kRequired, kAny, "Bodies that are summed."},

    {"constraints", Type::Named, "", kRequired, kAny, "What must hold at every time step, by name: |response| <= limit. Of displacement, deflection, elongation, stress, compliance."},
    {"constraints.*", Type::Table, "", kOptional, kAny, "A response as in a scene, or `use`, and its limit."},
    {"constraints.*.use", Type::Text, "", kOneOf, kAny, "Name of a response of the scene."},
    {"constraints.*.limit", Type::Number, "of the response", kRequired, kPositive, "Largest absolute value (norm of a vector)."},
  };
  for (Key& key : response_keys("constraints.*")) keys.push_back(std::move(key));
  const std::vector<Key> rest{
    {"supports", Type::Named, "", kOptional, kAny, "Where a part is held in its static problem, by body. Default: \"start\"."},
    {"supports.*", Type::Texts, "", kOptional, kAny, "\"inertia_relief\", or nodes with their held directions, together statically determinate: \"start\" (all six), [\"start:xyz,rx\", \"end:yz\"]."},

    {"cycle", Type::Table, "", kOptional, kAny, "How simulation and optimisation take turns."},
    {"cycle.max", Type::Integer, "", "30", {1, 10000}, "Cycles at most."},
    {"cycle.tolerance", Type::Number, "-", "1e-3", {0, 1, true}, "Relative change of the loads at which the cycle is closed."},
    {"cycle.objective_tolerance", Type::Number, "-", "1e-3", {0, 1, true}, "Relative change of the objective at which the cycle is closed."},
    {"cycle.feasibility", Type::Number, "-", "1e-3", {0, 1, true}, "Allowed relative violation of a limit."},
    {"cycle.move_limit", Type::Number, "-", "0.5", {0, 1, true}, "Largest relative change of a variable in a cycle, at first."},
    {"cycle.screening", Type::Number, "-", "0.1", {0, 1}, "Keep load cases within this share of a constraint's largest value; others that turn out to violate it are added."},
    {"cycle.min_cases", Type::Integer, "", "10", {.lower = 1}, "Load cases kept per constraint at least."},
    {"cycle.optimizer", Type::Choice, "", "\"ipopt\"", kAny, "Optimiser of the static problem.", 0, "ipopt mma ccsaq slsqp"},
    {"cycle.model", Type::Choice, "", "\"exact\"", kAny, "Static problem with its exact Hessian, or convex separable models of it.", 0, "exact separable"},
    {"cycle.optimality", Type::Choice, "", "\"auto\"", kAny, "Check the optimality conditions of the motion itself at the end, by two simulations a variable: up to 12 variables, always, or never.", 0, "auto always never"},
  };
  keys.insert(keys.end(), rest.begin(), rest.end());
  return keys;
}
// clang-format on

}  // namespace liesl
