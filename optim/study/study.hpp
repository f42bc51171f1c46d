#pragma once
/// @file
/// A sizing study as data: what may change, what must hold, how to cycle.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mbs/model/response.hpp"
#include "mbs/solvers/options.hpp"

namespace liesl {

/// One dimension of the section of one or several (linked) beams, constant over each of `groups`
/// runs of neighbouring elements. Gives the variables name[0] .. name[groups - 1].
struct DesignSpec {
  std::string name;
  std::vector<int> bodies;  ///< linked: the same values in each
  /// Dimensions of the section that take the value: {"diameter"}, or several that are linked, as
  /// {"width", "height"} of a square box.
  std::vector<std::string> properties;
  int groups = 1;                   ///< >= 1, divides into the elements as evenly as possible
  double lower = 0, upper = 0;      ///< m
  std::vector<double> start;        ///< empty = as in the scene; else one value or one a group
  std::vector<double> values = {};  ///< of a catalogue, increasing; empty: any within the bounds
  /// Narrower bounds [lower, upper] of each group; empty: those above. They may be equal.
  std::vector<std::array<double, 2>> group_bounds = {};
};

/// A constant of a mechanism that may change.
enum class ConstantQuantity {
  Stiffness,
  Damping,
  Rest,
  Mass,
  DriveValue,  ///< a value of the table of a drive
  Duration     ///< of the motion: the tables of all drives are stretched, the steps with them
};
struct ConstantSpec {
  std::string name;
  ConstantQuantity quantity = ConstantQuantity::Stiffness;
  int force = -1;      ///< Stiffness, Damping, Rest: number in Mechanism::forces
  bool turns = false;  ///< of an angle: units N m/rad, ...
  int body = -1;       ///< Mass: a rigid body; its inertia about the centre stays
  int drive = -1;      ///< DriveValue: number in StudySpec::drives
  int row = -1;        ///< DriveValue: row of its table, from 0
  double lower = 0, upper = 0;
  /// None: as in the scene. Always given of DriveValue and Duration.
  std::optional<double> start;
  std::vector<double> values = {};  ///< of a catalogue, increasing; empty: any within the bounds
};

/// Does it set the motion itself, as a value of a drive or the duration?
inline bool sets_motion(const ConstantSpec& c) {
  return c.quantity == ConstantQuantity::DriveValue || c.quantity == ConstantQuantity::Duration;
}

/// The table that a drive follows, q_i at t_i.
struct DriveTable {
  int drive = -1;  ///< number in Mechanism::drives
  std::vector<double> t, q;
  TimeFunction::Interpolation how = TimeFunction::Interpolation::Linear;
};

/// What a study of motions minimises: mass [kg] x mass + duration [1/s] x duration + effort x the
/// sum over the responses of the integral of their squares over the (first) motion + the terms of
/// constraints and frequencies with a weight: the largest value over all motions, less the lowest
/// frequency.
struct MotionObjective {
  double mass = 1, duration = 0, effort = 0;
  std::vector<ResponseSpec> responses;
  bool extremes = false;  ///< a constraint or a frequency has a weight
  bool only_mass() const { return mass == 1 && duration == 0 && effort == 0 && !extremes; }
};

/// The number in the mechanism. @pre it is there
inline double& constant_of(const ConstantSpec& c, Mechanism& m) {
  if (c.quantity == ConstantQuantity::Mass)
    return std::get<RigidSpec>(m.bodies.at(static_cast<std::size_t>(c.body)).kind).mass;
  ForceSpec& force = m.forces.at(static_cast<std::size_t>(c.force));
  if (c.quantity == ConstantQuantity::Stiffness) return force.stiffness;
  return c.quantity == ConstantQuantity::Damping ? force.damping : force.rest;
}

/// How a limit over all of a motion becomes constraints (thesis section 3.3.2): the load cases that
/// a static problem begins with, which takes those that turn out to violate the limit; or, where no
/// static problem tells the limit, rows of the motion itself with its gradients. The aggregates are
/// always of the motion.
enum class Treatment {
  Auto,    ///< of static problems All; of the motion Neighbours, of one of many points with the
           ///< records near the largest for maxima
  All,     ///< of static problems an active set of all records, at first those near the largest;
           ///< of the motion every record above half of the largest
  Maxima,  ///< local maxima over time above half of the largest
  Neighbours,  ///< the same, and of the motion records at most ten from one at which designs taken
               ///< before had theirs
  Worst,       ///< the largest alone
  Functional,  ///< mean excess, (1/T) int <v/limit - 1> dt <= 0
  PNorm,       ///< (mean of v^p)^(1/p) <= limit; p = 2: root mean square
  Ks           ///< Kreisselmeier-Steinhauser function about each maximum, scaled to the maximum
};
/// One number, or one a maximum, instead of many records.
inline bool aggregates(Treatment t) { return t >= Treatment::Functional; }

/// What makes a row of a trust region agree with the motion to first order at x_k: a factor of the
/// static image, or a term beside it.
enum class Approximation {
  Auto,     ///< of a limit: as of the cycle; else Power with a static image or where variables set
            ///< the motion itself, Mma without
  Power,    ///< prod (x_i/x_ki)^c_i: linear between logarithms
  Linear,   ///< 1 + c . (x - x_k)
  Mma,      ///< 1 + c . s with steps s of reciprocals between moving asymptotes: convex
  Additive  ///< + b . (x - x_k)
};

/// What tells how a limit follows the design within a step of the cycle.
enum class SurrogateKind {
  Auto,      ///< the static problem of the part it is on, if one tells it; else as Motion
  Motion,    ///< its own values and gradients, continued by an Approximation
  Mechanism  ///< the static problem of the whole mechanism, drives held (thesis section 5.2)
};

struct ConstraintSpec {
  ResponseSpec response;  ///< its name is the constraint's name
  double limit = 0;       ///< |response| <= limit at every time step
  /// Whether static problems of parts tell it; else it is known by its gradient alone.
  bool has_image = true;
  Treatment treatment = Treatment::Auto;
  double p = 2;  ///< exponent of Treatment::PNorm
  SurrogateKind surrogate = SurrogateKind::Auto;
  Approximation approximation = Approximation::Auto;
  /// Above 0: no limit, but this times the largest value over all motions in the objective; `limit`
  /// is then a size of it, has_image false in studies of motions.
  double weight = 0;
};

/// Is a limit told by the motion's own gradients, whatever static problems there are?
inline bool by_motion_alone(const ConstraintSpec& c) {
  return aggregates(c.treatment) || c.surrogate == SurrogateKind::Motion;
}

/// A parameter that follows a variable: p = p_0 + factor (x - x_0), where p_0 are the values of the
/// level set as it was made, and x_0 that of the first parameter. Mirrored features have -1.
struct DrivenParameter {
  std::string name;  ///< path in the tree, "hole2.a"
  double factor = 1;
};

struct ShapeVariableSpec {
  std::string name;
  std::vector<DrivenParameter> drives;  ///< at least one; the first gives the unit and x_0
  double lower = 0, upper = 0;          ///< of the first parameter
  std::optional<double> start;          ///< default x_0
  std::vector<double> values = {};  ///< of a catalogue, increasing; empty: any within the bounds
};

/// Material of at least this thickness is left between a feature and another one (or the nodes of
/// an interface). See levelset::wall_between for what is measured.
struct WallSpec {
  std::string name;
  std::string feature;
  std::string to;    ///< feature or interface
  double least = 0;  ///< m, > 0
};

/// What may change of the outline of one meshed part.
struct ShapeDesignSpec {
  std::vector<ShapeVariableSpec> variables;
  std::vector<WallSpec> walls;
};

enum class SolidResponse {
  Output,      ///< norm of some outputs y = C^T q: elongation, displacement, m
  Compliance,  ///< f^T u, J
  Stress,      ///< p-norm of the von Mises stress over the cells, Pa
  Mass,        ///< kg
  Frequency    ///< every one of the lowest `count` free-free frequencies is at least `limit`, Hz
};

/// Compliance and stress are of a load case, at a record of the motion; the rest is of the design.
inline bool follows_loads(SolidResponse r) {
  return r == SolidResponse::Compliance || r == SolidResponse::Stress;
}

/// A limit of a meshed part that is no response of the motion.
struct PartLimitSpec {
  std::string name;
  int body = 0;
  SolidResponse quantity = SolidResponse::Mass;  ///< not Output
  double limit = 0;                              ///< > 0
  int count = 1;                                 ///< Frequency: how many
  /// Above 0: no limit, but this times the largest value of the load cases (of a frequency minus
  /// the lowest) in the objective; under fixed loads.
  double weight = 0;
};

/// The lowest `count` natural frequencies of the mechanism, in the pose that its drives have at the
/// time `at` (held there, without weight and loads), are at least `least`.
struct FrequencyLimitSpec {
  std::string name;
  double least = 0;  ///< Hz, > 0
  int count = 1;
  double at = 0;  ///< s
  /// Above 0: no limit, but minus this times the lowest one in the objective.
  double weight = 0;
  int body = -1;  ///< of this beam alone, what its joints hold at rest on the ground; -1: of all
};

/// The mass of these bodies is at most `limit`, in studies of motions.
struct MassLimitSpec {
  std::string name;
  std::vector<int> bodies;
  double limit = 0;  ///< kg, > 0
};

/// A fixed load of a meshed part, whatever the design. Loads of one case add up.
struct FixedLoad {
  std::string load_case;
  int body = 0;
  int interface = -1;      ///< [force; moment] on its port, axes of the mesh
  std::vector<int> nodes;  ///< or a traction on the sides between these nodes
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< N, N m
  Vec3 traction = Vec3::Zero();                      ///< Pa
  std::string name = {}, place = {};  ///< "tip"; the interface or set of nodes it acts on
};

enum class Optimizer { Ipopt, Mma, Ccsaq, Slsqp };
/// What Ipopt is given: the static problem with its exact Hessian, or a sequence of convex
/// separable models of it.
enum class NlpModel { Exact, Separable };

/// How a cycle goes from one design to the next (docs/theory.md).
enum class CycleMethod {
  Auto,   ///< Esl1 where the motion has sensitivities, else Esl
  Esl,    ///< the loads of the last motion are constant in the static problem
  Esl1,   ///< the static problem agrees with the motion to first order; trust region
  Full,   ///< no static problem: the responses of the motion themselves, approximated; trust region
  Direct  ///< no approximation: the optimiser is given the motion itself and its sensitivities
};

/// Whether the end of a cycle is checked against the optimality conditions of the motion itself.
/// By sensitivities; where the motion has none by two simulations a variable.
enum class OptimalityCheck {
  Auto,  ///< differences for up to 12 variables only
  Always,
  Never
};

/// Where a part is held in its static problem; any statically determinate choice gives the same
/// deformation. "start", "node3:xyz", "end:yz,rx", or "inertia_relief".
using Support = std::vector<std::string>;

constexpr int kMostRestarts = 5, kMostStages = 20;

struct CycleOptions {
  CycleMethod method = CycleMethod::Auto;
  Approximation approximation = Approximation::Auto;
  int max = 30;                       ///< cycles
  double tolerance = 1e-3;            ///< of the relative change of the loads (thesis eq. 3.25)
  double objective_tolerance = 1e-3;  ///< of the relative change of the objective
  double feasibility = 1e-3;          ///< allowed relative violation of a limit
  double move_limit = 0.5;  ///< largest relative change of a variable in a cycle, at first
  double screening = 0.1;   ///< keep load cases within this of a constraint's largest;
                            ///< others that turn out to violate it are added
  int min_cases = 10;       ///< kept per constraint
  double gap = 1e-3;        ///< of a design of catalogues to the least objective possible
  int max_designs = 500;    ///< that a search in catalogues may simulate
  int restarts = 0;         ///< other starts of a study that ends infeasible, at most kMostRestarts
  Optimizer optimizer = Optimizer::Ipopt;
  NlpModel model = NlpModel::Exact;
  OptimalityCheck optimality = OptimalityCheck::Auto;
  int continuation = 0;  ///< stages from 0.9 to full speed of one that ends so, at most
                         ///< kMostStages; 0: none
  double move_cells =
      2;  ///< the outline of a meshed part moves by so many cells in a cycle, at most
  bool from_optimum = false;  ///< the start is the optimum of a model that differs little

  /// Options out of range, with name, expected and got; empty: none.
  std::vector<std::string> errors() const;
};

/// Exponent and relaxation of the stress norm, see StressOptions.
struct StressSpec {
  double p = 8, relaxation = 0.5;
};

struct StudySpec {
  std::string name;
  std::vector<std::string> scenarios;  ///< names; empty: one motion, which has none
  std::vector<DesignSpec> design;
  std::vector<int> mass_of;  ///< objective: mass of these bodies
  std::vector<ConstraintSpec> constraints;
  std::map<int, ShapeDesignSpec> shapes;  ///< by body
  std::vector<ConstantSpec> constants;
  std::vector<DriveTable> drives;    ///< those whose values or duration may change
  double duration = 0;               ///< s, of the scene
  MotionObjective motion_objective;  ///< of motions
  /// Objective of a study of meshed parts: Mass, Compliance or Stress.
  SolidResponse objective = SolidResponse::Mass;
  std::vector<PartLimitSpec> part_limits;
  std::vector<FrequencyLimitSpec> frequencies;
  std::vector<MassLimitSpec> mass_limits;
  std::vector<FixedLoad> loads;  ///< if there are any, nothing is simulated
  StressSpec stress;
  std::map<int, Support> supports;  ///< by body; default "start"
  CycleOptions cycle;
};

/// f(spec) of every entry of [design], in the order of the variables: DesignSpec, ShapeVariableSpec
/// or ConstantSpec; const or not as the study.
template <class Study, class F>
void each_entry(Study& study, F f) {
  for (auto& d : study.design) f(d);
  for (auto& [body, shape] : study.shapes)
    for (auto& v : shape.variables) f(v);
  for (auto& c : study.constants) f(c);
}

/// How many variables an entry has.
inline int variables_of(const DesignSpec& d) { return d.groups; }
inline int variables_of(const ShapeVariableSpec&) { return 1; }
inline int variables_of(const ConstantSpec&) { return 1; }

/// The name of an entry that no static problem of a part has (VariableGroup::has_statics).
inline std::optional<std::string> without_statics(const StudySpec& study) {
  if (study.constants.empty()) return {};
  return study.constants.front().name;
}

/// Is any size of a catalogue?
inline bool has_catalogue(const StudySpec& study) {
  bool any = false;
  each_entry(study, [&any](const auto& entry) { any = any || !entry.values.empty(); });
  return any;
}

/// Why the motion of a study is not followed from other speeds: no drive, equilibria, variables
/// that set the motion themselves, sizes of catalogues; empty: it is.
inline std::string without_speed(const StudySpec& study, const Mechanism& mechanism,
                                 const SimulationOptions& simulation) {
  if (simulation.type != SimulationType::Dynamic) return "equilibria have no speed";
  if (mechanism.drives.empty()) return "no drive gives the motion its speed";
  for (const ConstantSpec& c : study.constants)
    if (sets_motion(c)) return "the variable '" + c.name + "' changes the motion itself";
  return has_catalogue(study) ? "sizes of catalogues are not followed" : "";
}

/// Bodies that carry limits with a static image, each once.
inline std::vector<int> limited_bodies(const StudySpec& study) {
  std::vector<int> bodies;
  for (const auto& c : study.constraints)
    if (const int b = deformed_body(c.response);
        c.has_image && std::find(bodies.begin(), bodies.end(), b) == bodies.end())
      bodies.push_back(b);
  return bodies;
}

}  // namespace liesl
