#pragma once
/// @file
/// Values of named responses at a state, and their derivatives.

#include <array>
#include <map>
#include <vector>

#include "mbs/model/response.hpp"
#include "mbs/sections/stress.hpp"
#include "mbs/system/end_force.hpp"
#include "mbs/system/parameter_residual.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {

/// Number of components of a response: 1, 2 (deflection in space) or 3.
int components(const ResponseSpec& response, bool planar);
/// "deflection", ...: as a scene calls it.
const char* name_of(ResponseKind kind);
/// SI unit of a response.
const char* unit(const ResponseSpec& response, const Mechanism& mechanism);
/// Can the static problem of one part tell this response, by its magnitude?
bool has_static_image(const ResponseSpec& response, const Mechanism& mechanism);

/// Offset of the point s of a beam from its chord, along the chord's normals (y, z), m: y is the
/// section's y axis at node 0 made normal to the chord. `nodes` are the beam's spatial frames.
Eigen::Vector2d chord_offset(const std::vector<SE3>& nodes, double s);

/// dy of one component of a response,
///   dy = sum over nodes of h . delta_h + v . delta_v + vdot . delta_vdot + sum lambda .
///   delta_lambda,
/// delta_h the left-invariant increment of a frame, or that of the amplitudes of a node that holds
/// amplitudes; delta_v and delta_vdot those of its velocity and of the rate of that. Nodes that
/// follow others do not appear, nor what is zero.
template <FrameGroup G>
struct ResponseGradient {
  struct Node {
    int node;  ///< of the model
    typename G::Tangent h, v, vdot;
  };
  struct Multiplier {
    int row;  ///< in State::lambda
    double value;
  };
  std::vector<Node> nodes;
  std::vector<Multiplier> lambda;
};

/// Of which parts the static problem under equivalent static loads tells a response: of none, of
/// beams, of beams and meshed parts.
enum class StaticImage { None, OfBeams, OfParts };

/// What a kind of response is called, how many components it has, its unit, and its static image.
struct ResponseColumns {
  const char* name;
  int (*components)(const ResponseSpec& response, bool planar);
  const char* (*unit)(const ResponseSpec& response, const Mechanism& mechanism);
  StaticImage image = StaticImage::None;
};

/// Evaluates responses on a model of the mechanism. One row a kind (`response_value.cpp`).
template <FrameGroup G>
class ResponseValues {
 public:
  ResponseValues(const Mechanism& mechanism, const Model<G>& model);

  /// Value of a response, `components` numbers.
  /// Not for several threads at once: what depends on the sections alone is kept.
  /// @param s completed (Model::complete)
  Eigen::VectorXd operator()(const ResponseSpec& response, const State<G>& s) const;

  /// By how much the largest deflection of a beam between its nodes is above that at its nodes, as
  /// the parabola through three of them says; 0 of another response. @param s completed
  double above_the_nodes(const ResponseSpec& response, const State<G>& s) const;

  /// Gradient of each component. Where a response is not smooth it is that of the branch that is
  /// active: the node, element and stress point where the largest value is; zero for the norm of a
  /// vector that vanishes.
  /// @param s as the solvers have it: amplitudes and their rates, not completed
  std::vector<ResponseGradient<G>> gradient(const ResponseSpec& response, const State<G>& s) const;

  /// dy/dp of each component at constant state: what a section force, stress or energy takes from
  /// the law itself. All other kinds are kinematic, or forces of the state, and have none.
  /// @param s completed
  Eigen::VectorXd by_parameter(const ResponseSpec& response, const State<G>& s,
                               const ParameterResidual<G>& parameter) const;

  /// Value of a neighbouring model on its state `seen`, to be differenced at constant state: what
  /// is the largest of several places at the one that is largest here, stress linear about what is
  /// there, one side where it counts here. At a constant state a change of the geometry strains a
  /// body, by far more than its motion may do, so that the stress would be largest elsewhere, or
  /// with another sign.
  /// @param s, seen completed, each by its own model
  Eigen::VectorXd of_neighbour(const ResponseSpec& response, const State<G>& s,
                               const ResponseValues& neighbour, const State<G>& seen) const;

  /// Which of the two components, y (0) or z (1), is the deflection of a planar scene: the other is
  /// along the plane's normal.
  int in_plane(int body) const;

  static const ResponseColumns& columns(ResponseKind kind) { return row(kind).columns; }
  /// Has this kind an explicit derivative by a law? Else by_parameter is zero.
  static bool depends_on_law(ResponseKind kind) { return row(kind).by_parameter != nullptr; }

 private:
  using Tangent = typename G::Tangent;
  /// What is added to a gradient: on the frames, velocities and their rates of all nodes, followers
  /// among them, and on the unknowns.
  struct Cotangent {
    Eigen::VectorXd h, v, vdot, unknown_h, unknown_v, lambda;
  };
  /// The state as the solvers have it, completed, and which component.
  struct At {
    const State<G>& unknowns;
    const State<G>& s;
    int component;
  };
  struct StressAt {
    int element = 0;
    ElementPlace place = ElementPlace::First;
    int point = 0;                          ///< of the element
    double value = 0;                       ///< von Mises, Pa; 0: no stress anywhere
    Vec3 gradient = Vec3::Zero();           ///< by the stress at the point
    SE3::Tangent n = SE3::Tangent::Zero();  ///< section force, in space
  };

  /// The node between the ends of a beam, or interface of a part, with the largest deflection.
  struct DeflectionAt {
    double place = 0;                                  ///< as ResponseSpec::s
    Eigen::Vector2d offset = Eigen::Vector2d::Zero();  ///< zero: none has any
  };

  /// The cell of a meshed part with the largest von Mises stress of its share of material.
  struct CellAt {
    int cell = -1;          ///< -1: no cell has a stress
    double share = 0;       ///< of the stress that it shows
    Eigen::VectorXd sigma;  ///< of the material, Pa
    double size = 0;        ///< von Mises of that, Pa
    double value() const { return share * size; }
  };

  /// The row of a kind: what it is called, its value and its derivatives.
  struct Kind {
    ResponseKind kind;
    ResponseColumns columns;
    Eigen::VectorXd (ResponseValues::*value)(const ResponseSpec&, const State<G>&) const;
    void (ResponseValues::*add_gradient)(const ResponseSpec&, const At&, Cotangent&) const;
    /// Null: no explicit derivative.
    double (ResponseValues::*by_parameter)(const ResponseSpec&, const State<G>&,
                                           const ParameterResidual<G>&) const;
  };
  static const Kind& row(ResponseKind kind);
  static Eigen::VectorXd side_of(const ResponseSpec& r, const Eigen::VectorXd& y);

  Eigen::VectorXd position(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd velocity(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd angular_velocity(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd acceleration(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd angular_acceleration(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd rotation(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd displacement(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd deflection(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd elongation(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd coordinate(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd force_of_joint(const ResponseSpec& r, const State<G>& s) const;
  /// a of y = a . f, in the axes of the joint's port b; f/|f| of the norm, 0 where f is.
  typename Row<G>::Vector force_direction(const ResponseSpec& r, const Coupling<G>& c,
                                          const typename Row<G>::Vector& f,
                                          const State<G>& s) const;
  Eigen::VectorXd drive_force(const ResponseSpec& r, const State<G>& s) const;
  int drive_row(const ResponseSpec& r) const;  ///< among the multipliers; -1: no drive
  Eigen::VectorXd section_force(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd stress(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd energy(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd compliance(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd translation(const ResponseSpec& r, const State<G>& s) const;
  Eigen::VectorXd member(const ResponseSpec& r, const State<G>& s) const;

  void add_position(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_velocity(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_angular_velocity(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_acceleration(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_angular_acceleration(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_rotation(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_displacement(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_deflection(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_elongation(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_coordinate(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_joint_force(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_drive_force(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_section_force(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_stress(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_energy(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_compliance(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_member(const ResponseSpec& r, const At& at, Cotangent& out) const;
  void add_body_energy(int body, const BodyEnergy& weight, const At& at, Cotangent& out) const;
  void add_cell_stress(const ResponseSpec& r, const At& at, Cotangent& out) const;

  double section_force_by(const ResponseSpec& r, const State<G>& s,
                          const ParameterResidual<G>& parameter) const;
  double joint_force_by(const ResponseSpec& r, const State<G>& s,
                        const ParameterResidual<G>& parameter) const;
  double stress_by(const ResponseSpec& r, const State<G>& s,
                   const ParameterResidual<G>& parameter) const;
  double cell_stress_by(const ResponseSpec& r, const State<G>& s,
                        const ParameterResidual<G>& parameter) const;
  double stress_of_neighbour(const ResponseSpec& r, const State<G>& s,
                             const ResponseValues& neighbour, const State<G>& seen) const;
  double cell_stress_of_neighbour(const ResponseSpec& r, const State<G>& s,
                                  const ResponseValues& neighbour, const State<G>& seen) const;
  double member_of_neighbour(const ResponseSpec& r, const State<G>& s,
                             const ResponseValues& neighbour, const State<G>& seen) const;
  double energy_by(const ResponseSpec& r, const State<G>& s,
                   const ParameterResidual<G>& parameter) const;
  double compliance_by(const ResponseSpec& r, const State<G>& s,
                       const ParameterResidual<G>& parameter) const;
  double member_by(const ResponseSpec& r, const State<G>& s,
                   const ParameterResidual<G>& parameter) const;

  /// AxialStress, Buckling, LocalBuckling: n . row at the place where it is largest, n the section
  /// force; the row follows from the section at `end`.
  struct MemberAt {
    int element = 0;
    ElementPlace end = ElementPlace::First;
    int point = 0;  ///< stress point of the element
    SE3::Tangent row = SE3::Tangent::Zero();
    SE3::Tangent n = SE3::Tangent::Zero();  ///< at the end, by EndForce
    double value = 0;                       ///< row . n
  };
  SE3::Tangent row_of_member(const ResponseSpec& r, int element, ElementPlace end, int point,
                             double length) const;
  MemberAt largest_of_member(const ResponseSpec& r, const State<G>& s) const;
  /// [u'; w'] of the port of an acceleration, in its own axes.
  /// @throws std::invalid_argument for a node that is a point without axes
  SE3::Tangent port_rate(const ResponseSpec& r, const State<G>& s) const;
  /// Rotation vector of a port since the scene as given, in the axes that the response is in.
  Vec3 rotation_of(const ResponseSpec& r, const State<G>& s) const;
  /// Offset of the point `place` of a beam whose frames are `now` from where it is undeformed.
  Eigen::Vector2d deflection_at(int body, const std::vector<SE3>& now, double place) const;
  DeflectionAt largest_deflection(int body, const std::vector<SE3>& now) const;
  std::array<double, 3> beside(int body, const std::vector<SE3>& now, double place) const;
  std::vector<SE3> nodes(const G* H, int body) const;
  StressAt largest_stress(const ResponseSpec& r, const State<G>& s) const;
  bool is_meshed(int body) const;
  CellAt largest_cell(int body, const State<G>& s) const;
  const EndForce<G>& end_force(int body) const;
  const std::vector<std::vector<StressPoint>>& points_of(int body) const;
  /// Adds the cotangent f [6] of a port's increment, or velocity, to that of its node.
  void add_port(Eigen::VectorXd& out, const Port& port, const SE3::Tangent& f) const;
  void add_row(Eigen::VectorXd& out, const Coupling<G>& c,
               const Eigen::Matrix<double, 2 * G::dim, 1>& g) const;
  /// Section force of a body, or of its derivative, in space.
  SE3::Tangent section_force_of(const Body<G>& body, const State<G>& s, int number, int element,
                                ElementPlace place) const;
  /// Adds the gradient of f . n, n the section force in space.
  void add_section_force_of(int body, int element, ElementPlace place, const SE3::Tangent& f,
                            const At& at, Cotangent& out) const;

  const Mechanism& mechanism_;
  const Model<G>& model_;
  SpatialView<G> view_;
  /// Of the beams whose stress was asked for, by body and element: `element_stress_points`.
  mutable std::map<int, std::vector<std::vector<StressPoint>>> stress_points_;
  mutable std::map<int, EndForce<G>> end_forces_;
};

/// Force and moment [6] that a joint transmits to its port b, in b's own axes; and the coordinates
/// of a joint. `joint` counts the joints of the mechanism.
template <FrameGroup G>
SE3::Tangent joint_force(const Mechanism& mechanism, const Model<G>& model, int joint,
                         const State<G>& s);
template <FrameGroup G>
std::vector<double> joint_coordinates(const Mechanism& mechanism, const Model<G>& model, int joint,
                                      const State<G>& s);
/// Rows of a joint that its force is made of: constraints and drives; of cylinders and bushings
/// their springs, dampers and forces, too. Those are c.rows[0] to c.rows[rows_of_force - 1].
template <FrameGroup G>
int rows_of_force(const Mechanism& mechanism, const Coupling<G>& c, int joint);
/// dq/dt of a row with the gradient g.
template <FrameGroup G>
double rate_of(const Coupling<G>& c, const typename Row<G>::Gradient& g, const State<G>& s);
/// The multiplier, or the force of the law at s (F(t) that of the time s.t), of an acting row.
template <FrameGroup G>
double row_force(const Coupling<G>& c, int row, const typename Row<G>::Gradient& g,
                 const State<G>& s);
/// The coupling of a joint, null if the plane has made its rows identities.
template <FrameGroup G>
const Coupling<G>* find_joint(const Mechanism& mechanism, const Model<G>& model, int joint);

extern template class ResponseValues<SE2>;
extern template class ResponseValues<SE3>;
extern template SE3::Tangent joint_force(const Mechanism&, const Model<SE2>&, int,
                                         const State<SE2>&);
extern template SE3::Tangent joint_force(const Mechanism&, const Model<SE3>&, int,
                                         const State<SE3>&);
extern template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE2>&, int,
                                                      const State<SE2>&);
extern template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE3>&, int,
                                                      const State<SE3>&);

}  // namespace liesl
