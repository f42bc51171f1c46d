/// @file
/// Table of the keys of a scene. Rows: path, type, unit, preset, range, doc, size, options, when.
#include <iterator>

#include "apps/input/schema.hpp"
#include "mbs/model/joint_kind.hpp"

namespace liesl {

namespace {

constexpr auto kWhole1 = Range{.lower = 1};
constexpr auto kWhole0 = Range{.lower = 0};

// clang-format off
std::vector<Key> material_keys() {
  return {
    {"name", Type::Text, "", "\"scene\"", kAny, "Title of the scene; without it the name of its file."},
    {"gravity", Type::Vector, "m/s^2", "[0, 0, 0]", kAny, "Acceleration of gravity, inertial axes.", 3},
    {"gravity_scale", Type::Function, "-", "1", kAny, "Factor of gravity over time: a ramp puts the weight on slowly. Statics and modes take its value at `simulation.at`."},
    {"ground", Type::Table, "", kOptional, kAny, "The inertial frame."},
    {"ground.points", Type::Named, "", kOptional, kAny, "Ports of the ground by name: `ground.anchor`. Plain `ground` is the origin, in joints whose ports meet the place of the other port."},
    {"ground.points.*", Type::Vector, "m", kOptional, kAny, "Position.", 3},

    {"materials", Type::Named, "", kOptional, kAny, "Isotropic linear-elastic materials by name."},
    {"materials.*", Type::Table, "", kOptional, kAny, "A material."},
    {"materials.*.E", Type::Number, "Pa", kRequired, kPositive, "Young's modulus."},
    {"materials.*.nu", Type::Number, "-", "0.3", {-1, 0.5, true, true}, "Poisson's ratio; 0.5 is incompressible, 0.49 nearly so."},
    {"materials.*.rho", Type::Number, "kg/m^3", "0", kNotNegative, "Density; above 0 unless the simulation is static."},

    {"sections", Type::Named, "", kOptional, kAny, "Cross-sections by name. Width along local y, height along local z."},
    {"sections.*", Type::Table, "", kOptional, kAny, "A cross-section."},
    {"sections.*.type", Type::Choice, "", kRequired, kAny, "Shape.", 0, "circle tube rectangle box i full"},
    {"sections.*.diameter", Type::Number, "m", kRequired, kPositive, "Outer diameter.", 0, "", "type=circle tube"},
    {"sections.*.thickness", Type::Number, "m", kRequired, kPositive, "Wall thickness.", 0, "", "type=tube box"},
    {"sections.*.width", Type::Number, "m", kRequired, kPositive, "Outer width, along y.", 0, "", "type=rectangle box i"},
    {"sections.*.height", Type::Number, "m", kRequired, kPositive, "Outer height, along z.", 0, "", "type=rectangle box i"},
    {"sections.*.flange_thickness", Type::Number, "m", kRequired, kPositive, "Of the two flanges, parallel to y.", 0, "", "type=i"},
    {"sections.*.web_thickness", Type::Number, "m", kRequired, kPositive, "Of the web, along z.", 0, "", "type=i"},
    {"sections.*.shear_factor", Type::NumberOrList, "-", kOptional, kPositive, "Factor k of the shear stiffness k G A, or [k_y, k_z]. Default: Cowper's value of the shape.", 2, "", "type=circle tube rectangle box i"},
    {"sections.*.torsion_constant", Type::Number, "m^4", kOptional, kPositive, "J of the torsion stiffness G J. Default: of the shape.", 0, "", "type=circle tube rectangle box i"},
    {"sections.*.stiffness", Type::Matrix, "N, N m, N m^2", kRequired, kAny, "Rows [N, V_y, V_z, M_x, M_y, M_z] over [eps_x, gamma_y, gamma_z, kappa_x, kappa_y, kappa_z]; the diagonal is [EA, k_y GA, k_z GA, GJ, EI_y, EI_z].", 6, "", "type=full"},
    {"sections.*.inertia", Type::Matrix, "kg/m, kg, kg m", kOptional, kAny, "Per length; the diagonal is rho [A, A, A, I_y + I_z, I_y, I_z]. Needed unless the simulation is static.", 6, "", "type=full"},
  };
}

std::vector<Key> body_keys() {
  return {
    {"bodies", Type::Named, "", kRequired, kAny, "Bodies by name: beams, rigid bodies and meshed parts. `ground` is the name of the inertial frame."},
    {"bodies.*", Type::Table, "", kOptional, kAny, "A body: exactly one of `beam`, `rigid`, `solid` and `truss`."},
    {"bodies.*.velocity", Type::Vector, "m/s", "[0, 0, 0]", kAny, "At the start, of the first node or of the origin, inertial axes.", 3},
    {"bodies.*.angular_velocity", Type::Vector, "rad/s", "[0, 0, 0]", kAny, "At the start, inertial axes.", 3},

    {"bodies.*.beam", Type::Table, "", kOneOf, kAny, "Chain of beam elements. Ports: start, end, mid, node0, node1, ..."},
    {"bodies.*.truss", Type::Table, "", kOneOf, kAny, "Bars between nodes, hinged at both ends. Nodes are ports, `T.n1`; bars are beams of one element of order 2, `T_chord1`, `T_chord2`, ...; in a study `T` means all bars and `T.chord` those of a group."},
    {"bodies.*.truss.nodes", Type::Named, "", kRequired, kAny, "Nodes by name."},
    {"bodies.*.truss.nodes.*", Type::Vector, "m", kOptional, kAny, "Position.", 3},
    {"bodies.*.truss.bars", Type::Named, "", kRequired, kAny, "Groups of bars by name."},
    {"bodies.*.truss.bars.*", Type::List, "", kOptional, kAny, "Pairs of nodes, [[\"n1\", \"n2\"], ...], a bar each."},
    {"bodies.*.truss.section", Type::Text, "", kRequired, kAny, "Section of all bars."},
    {"bodies.*.truss.sections", Type::Named, "", kOptional, kAny, "Other sections, by group."},
    {"bodies.*.truss.sections.*", Type::Text, "", kOptional, kAny, "Section of the bars of a group."},
    {"bodies.*.truss.material", Type::Text, "", kRequired, kAny, "Material of all bars."},
    {"bodies.*.truss.held", Type::Texts, "", kOptional, kAny, "Nodes that the ground holds, in all directions."},
    {"bodies.*.truss.damping", Type::Number, "s", "0", kNotNegative, "Stiffness-proportional damping of the bars."},

    {"bodies.*.beam.from", Type::Vector, "m", kOneOf, kAny, "Straight axis: first point; needs `to`.", 3},
    {"bodies.*.beam.to", Type::Vector, "m", kOptional, kAny, "Straight axis: last point.", 3},
    {"bodies.*.beam.arc", Type::Table, "", kOneOf, kAny, "Circular axis."},
    {"bodies.*.beam.arc.from", Type::Vector, "m", kRequired, kAny, "First point.", 3},
    {"bodies.*.beam.arc.centre", Type::Vector, "m", kRequired, kAny, "Centre of the circle.", 3},
    {"bodies.*.beam.arc.axis", Type::Vector, "-", "[0, 0, 1]", kAny, "The arc turns about this direction (right hand).", 3},
    {"bodies.*.beam.arc.angle", Type::Number, "rad", kRequired, kAny, "Angle of the arc; negative turns the other way."},
    {"bodies.*.beam.through", Type::Rows, "m", kOneOf, kAny, "Axis through these points in order, of which the first is the start and the last the end: the C2 cubic spline over the lengths of the chords between them, not-a-knot at its ends (two points make a line, three a parabola). Nodes are evenly spaced along it and need not be at the points; sections turn about it as little as possible.", 3},
    {"bodies.*.beam.section", Type::Texts, "", kRequired, kAny, "Section of all elements, or a list: one for each of as many runs of neighbouring elements, as even as possible."},
    {"bodies.*.beam.taper", Type::Boolean, "", "false", kAny, "The sections of the list, of one type, stand at even distances from start to end, and dimensions are linear in between. Stiffness and mass of an element are those of its middle, stress is that of the sections at its nodes."},
    {"bodies.*.beam.material", Type::Text, "", kOptional, kAny, "Material of all elements; needed unless all sections are `full`."},
    {"bodies.*.beam.elements", Type::Integer, "", kRequired, {1, 10000}, "Number of elements, spaced evenly along the axis."},
    {"bodies.*.beam.numbering", Type::Integer, "", kOptional, {1, 10000}, "Nodes and elements of the beam are named by their numbers on a mesh of so many elements: of 16 elements with `numbering = 8`, `node3` is node 6. Default: by those on its own."},
    {"bodies.*.beam.up", Type::Vector, "-", kOptional, kAny, "Local y of the section at the start is the part of this direction normal to the axis. Default: local z is the part of inertial z (for an axis along z: inertial y) normal to the axis, of an arc its normal; a beam in the x-y plane has local y in that plane.", 3},
    {"bodies.*.beam.pre_twist", Type::Number, "rad", "0", kAny, "Rotation of the section about the axis from start to end."},
    {"bodies.*.beam.order", Type::Integer, "", kOptional, {2, 4}, "Order of the elements, 2 or 4: with n elements the error of displacements falls as 1/n^2 or 1/n^4. Order 4 has the same nodes; `simulation.formalism` \"se3\" only, not with `as`, nor of sections whose inertia couples translation and rotation. Default: 4 where it can be, but 2 with `damping` and under a spread moment, whose elements of order 4 have other shear forces than the sections between their nodes; in a comparison of a scene 2, so that formalisms are compared with elements of one order."},
    {"bodies.*.beam.as", Type::Choice, "", "\"formalism\"", kAny, "What the beam is simulated as: as `simulation.formalism` says, rigid, linear in a floating frame with modes, or as a chain of segments without shear and torsion (in space: straight, undamped, with one bending stiffness).", 0, "formalism rigid modal segments"},
    {"bodies.*.beam.potential", Type::Choice, "", "\"linear\"", kAny, "Of a chain of segments: normal force over the stretch l, EA (l - 1), or EA/3 (l - 1/l^2) of an incompressible neo-Hookean material.", 0, "linear neo_hookean"},
    {"bodies.*.beam.mass", Type::Choice, "", "\"consistent\"", kAny, "Of a chain of segments: linear along each of them, or lumped at the nodes.", 0, "consistent lumped"},
    {"bodies.*.beam.modes", Type::Integer, "", kOptional, kWhole0, "Internal modes that are kept where the beam is simulated with modes. Default: all."},
    {"bodies.*.beam.damping", Type::Number, "s", "0", kNotNegative, "Stiffness-proportional: section forces get damping K d(strain)/dt."},
    {"bodies.*.beam.points", Type::Named, "", kOptional, kAny, "Further ports by name, rigidly tied to a node: lugs, ends of an offset."},
    {"bodies.*.beam.points.*", Type::Table, "", kOptional, kAny, "A point off the axis."},
    {"bodies.*.beam.points.*.on", Type::Text, "", kRequired, kAny, "Node that carries it: start, mid, end, nodeK."},
    {"bodies.*.beam.points.*.at", Type::Vector, "m", kRequired, kAny, "Position at the start, inertial axes.", 3},

    {"bodies.*.rigid", Type::Table, "", kOneOf, kAny, "Rigid body. Ports: origin and the named points."},
    {"bodies.*.rigid.at", Type::Vector, "m", kRequired, kAny, "Position of the origin.", 3},
    {"bodies.*.rigid.orientation", Type::Vector, "rad", "[0, 0, 0]", kAny, "Rotation vector of the body axes.", 3},
    {"bodies.*.rigid.mass", Type::Number, "kg", kRequired, kPositive, "Mass."},
    {"bodies.*.rigid.inertia", Type::Matrix, "kg m^2", kRequired, kAny, "About the centre of mass, body axes.", 3},
    {"bodies.*.rigid.centre", Type::Vector, "m", "[0, 0, 0]", kAny, "Centre of mass from the origin, body axes.", 3},
    {"bodies.*.rigid.points", Type::Named, "", kOptional, kAny, "Further ports by name."},
    {"bodies.*.rigid.points.*", Type::Vector, "m", kOptional, kAny, "Position at the start, inertial axes.", 3},
  };
}

std::vector<Key> force_keys() {
  return {
    {"forces", Type::Named, "", kOptional, kAny, "Springs, dampers, forces and torques by name: stiffness (q - rest) + spring(q - rest) + damping dq/dt - force acts against q."},
    {"forces.*", Type::Table, "", kOptional, kAny, "A force law on one coordinate q."},
    {"forces.*.on", Type::Text, "", kOneOf, kAny, "q is a joint coordinate: \"joint\", or \"joint.1\" for its coordinate 1."},
    {"forces.*.between", Type::Pair, "", kOneOf, kAny, "q is the distance of two ports."},
    {"forces.*.stiffness", Type::Number, "N/m or N m/rad", "0", kNotNegative, "Spring."},
    {"forces.*.spring", Type::Table, "", kOptional, kAny, "Characteristic of a spring, added to `stiffness`."},
    {"forces.*.spring.table", Type::Rows, "m or rad, N or N m", kRequired, kAny, "Rows [x, f], elongation x = q - rest increasing, and the force against it. Outside it goes on straight with the slope of its end.", 2},
    {"forces.*.spring.interpolation", Type::Choice, "", "\"linear\"", kAny, "Of the table; cubic is C1 without overshoot.", 0, "linear cubic"},
    {"forces.*.damping", Type::Number, "N s/m or N m s/rad", "0", kNotNegative, "Damper."},
    {"forces.*.rest", Type::Number, "m or rad", kOptional, kAny, "q of the relaxed spring. Default: 0 on a joint, the distance at the start between ports."},
    {"forces.*.force", Type::Function, "N", kOptional, kAny, "Pushes the coordinate up."},
    {"forces.*.torque", Type::Function, "N m", kOptional, kAny, "The same under its name for angles."},

    {"gears", Type::Named, "", kOptional, kAny, "Gears, racks, belts by name: the second coordinate is `ratio` times the first, both 0 in the scene as given."},
    {"gears.*", Type::Table, "", kOptional, kAny, "A gear."},
    {"gears.*.of", Type::Pair, "", kRequired, kAny, "Two joint coordinates: \"joint\", or \"joint.1\" for its coordinate 1."},
    {"gears.*.ratio", Type::Number, "rad/rad, m/rad, rad/m or m/m", kRequired, kAny, "q_second / q_first, not 0: -z_1/z_2 for two outer wheels with z_1 and z_2 teeth, the radius for a rack."},

    {"loads", Type::Named, "", kOptional, kAny, "Forces and moments on bodies by name."},
    {"loads.*", Type::Table, "", kOptional, kAny, "A load."},
    {"loads.*.at", Type::Text, "", kOneOf, kAny, "The port that it acts on."},
    {"loads.*.over", Type::Text, "", kOneOf, kAny, "The beam that it is spread over, per length."},
    {"loads.*.force", Type::Vector, "N or N/m", "[0, 0, 0]", kAny, "Force.", 3},
    {"loads.*.moment", Type::Vector, "N m or N m/m", "[0, 0, 0]", kAny, "Moment.", 3},
    {"loads.*.follower", Type::Boolean, "", "false", kAny, "Components are in the axes of the port and turn with it, on a beam x along the axis, y and z those of the section; otherwise they are inertial."},
    {"loads.*.scale", Type::Function, "-", "1", kAny, "Factor over time."},
  };
}

std::vector<Key> simulation_keys() {
  return {
    {"simulation", Type::Table, "", kOptional, kAny, "What is computed and how finely."},
    {"simulation.type", Type::Choice, "", "\"dynamic\"", kAny, "Motion over time, equilibrium under the loads, or natural modes about it.", 0, "dynamic static modes"},
    {"simulation.space", Type::Choice, "", "\"auto\"", kAny, "SE(2) for planar scenes, SE(3) otherwise; or one of them. Auto: modes, and statics with `critical`, are always computed in space, since they may leave the plane of the scene (a mesh in the plane keeps it); of a motion in the plane a note says whether small motions out of it would grow (of floating frames and chains of segments: whether a beam carries more than a fourth of its Euler load out of it). A step in space takes 2.4 (pendulum) to 3.5 times (slider-crank) as long as one in the plane; the look out of the plane took 2.5 ms of the 57 ms of pendulum (docs/performance.md).", 0, "auto planar spatial"},
    {"simulation.formalism", Type::Choice, "", "\"se3\"", kAny, "Unknowns and kind of flexible body: SE(3) (SE(2) in a plane), R^3 x SO(3), classical rotation vectors, floating frames with modes, flexible bodies rigid; beams as chains of points without shear and torsion (segments).", 0, "se3 r3so3 classical floating rigid segments"},
    {"simulation.update", Type::Choice, "", "\"formalism\"", kAny, "Dynamic: how a step moves the frames of nodes: se3 as one screw motion, r3so3 translation and rotation apart, which keeps linear momentum and suits bodies that spin fast or fly freely; as `formalism` says (r3so3 for r3so3 and where no body deforms, else se3). Not for classical and floating.", 0, "formalism se3 r3so3"},
    {"simulation.constraints", Type::Choice, "", "\"multipliers\"", kAny, "Dynamic: how joints and drives are enforced, Phi = 0: exactly, by multipliers; by penalties, forces B^T alpha Phi; or by penalties whose multipliers are corrected until the joints are closed (augmented Lagrangian). Penalties need no rank: rows that repeat others share their forces. What they leave open is in summary.json.", 0, "multipliers penalty augmented"},
    {"simulation.penalty", Type::Number, "N/m", kOptional, {0, 1e18, true}, "Weight of the rows of joints that are lengths. Default: 1000 times the stiffness of the bodies and their inertia within a step, a power of ten.", 0, "", "constraints=penalty augmented"},
    {"simulation.penalty_rotation", Type::Number, "N m", kOptional, {0, 1e18, true}, "The same of the rows that are angles.", 0, "", "constraints=penalty augmented"},
    {"simulation.penalty_damping", Type::Number, "s", "0", {0, 1}, "Forces get alpha times this times dPhi/dt. Augmented joints are closed, and it has no effect on them (a note says so).", 0, "", "constraints=penalty augmented"},
    {"simulation.tangent", Type::Choice, "", "\"auto\"", kAny, "Dynamic: when the iteration matrix is factored: once, when a correction gains less than a digit, in every iteration; auto: constant, and again where steps take more than 3 corrections, but adaptive for r3so3 and exact for classical.", 0, "auto constant adaptive exact"},
    {"simulation.rescale", Type::Boolean, "", "true", kAny, "Classical: rotation vectors are kept below pi."},
    {"simulation.duration", Type::Number, "s", "1.0", kPositive, "Dynamic: length of the simulated time."},
    {"simulation.step", Type::Number, "s", "1e-3", kPositive, "Dynamic: time step; the largest one if adaptive."},
    {"simulation.rho_inf", Type::Number, "-", "0.8", {0, 1}, "Dynamic: spectral radius at infinity; 1 = no numerical dissipation."},
    {"simulation.tolerance", Type::Number, "-", "1e-5", {0, 1e-2, true}, "Residual relative to the forces."},
    {"simulation.max_iterations", Type::Integer, "", "12", {3, 100}, "Dynamic: corrections a step before the step is halved."},
    {"simulation.adaptive", Type::Boolean, "", "false", kAny, "Dynamic: choose the step, at most `step`, by an estimate of its local error; a step with a larger one than allowed is taken again. Records stay at the multiples of `step`, which are met exactly."},
    {"simulation.error_tolerance", Type::Number, "-", "1e-4", {0, 1, true}, "Adaptive: largest local error of a step, relative to the scene's size. The error of the motion falls as its power 2/3."},
    {"simulation.step_min", Type::Number, "s", "0", kNotNegative, "Smallest step; 0 = step / 1024."},
    {"simulation.output_every", Type::Integer, "", "1", kWhole1, "Dynamic: steps between two records."},
    {"simulation.start", Type::Choice, "", "\"assembled\"", kAny, "Dynamic: where the motion starts: where the scene puts the bodies, undeformed, so that weight and loads strike them at t = 0; or in equilibrium under the weight and the loads of t = 0.", 0, "assembled equilibrium"},
    {"simulation.at", Type::Number, "s", "0", kNotNegative, "Static, modes: the time at which drives, tables and expressions are taken; the drives bring the mechanism to the pose of that time."},
    {"simulation.load_steps", Type::Integer, "", "1", kWhole1, "Static: steps from no load to the full one."},
    {"simulation.arc_length", Type::Boolean, "", "false", kAny, "Static: follow the path past limit points."},
    {"simulation.max_load", Type::Number, "-", "1.0", kPositive, "Static: load factor at which the path ends; weight, loads and forces of actuators are multiplied by it."},
    {"simulation.critical", Type::Boolean, "", "false", kAny, "Static: bisect the load factor where the tangent loses definiteness."},
    {"simulation.modes", Type::Integer, "", "10", kWhole1, "Modes: how many."},

    {"responses", Type::Named, "", kOptional, kAny, "Quantities to report, by name."},
    {"responses.*", Type::Table, "", kOptional, kAny, "A response."},
  };
}
// clang-format on

void append(std::vector<Key>& keys, std::vector<Key> more) {
  keys.insert(keys.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

/// `response` of an entry: required in a scene, or an alternative to `use` in a study.
Key response_choice(std::string_view parent, std::string_view preset) {
  return {
      std::string(parent) + ".response",
      Type::Choice,
      "",
      preset,
      kAny,
      "Which quantity.",
      0,
      "position velocity angular_velocity rotation displacement deflection elongation coordinate "
      "joint_force drive_force section_force stress energy compliance axial_stress buckling "
      "local_buckling translation acceleration angular_acceleration"};
}

}  // namespace

// clang-format off
std::vector<Key> response_keys(std::string_view parent) {
  const bool scene = parent == "responses.*";
  std::vector<Key> keys{
    response_choice(parent, scene ? kRequired : kOneOf),
    {".at", Type::Text, "", kRequired, kAny, "Port. `displacement` is seen from node 0 of the port's body, `rotation` and `translation` from the scene as given.", 0, "", "response=position velocity angular_velocity rotation displacement translation acceleration angular_acceleration"},
    {".at", Type::Text, "", "\"mid\"", kAny, "Node of the beam between its ends: mid, nodeK, or `max` for the largest over all of them; of a meshed part an interface between its first and its last one.", 0, "", "response=deflection"},
    {".of", Type::Text, "", kRequired, kAny, "Beam; of a deflection, stress or compliance also a meshed part.", 0, "", "response=deflection section_force stress compliance axial_stress buckling local_buckling"},
    {".factor", Type::Number, "-", "1", {0, 100, true}, "Factor K of the buckling length K L: 1 hinged at both ends, 0.5 clamped at both, 2 clamped at one.", 0, "", "response=buckling"},
    {".factor", Type::Number, "-", "1", {0, 1, true}, "Share of the classical stress at which a real wall buckles.", 0, "", "response=local_buckling"},
    {".of", Type::Text, "", kOptional, kAny, "Beam: change of the distance of its ends. This or `between`.", 0, "", "response=elongation"},
    {".between", Type::Pair, "", kOptional, kAny, "Two ports: change of their distance.", 0, "", "response=elongation"},
    {".of", Type::Text, "", kRequired, kAny, "Joint.", 0, "", "response=coordinate joint_force drive_force"},
    {".axis", Type::Vector, "-", kOptional, kAny, "Component along this direction; normalised. Without it the whole vector.", 3, "", "response=position velocity angular_velocity rotation displacement translation acceleration angular_acceleration"},
    {".axis", Type::Vector, "-", kOptional, kAny, "Component of the force on the second port along this direction; normalised. Without it the norm.", 3, "", "response=joint_force"},
    {".in", Type::Choice, "", "\"inertial\"", kAny, "Axes of the components and of `axis`: inertial, or those of the port (joint_force: the second of the joint).", 0, "inertial body", "response=velocity rotation joint_force acceleration"},
    {".in", Type::Choice, "", "\"body\"", kAny, "Axes of the components and of `axis`: inertial, or those of the port (displacement: of node 0 of the body).", 0, "inertial body", "response=angular_velocity displacement angular_acceleration"},
    {".coordinate", Type::Integer, "", "0", {0, max_coordinates() - 1.0}, "Which coordinate of the joint.", 0, "", "response=coordinate drive_force"},
    {".element", Type::Integer, "", "0", kWhole0, "Element of the beam, from 0.", 0, "", "response=section_force"},
    {".at", Type::Choice, "", "\"start\"", kAny, "Where on the element: at its first node, in its middle, at its last node.", 0, "start mid end", "response=section_force"},
    {".component", Type::Choice, "", kRequired, kAny, "Normal force, shear forces, torsion and bending moments.", 0, "N Vy Vz Mx My Mz", "response=section_force"},
  };
  for (Key& key : keys)
    if (key.path.starts_with('.')) key.path.insert(0, parent);
  return keys;
}

std::vector<Key> function_keys() {
  return {
    {"(function).table", Type::Rows, "s, -", kOneOf, kAny, "Rows [t, f], t increasing; constant outside.", 2},
    {"(function).interpolation", Type::Choice, "", "\"linear\"", kAny, "Of the table; cubic is C1 without overshoot, quintic C4 with rate and acceleration 0 at both ends.", 0, "linear cubic quintic"},
    {"(function).expression", Type::Text, "", kOneOf, kAny, "Expression of t (s), as in \"10*sin(2*pi*t)\"."},
  };
}
// clang-format on

std::vector<Key> scene_keys() {
  std::vector<Key> keys = material_keys();
  append(keys, body_keys());
  append(keys, solid_keys());
  append(keys, joint_keys());
  append(keys, force_keys());
  append(keys, simulation_keys());
  append(keys, response_keys("responses.*"));
  append(keys, function_keys());
  return keys;
}

}  // namespace liesl
