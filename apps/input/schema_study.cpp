/// @file
/// Table of the keys of a study. Rows: path, type, unit, preset, range, doc, size, options, when.
#include "apps/input/schema.hpp"

namespace liesl {

namespace {

// clang-format off
/// What varies, and the limits of motions.
std::vector<Key> design_and_limit_keys() {
  return {
    {"name", Type::Text, "", "\"study\"", kAny, "Title of the study; without it the name of its file."},
    {"scene", Type::Text, "", kRequired, kAny, "File of the scene, relative to the study."},
    {"set", Type::Named, "", kOptional, kAny, "Keys of the scene to change in this study, as in \"simulation.step\" = 5e-5."},
    {"set.*", Type::Any, "", kOptional, kAny, "Value of a scene key."},
    {"scenarios", Type::Named, "", kOptional, kAny, "Motions or, of a static scene, equilibria that one design has to stand, by name: speeds, payloads, load sets. Every limit holds in each of them; without this table there is one, that of the scene."},
    {"scenarios.*", Type::Table, "", kOptional, kAny, "One motion, or one load set of a static scene: the scene with some keys changed."},
    {"scenarios.*.set", Type::Named, "", kOptional, kAny, "Keys of the scene to change in it, after those of `set`; none: the scene itself."},
    {"scenarios.*.set.*", Type::Any, "", kOptional, kAny, "Value of a scene key; bodies and their meshes stay."},

    {"design", Type::Named, "", kRequired, kAny, "What may change, by name."},
    {"design.*", Type::Table, "", kOptional, kAny, "One dimension of the sections of a beam, one parameter of the outline of a meshed part, or a constant of a force or rigid body."},
    {"design.*.of", Type::Texts, "", kRequired, kAny, "Beam, or several beams that share the values; a truss or a group of its bars; a meshed part; a force of the scene, a rigid body, a driven joint, or \"simulation\"."},
    {"design.*.property", Type::Texts, "", kOneOf, kAny, "Dimension of the section (diameter, thickness, width, ...), or several that share the value. Of a force `stiffness`, `damping` or `rest`, of a rigid body `mass` (its inertia stays), of a driven joint `drive.table.ROW`, a value of its table (rows from 0), of `simulation` the `duration`: the tables of all drives are stretched, in as many steps. These need the sensitivities of a motion."},
    {"design.*.parameters", Type::Texts, "", kOneOf, kAny, "Parameter of the outline, as \"hole1.a\", or several: the others change with the first."},
    {"design.*.factors", Type::NumberOrList, "-", kOptional, kAny, "Change of each parameter over that of the variable, -1 of a mirror image. Default: 1 each."},
    {"design.*.groups", Type::Integer, "", "1", {.lower = 1}, "Runs of neighbouring elements with a value each, as even as possible."},
    {"design.*.bounds", Type::Vector, "of the value", kRequired, kAny, "Least and largest value; above 0 for dimensions of sections, stiffness, damping and mass.", 2},
    {"design.*.start", Type::NumberOrList, "of the value", kOptional, kAny, "First value, or one a group. Default: as in the scene."},

    {"design.*.values", Type::NumberOrList, "of the value", kOptional, kAny, "Catalogue: the values that it may have, increasing, within the bounds. First comes the continuous optimum, then a search by branch and bound, whose every design is simulated (`cycle.gap`). Not of variables of the motion itself."},

    {"walls", Type::Named, "", kOptional, kAny, "Material that is left between features of a meshed part, by name."},
    {"walls.*", Type::Table, "", kOptional, kAny, "Shortest distance of two outlines."},
    {"walls.*.of", Type::Text, "", kRequired, kAny, "Meshed part."},
    {"walls.*.feature", Type::Text, "", kRequired, kAny, "Feature of its outline. The name of a mirror means the feature and its image, that of the feature the original only."},
    {"walls.*.to", Type::Text, "", kRequired, kAny, "Another feature, or an interface: the distance to its nodes."},
    {"walls.*.least", Type::Number, "m", kRequired, kPositive, "Least thickness."},

    {"objective", Type::Table, "", kRequired, kAny, "What is minimised."},
    {"objective.minimize", Type::Choice, "", "\"mass\"", kAny, "Mass; or of one meshed part under fixed loads the mean compliance of its load cases, or the p-mean of their stress norms. \"weighted\": the sum by `weights`, of a motion or equilibrium, or of one meshed part under fixed loads.", 0, "mass compliance stress weighted"},
    {"objective.of", Type::Texts, "", kRequired, kAny, "Bodies that are summed; trusses."},
    {"objective.weights", Type::Table, "", kOptional, kAny, "What counts how much in a \"weighted\" objective."},
    {"objective.weights.mass", Type::Number, "1/kg", "0", {.lower = 0}, "Of the mass of `of`."},
    {"objective.weights.largest", Type::NumberOrList, "1/(unit)", kOptional, kNotNegative, "Of the largest value, over all steps and scenarios (under fixed [loads] over the load cases), of each of the responses `largest`: one weight for all, or one each."},
    {"objective.weights.frequency", Type::Number, "1/Hz", "0", {.lower = 0}, "Of the lowest natural frequency of the mechanism, which is made large (as in [frequencies]): minus this times it. Under fixed [loads] the lowest free-free frequency of the part."},
    {"objective.weights.compliance", Type::Number, "1/J", "0", {.lower = 0}, "Of the largest compliance of the load cases of a meshed part under fixed [loads]."},
    {"objective.weights.stress", Type::Number, "1/Pa", "0", {.lower = 0}, "Of the largest stress norm of the load cases of a meshed part under fixed [loads]."},
    {"objective.weights.duration", Type::Number, "1/s", "0", {.lower = 0}, "Of the duration, which a variable changes."},
    {"objective.weights.effort", Type::Number, "1/((N m)^2 s)", "0", {.lower = 0}, "Of the integral of the squares of the responses `effort` over the motion."},
    {"objective.effort", Type::Texts, "", kOptional, kAny, "Responses of the scene whose squares are integrated, as the torques of drives (`drive_force`)."},

    {"objective.largest", Type::Texts, "", kOptional, kAny, "Responses of the scene whose largest value is made small: a deflection, the compliance of a beam, a stress."},
    {"objective.count", Type::Integer, "", "1", {1, 20}, "With weights.frequency: how many frequencies may come to lie together."},
    {"objective.at", Type::Number, "s", "0", kNotNegative, "With weights.frequency: the time whose values the drives have in the pose."},
    {"objective.frequency_of", Type::Text, "", kOptional, kAny, "With weights.frequency: the beam alone that it is of, as `frequencies.*.of`. Default: the mechanism."},

    {"constraints", Type::Named, "", kOptional, kAny, "What must hold at every time step (in statics load step), by name: |response| <= limit. Of any response where the motion has sensitivities (cycle.method \"esl1\", \"full\"); of displacement, deflection, elongation, stress, compliance of a beam, of displacement, elongation of a meshed part otherwise. An `axial_stress`, `buckling` or `local_buckling` of a truss, or of a group of its bars, is one of each bar."},
    {"constraints.*", Type::Table, "", kOptional, kAny, "A response as in a scene, or `use`, and its limit."},
    {"constraints.*.use", Type::Text, "", kOneOf, kAny, "Name of a response of the scene."},
    {"constraints.*.mass", Type::Texts, "", kOneOf, kAny, "Bodies whose mass is limited, kg; of a motion or equilibrium (under fixed [loads]: [part_limits])."},
    {"constraints.*.limit", Type::Number, "of the response", kRequired, kPositive, "Largest absolute value (norm of a vector)."},
    {"constraints.*.side", Type::Choice, "", "\"both\"", kAny, "What the limit holds: the absolute value; or of a response with one component only values above zero (up), or only those below (down), so that two constraints give it different limits. One side is told by the gradients of the motion, as limits without a static problem are.", 0, "both up down"},
    {"constraints.*.treatment", Type::Choice, "", "\"auto\"", kAny, "Which constraints a limit over a motion becomes: \"maxima\" over time above half of the largest value; \"neighbours\", the same and, of the motion, those steps at most ten away from one at which designs taken before had theirs; \"worst\", the largest alone; \"all\". They name the load cases that a static problem begins with (of \"all\" those near the largest; cases that turn out to violate the limit are added), or where none tells the limit the steps of the motion itself (of \"all\" every one above half of the largest). \"ks\", a smooth maximum about each; \"functional\" limits the mean excess, \"p_norm\" the mean of order `p` instead of the largest: these three are always of the motion and need cycle.method \"esl1\" or \"full\". \"auto\": \"all\" in static problems, \"neighbours\" of the motion, every step with cycle.method \"direct\".", 0, "auto all maxima neighbours worst functional p_norm ks"},
    {"constraints.*.surrogate", Type::Choice, "", "\"auto\"", kAny, "What tells how the limit follows the design within a step of cycle.method \"esl1\": \"auto\", the static problem of the part that it is on, or where no part tells it as \"motion\"; \"motion\", the values and gradients of the motion, continued by cycle.approximation, as all limits of \"full\"; \"mechanism\", the static problem of the whole mechanism, drives held, for limits on positions, deformation, section forces or stress where the only variables are sizes of sections (of beams that are not in modes). Worth it for deformation of several bodies that follows the loads; where they vibrate it may take more cycles. The optimum is the same.", 0, "auto motion mechanism"},
    {"constraints.*.approximation", Type::Choice, "", "\"auto\"", kAny, "How this limit is continued from the analysed design within a step: as cycle.approximation, or one of its own.", 0, "auto power linear mma additive"},
    {"constraints.*.p", Type::Number, "-", "2", {1, 100}, "Exponent; 2: root mean square.", 0, "", "treatment=p_norm"},
  };
}

/// Parts under fixed loads, frequencies, and the cycle.
std::vector<Key> part_and_cycle_keys() {
  return {
    {"part_limits", Type::Named, "", kOptional, kAny, "What must hold of a meshed part whose outline changes, by name; compliance and stress in every load case, of a motion at every step. The largest stress of its cells in place of their p-norm: [constraints] (docs/responses.md)."},
    {"part_limits.*", Type::Table, "", kOptional, kAny, "A quantity and its limit."},
    {"part_limits.*.of", Type::Text, "", kRequired, kAny, "Meshed part."},
    {"part_limits.*.quantity", Type::Choice, "", kRequired, kAny, "Compliance (J), p-norm of the von Mises stress over the cells (Pa), mass (kg), lowest free-free frequencies (Hz).", 0, "compliance stress mass frequency"},
    {"part_limits.*.limit", Type::Number, "of the quantity", kRequired, kPositive, "Largest value; of a frequency the least."},
    {"part_limits.*.count", Type::Integer, "", "1", {1, 20}, "How many of the lowest frequencies.", 0, "", "quantity=frequency"},

    {"frequencies", Type::Named, "", kOptional, kAny, "Least natural frequencies of the mechanism by name: of the joined bodies in space, undeformed in a pose, without weight, loads and the forces of springs, whose stiffness counts; drives hold. Not with meshes in the plane."},
    {"frequencies.*", Type::Table, "", kOptional, kAny, "A limit."},
    {"frequencies.*.of", Type::Text, "", kOptional, kAny, "A beam alone: what its joints and springs hold it to is the ground, at the place of the scene as given; drives hold, gears do not count. Default: the mechanism."},
    {"frequencies.*.least", Type::Number, "Hz", kRequired, kPositive, "Least value of each of them."},
    {"frequencies.*.count", Type::Integer, "", "1", {1, 20}, "How many of the lowest: as many as may come to lie together, since which one is the lowest may change there. Motions that nothing holds do not count."},
    {"frequencies.*.at", Type::Number, "s", "0", kNotNegative, "The time whose values the drives have in the pose."},

    {"loads", Type::Named, "", kOptional, kAny, "Fixed loads of a meshed part, by name. If there are any, nothing is simulated."},
    {"loads.*", Type::Table, "", kOptional, kAny, "A load on an interface, or on a side."},
    {"loads.*.at", Type::Text, "", kOneOf, kAny, "Port of the part, \"plate.right\": takes `force` and `moment`."},
    {"loads.*.force", Type::Vector, "N", "[0, 0, 0]", kAny, "In the axes of the mesh.", 3},
    {"loads.*.moment", Type::Vector, "N m", "[0, 0, 0]", kAny, "In the axes of the mesh.", 3},
    {"loads.*.on", Type::Text, "", kOneOf, kAny, "Set of nodes, \"plate.x_max\": the sides of cells between them take `traction`."},
    {"loads.*.traction", Type::Vector, "Pa", "[0, 0, 0]", kAny, "Force per area, in the axes of the mesh.", 3},
    {"loads.*.case", Type::Text, "", "\"1\"", kAny, "Load case; loads of one case add up."},

    {"stress", Type::Table, "", kOptional, kAny, "How the stress of a meshed part is one number a load case: (sum_e w_e (v_e^q sigma_e)^p)^(1/p)."},
    {"stress.p", Type::Number, "-", "8", {1, 100}, "Exponent p."},
    {"stress.relaxation", Type::Number, "-", "0.5", {0, 5}, "Exponent q of the fraction v_e of a cell."},

    {"supports", Type::Named, "", kOptional, kAny, "Where a part is held in its static problem, by body. Default: \"start\"."},
    {"supports.*", Type::Texts, "", kOptional, kAny, "\"inertia_relief\", or nodes with their held directions, together statically determinate: \"start\" (all six), [\"start:xyz,rx\", \"end:yz\"]. Of a meshed part interfaces (x, y, z, r: all rotations) or sets of nodes, [\"pin:xyr\"], [\"x_min:x\", \"y_min:y\"]; default: its first interface."},

    {"cycle", Type::Table, "", kOptional, kAny, "How simulation and optimisation take turns."},
    {"cycle.max", Type::Integer, "", "30", {1, 10000}, "Designs after the first at most; again of every finer model where the limits are refined."},
    {"cycle.tolerance", Type::Number, "-", "1e-3", {0, 1, true}, "Relative change of the loads at which the cycle is closed."},
    {"cycle.objective_tolerance", Type::Number, "-", "1e-3", {0, 1, true}, "Relative change of the objective at which the cycle is closed."},
    {"cycle.feasibility", Type::Number, "-", "1e-3", {0, 1, true}, "Allowed relative violation of a limit."},
    {"cycle.move_limit", Type::Number, "-", "0.5", {0, 1, true}, "Largest relative change of a variable in a cycle, at first."},
    {"cycle.move_cells", Type::Number, "cells", "2", kPositive, "Largest movement of the outline of a meshed part in a cycle, at first."},
    {"cycle.screening", Type::Number, "-", "0.1", {0, 1}, "Keep load cases within this share of a constraint's largest value; others that turn out to violate it are added."},
    {"cycle.min_cases", Type::Integer, "", "10", {.lower = 1}, "Load cases kept per constraint at least."},
    {"cycle.gap", Type::Number, "-", "1e-3", kNotNegative, "Sizes of catalogues (`design.*.values`): the search ends when the best design is within this of the bound, relative; 0: of the best of all. The bound is made of the continuous optima of boxes of designs and holds as far as each is the best of its box. Designs all of whose sizes are of catalogues meet the limits to 1e-6, whatever `cycle.feasibility` allows."},
    {"cycle.max_designs", Type::Integer, "", "500", {.lower = 1}, "Sizes of catalogues: designs simulated at most, those of the continuous optimum among them; then the status is \"cycle limit\", and the gap is said."},
    {"cycle.restarts", Type::Integer, "", "0", {0, 5}, "A study that ends infeasible begins again, so many times at most, until a design meets all limits: with every variable at 0.9 of its range, then at 0.5, 0.1, 0.7 and 0.3. Values of drives and the duration keep their start. The answer is the design that meets the limits, or exceeds them least."},
    {"cycle.refine", Type::Choice, "", "\"auto\"", kAny, "What follows if a limit is not certain to `cycle.feasibility`, as its errors by mesh and step say: \"auto\", the study goes on from its final design with beams of order 4, more elements or a smaller step, until the design holds on the converged model; \"never\", a warning. Without meaning where nothing is verified: fixed loads, `--no-verify`; by the method \"esl\", whose end is no optimum to go on from; with `--nucleate`; in comparisons of methods.", 0, "never auto"},
    {"cycle.continuation", Type::Integer, "", "0", {0, 20}, "A motion with drives that ends infeasible from all starts begins again at 0.9 of its speed (all functions of time and velocities; steps as many) and comes to full speed in so many stages, each from the design of the one before; the last design is taken if it comes nearer to the limits. 0: not."},
    {"cycle.optimizer", Type::Choice, "", "\"ipopt\"", kAny, "Optimiser of the static problem.", 0, "ipopt mma ccsaq slsqp"},
    {"cycle.model", Type::Choice, "", "\"exact\"", kAny, "Static problem with its exact Hessian, or convex separable models of it.", 0, "exact separable"},
    {"cycle.method", Type::Choice, "", "\"auto\"", kAny, "How a cycle finds the next design: \"esl\", loads of the last motion as constants; \"esl1\", a static problem that agrees with the motion in value and gradient, within a trust region: ends at the optimum of the motion; \"full\", the fully coupled method: no static problem, the responses themselves to first order, within a trust region; \"direct\": no approximation at all, the optimiser is given the motion and its sensitivities at every point, every step a constraint (treatments \"auto\", \"worst\", \"functional\", \"p_norm\"). \"auto\": esl1 where the motion has sensitivities, else esl.", 0, "auto esl esl1 full direct"},
    {"cycle.approximation", Type::Choice, "", "\"auto\"", kAny, "How \"esl1\" and \"full\" continue responses from the analysed design: by a factor of the static image that is a \"power\" of the variables, \"linear\", or of reciprocals between moving asymptotes (\"mma\"), or by a linear term beside the image (\"additive\"; without an image as \"linear\"). \"auto\": powers where a static problem tells a response, moving asymptotes where none does, as by \"full\", unless variables set the motion itself or the limit is on a mean over time (functional, p_norm). Limits may have one of their own.", 0, "auto power linear mma additive"},
    {"cycle.optimality", Type::Choice, "", "\"auto\"", kAny, "Evaluate the KKT conditions of the dynamic problem at the end. By sensitivities; for a motion that has none by two simulations a variable, with \"auto\" for up to 12 variables.", 0, "auto always never"},
  };
}
// clang-format on

}  // namespace

std::vector<Key> study_keys() {
  std::vector<Key> keys = design_and_limit_keys();
  for (Key& key : response_keys("constraints.*")) keys.push_back(std::move(key));
  for (Key& key : part_and_cycle_keys()) keys.push_back(std::move(key));
  return keys;
}

}  // namespace liesl
