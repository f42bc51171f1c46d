/// @file
/// Table of the keys of a comparison. Rows: path, type, unit, preset, range, doc, size, options,
/// when.
#include "apps/input/schema.hpp"

namespace liesl {

// clang-format off
std::vector<Key> compare_keys() {
  return {
    {"name", Type::Text, "", "\"comparison\"", kAny, "Title of the comparison; without it the name of its file."},
    {"scene", Type::Text, "", kOneOf, kAny, "File of the scene, relative to the comparison; it must be dynamic. Rows are simulations. Beams are of order 2 in rows and reference where neither the scene nor the comparison gives `bodies.NAME.beam.order`."},
    {"study", Type::Text, "", kOneOf, kAny, "File of a study, relative to the comparison: rows are optimisations, by `grid.method`, `optimizer`, `treatment`, `approximation` and `vary` over any keys of the study; `quantity`, `reference`, `beams` and `repeats` are of scenes."},
    {"repeats", Type::Integer, "", "3", {1, 1000}, "Timed runs of each row, after one that warms up. `cpu_s` is their median. An optimisation runs once."},
    {"time_limit", Type::Number, "s", "60", kPositive, "CPU time of one run; a row that needs more is stopped. An optimisation stops after the cycle."},
    {"beams", Type::Texts, "", kOptional, kAny, "Beams that `elements` is for. Default: all."},
    {"set", Type::Named, "", kOptional, kAny, "Keys of the scene (of the study) to change in every run, as in \"simulation.duration\" = 0.5."},
    {"set.*", Type::Any, "", kOptional, kAny, "Value of a scene key."},

    {"quantity", Type::Table, "", kOptional, kAny, "What the error is measured by; required of a scene."},
    {"quantity.response", Type::Text, "", kRequired, kAny, "Name of a response of the scene."},
    {"quantity.norm", Type::Choice, "", "\"final\"", kAny, "Of the difference to the reference: at the end, largest, or root mean square over time.", 0, "final max rms"},

    {"reference", Type::Table, "", kOptional, kAny, "Two fine runs; rows are compared with their mean, and their difference is the floor. Without it rows have no error."},
    {"reference.formalisms", Type::Pair, "", kRequired, kAny, "Two different ones."},
    {"reference.elements", Type::Integer, "", kOptional, {1, 100000}, "Of the same beams as `grid.elements`. Default: as in the scene."},
    {"reference.step", Type::Number, "s", kRequired, kPositive, "Time step."},
    {"reference.tolerance", Type::Number, "-", "1e-9", {0, 1e-2, true}, "Residual relative to the forces."},
    {"reference.rho_inf", Type::Number, "-", kOptional, {0, 1}, "Spectral radius at infinity. Default: as in the scene."},
    {"reference.extrapolate", Type::Choice, "", "\"none\"", kAny, "To the limit of fine meshes, small steps or both, from runs with half the elements or twice the step: (4 fine - coarse)/3, as both are of order 2.", 0, "none mesh step both"},

    {"grid", Type::Table, "", kRequired, kAny, "What the rows differ in; they are all combinations, also with `vary`. The last varies fastest."},
    {"grid.formalism", Type::List, "", kOptional, kAny, "simulation.formalism."},
    {"grid.elements", Type::List, "", kOptional, kAny, "Elements of every beam, or of `beams`."},
    {"grid.step", Type::List, "", kOptional, kAny, "simulation.step."},
    {"grid.tolerance", Type::List, "", kOptional, kAny, "simulation.tolerance."},
    {"grid.rho_inf", Type::List, "", kOptional, kAny, "simulation.rho_inf."},
    {"grid.tangent", Type::List, "", kOptional, kAny, "simulation.tangent."},
    {"grid.method", Type::List, "", kOptional, kAny, "Of a study: cycle.method. Rows of \"esl\" with another treatment than \"auto\" are left out: its end is the same. So are those of \"esl1\" with an aggregate (\"ks\", \"functional\", \"p_norm\") where \"full\" is compared as well, whose steps it then takes."},
    {"grid.optimizer", Type::List, "", kOptional, kAny, "Of a study: cycle.optimizer."},
    {"grid.approximation", Type::List, "", kOptional, kAny, "Of a study: cycle.approximation."},
    {"grid.treatment", Type::List, "", kOptional, kAny, "Of a study: `treatment` of all constraints."},

    {"models", Type::Named, "", kOptional, kAny, "Further rows of a scene by name, which stands in the column `formalism`: other keys of the scene, such as a meshed part in the place of a beam. They have the other axes of the grid and its reference; needs `grid.formalism`."},
    {"models.*", Type::Table, "", kOptional, kAny, "One model."},
    {"models.*.set", Type::Named, "", kRequired, kAny, "Keys of the scene to change, whole tables among them, as in \"bodies.rod\" = { solid = { ... } }."},
    {"models.*.set.*", Type::Any, "", kOptional, kAny, "Value of a scene key."},
    {"models.*.elements", Type::Table, "", kOptional, kAny, "Meshes in the place of `grid.elements`."},
    {"models.*.elements.key", Type::Texts, "", kRequired, kAny, "Key of the scene, or several that share the value, as in \"bodies.rod.solid.mesh.cells.0\"."},
    {"models.*.elements.values", Type::List, "", kRequired, kAny, "Values of the key."},

    {"vary", Type::Named, "", kOptional, kAny, "Further axes by name, over any keys of the scene (of the study). What changes the mechanism or its motion has a reference of its own for each combination."},
    {"vary.*", Type::Table, "", kOptional, kAny, "One axis."},
    {"vary.*.key", Type::Texts, "", kRequired, kAny, "Key of the scene, as for --set, or several that share the value."},
    {"vary.*.values", Type::List, "", kRequired, kAny, "Values of the key."},
  };
}
// clang-format on

}  // namespace liesl
