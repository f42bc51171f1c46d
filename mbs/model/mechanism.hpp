#pragma once
/// @file
/// A mechanism as data: bodies, ports, joints, forces, loads, in the inertial frame, in SI units,
/// in space. It is independent of groups and formalisms: `Model<SE2>` and `Model<SE3>` are built
/// from it.

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "liegroup/se3.hpp"
#include "mbs/model/force_curve.hpp"
#include "mbs/model/joint_kind.hpp"
#include "mbs/model/time_function.hpp"
#include "mbs/sections/section.hpp"
#include "mbs/solids/solid_spec.hpp"

namespace liesl {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// What a beam is simulated as: as the formalism prescribes, or rigid, by modes or as a chain of
/// segments in any formalism.
enum class BeamModel { AsFormalism, Rigid, Modal, Segments };

/// Axial potential of a segment of a beam, N(lambda) of its stretch.
enum class AxialPotential {
  Linear,     ///< N = EA (lambda - 1)
  NeoHookean  ///< N = EA/3 (lambda - 1/lambda^2): incompressible, of uniaxial tension
};

/// What a beam has where it is simulated as a chain of segments.
struct SegmentSpec {
  AxialPotential potential = AxialPotential::Linear;
  bool lumped = false;  ///< mass of each half segment at its node, else linear along the segment
};

/// A place that moves with a node of a beam as if it were of one rigid piece with it.
struct BeamPoint {
  int node = 0;
  Vec3 at = Vec3::Zero();  ///< in the inertial frame at the start
};

/// Chain of two-node beam elements. Node frames have x along the axis, y and z along the section's.
struct BeamSpec {
  std::vector<SE3> nodes;         ///< reference frames, n + 1; elements may be curved and twisted
  std::vector<Section> sections;  ///< n, one an element
  Material material;              ///< of all elements; unused by FullSection
  double damping = 0;             ///< stiffness-proportional, in s: n_d = damping K d(eps)/dt
  int order = 2;  ///< of the elements: displacements converge as (1/n)^order, 2 or 4 (se3 only)
  BeamModel as = BeamModel::AsFormalism;
  int modes = -1;                                ///< internal modes of a modal body, -1 = all
  SegmentSpec segment = {};                      ///< of a chain of segments
  std::map<std::string, BeamPoint> points = {};  ///< further ports
  /// n, of a taper: the sections at both nodes of each element, for its stress; stiffness and mass
  /// are those of its middle, in `sections`. Empty: the elements are prismatic.
  std::vector<std::array<Section, 2>> ends = {};
};

/// Rigid body with named points.
struct RigidSpec {
  SE3 frame;                           ///< the port "origin"
  double mass = 0;                     ///< kg
  Mat3 inertia = Mat3::Zero();         ///< kg m^2 about the centre of mass, in body axes
  Vec3 centre = Vec3::Zero();          ///< of mass, in body axes, from the origin
  std::map<std::string, Vec3> points;  ///< further ports, in the inertial frame at the start
};

struct BodySpec {
  std::string name;
  std::variant<BeamSpec, RigidSpec, SolidSpec> kind;
  Vec3 velocity = Vec3::Zero();          ///< of its first frame, inertial, m/s, at the start
  Vec3 angular_velocity = Vec3::Zero();  ///< inertial, rad/s, at the start
};

/// A frame that couplings, loads and responses hold on to: `frame(port) = H_node * offset`.
/// body = -1 is the ground, where `offset` is the frame itself.
struct Port {
  int body = -1;
  int node = 0;
  SE3 offset = SE3::identity();
};

/// Joint between port a (or the ground) and port b. Coordinates are zero in the scene as given.
struct JointSpec {
  std::string name;
  JointType type = JointType::Fixed;
  Port a, b;
  Vec3 axis = Vec3::UnitZ();   ///< inertial, at the start; unit
  Vec3 axis2 = Vec3::UnitX();  ///< universal joints: second axis, normal to the first; unit
  double pitch = 0;  ///< screw joints: displacement of b along `axis` a turn, m; < 0: left-handed
};

/// Prescribes coordinate `coordinate` of joint `joint`: q(t) = motion(t).
struct DriveSpec {
  int joint = 0;
  int coordinate = 0;
  TimeFunction motion;
};

/// q_second = ratio q_first: gears, racks, differentials, belts.
struct GearSpec {
  struct Coordinate {
    int joint = 0, coordinate = 0;
  };
  std::string name;
  Coordinate first, second;
  double ratio = 1;  ///< not 0; rad/rad, m/rad, rad/m or m/m
};

/// A share of a joint coordinate in a sum of them.
struct CoordinateShare {
  int coordinate = 0;
  double weight = 0;  ///< unit of the sum over that of the coordinate
};

/// Force law on a joint coordinate q (or a sum of some), or on the distance q of two ports:
/// f = stiffness (q - rest) + curve(q - rest) + damping dq/dt - force(t), acting against q.
struct ForceSpec {
  std::string name;
  int joint = -1;  ///< on joint coordinate `coordinate` if >= 0, else between ports a and b
  int coordinate = 0;
  std::vector<CoordinateShare> shares = {};  ///< q = `coordinate` + these
  Port a, b;
  double stiffness = 0;                  ///< N/m or N m/rad
  double damping = 0;                    ///< N s/m or N m s/rad
  double rest = 0;                       ///< m or rad
  TimeFunction force;                    ///< N or N m; positive pushes the coordinate up
  std::optional<ForceCurve> curve = {};  ///< of the elongation q - rest
};

/// Force and moment at a port, or per length along a beam body.
struct LoadSpec {
  std::string name;
  Port port;                   ///< a port, or any port of the beam if `spread`
  bool spread = false;         ///< per length over the whole beam: N/m and N m/m
  bool follower = false;       ///< components in the local frame, else inertial (dead)
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 moment = Vec3::Zero();  ///< N m
  TimeFunction scale = TimeFunction::constant(1);
};

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"  // enumerators with a scope of their own hide nothing
/// Which unknowns and which kind of body a mechanism is simulated with; all else is shared.
enum class Formalism {
  SE3,        ///< SE(3), or SE(2) in a plane: beams on the group, local frames
  R3SO3,      ///< R^3 x SO(3): inertial positions, rotations on their group, Reissner beams
  Classical,  ///< inertial positions and Cartesian rotation vectors (Geradin, Cardona)
  Floating,   ///< flexible bodies linear in a frame that moves with them, in modes
  Rigid,      ///< flexible bodies rigid
  Segments    ///< beams are chains of points without shear and torsion, with frames at their ends
};
#pragma GCC diagnostic pop
/// "se3", "r3so3", "classical", "floating", "rigid", "segments": as a scene calls it.
const char* to_string(Formalism formalism);
/// What a beam is simulated as under a formalism; AsFormalism: as the elements of that.
BeamModel model_of(const BeamSpec& beam, Formalism formalism);
/// Is a body simulated as a rigid one: deformation, internal forces and stress are 0 by definition?
bool moves_rigidly(const BodySpec& body, Formalism formalism);

/// How the rows Phi of joints and drives are enforced, forces B^T lambda.
enum class ConstraintForm {
  Multipliers,  ///< Phi = 0
  Penalty,      ///< lambda = alpha (Phi + tau dPhi/dt)
  Augmented     ///< lambda = lambda* + alpha (Phi + tau dPhi/dt), lambda* <- lambda until Phi = 0
};
/// "multipliers", "penalty", "augmented": as a scene calls it.
const char* to_string(ConstraintForm form);

/// Weights alpha of the rows. Those that are 0 are chosen from the stiffness and, for bodies
/// without, from the inertia within a step (mbs/system/penalty.hpp).
struct PenaltySpec {
  ConstraintForm form = ConstraintForm::Multipliers;
  double displacement = 0;  ///< of rows that are lengths, N/m; >= 0
  double rotation = 0;      ///< of rows that are angles, N m; >= 0
  double damping = 0;       ///< tau, s; >= 0
  double step = 1e-3;       ///< s, > 0: what weights that are chosen take the inertia over
};

/// How a step moves the frames of the nodes (see NodeCoordinates).
enum class NodeUpdate {
  AsFormalism,     ///< Screw for se3 and floating, R3SO3 for r3so3 and where no body deforms
  Screw,           ///< H <- H exp(dq): translation and rotation as one screw motion
  R3SO3,           ///< x <- x + dx, R <- R exp(dphi): keeps linear momentum
  RotationVector,  ///< x <- x + dx, psi <- psi + dpsi: the classical formalism and no other
};
/// The update that a formalism takes; itself unless AsFormalism.
NodeUpdate update_of(NodeUpdate chosen, Formalism formalism);

struct Mechanism {
  std::string name;
  Formalism formalism = Formalism::SE3;
  PenaltySpec penalty = {};
  NodeUpdate update = NodeUpdate::AsFormalism;
  Vec3 gravity = Vec3::Zero();
  TimeFunction gravity_scale = TimeFunction::constant(1);  ///< factor of gravity over time
  std::map<std::string, Vec3> ground_points;  ///< ports of the ground, with inertial axes
  std::vector<BodySpec> bodies;
  std::vector<JointSpec> joints;
  std::vector<DriveSpec> drives;
  std::vector<GearSpec> gears;
  std::vector<ForceSpec> forces;
  std::vector<LoadSpec> loads;

  /// Index of a body by name, -1 if there is none.
  int body(std::string_view name) const;
  /// Port by text: "ground", "ground.anchor" (named point), "rod.start", "rod.end", "rod.mid" (even
  /// number of elements), "rod.node3", "slider.origin", "top.tip" (named point: its frame has the
  /// axes of its body, or of its node of a beam), "rod.big_end" (interface of a meshed part). Empty
  /// if there is no such port.
  std::optional<Port> port(std::string_view text) const;
  /// Every port of a body by its full name ("rod.start"), for hints; body = -1: those of the
  /// ground.
  /// @throws std::invalid_argument for a body that does not exist
  std::vector<std::string> port_names(int body) const;
  /// Frame of a port in the scene as given: H_node * offset; of the ground: the offset. The nodes
  /// of a meshed part are its interfaces; further ones (amplitudes of modes) are at the first.
  /// @throws std::invalid_argument for a body or node that does not exist
  SE3 frame(const Port& port) const;
  /// Diagonal of the box around all nodes and named points, m.
  double size() const;
};

}  // namespace liesl
