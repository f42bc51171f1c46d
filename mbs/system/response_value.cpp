#include "mbs/system/response_value.hpp"

#include <array>

#include "mbs/model/beam_ends.hpp"

namespace liesl {
namespace {

int one(const ResponseSpec&, bool) { return 1; }
int vector(const ResponseSpec& r, bool) { return r.axis ? 1 : 3; }
int offset(const ResponseSpec& r, bool planar) { return planar || r.everywhere ? 1 : 2; }

const char* metres(const ResponseSpec&, const Mechanism&) { return "m"; }
const char* metres_a_second(const ResponseSpec&, const Mechanism&) { return "m/s"; }
const char* radians_a_second(const ResponseSpec&, const Mechanism&) { return "rad/s"; }
const char* metres_a_square_second(const ResponseSpec&, const Mechanism&) { return "m/s^2"; }
const char* radians_a_square_second(const ResponseSpec&, const Mechanism&) { return "rad/s^2"; }
const char* radians(const ResponseSpec&, const Mechanism&) { return "rad"; }
const char* newtons(const ResponseSpec&, const Mechanism&) { return "N"; }
const char* pascals(const ResponseSpec&, const Mechanism&) { return "Pa"; }
const char* share(const ResponseSpec&, const Mechanism&) { return "-"; }
const char* joules(const ResponseSpec&, const Mechanism&) { return "J"; }
const char* of_section(const ResponseSpec& r, const Mechanism&) {
  return r.component < 3 ? "N" : "N m";
}
const char* of_drive(const ResponseSpec& r, const Mechanism& mechanism) {
  const std::string coordinate = kind_of(mechanism.joints[r.joint].type).unit(r.coordinate);
  return coordinate == "rad" ? "N m" : "N";
}
const char* of_coordinate(const ResponseSpec& r, const Mechanism& mechanism) {
  return kind_of(mechanism.joints[r.joint].type).unit(r.coordinate);
}

}  // namespace

/// In the order of ResponseKind. Static problems tell deformations, and of beams what follows from
/// them.
template <FrameGroup G>
auto ResponseValues<G>::row(ResponseKind kind) -> const Kind& {
  using R = ResponseValues;
  using K = ResponseKind;
  static const std::array<Kind, 20> rows{{
      {K::Position, {"position", vector, metres}, &R::position, &R::add_position, nullptr},
      {K::Velocity, {"velocity", vector, metres_a_second}, &R::velocity, &R::add_velocity, nullptr},
      {K::AngularVelocity,
       {"angular_velocity", vector, radians_a_second},
       &R::angular_velocity,
       &R::add_angular_velocity,
       nullptr},
      {K::Rotation, {"rotation", vector, radians}, &R::rotation, &R::add_rotation, nullptr},
      {K::Displacement,
       {"displacement", vector, metres, StaticImage::OfParts},
       &R::displacement,
       &R::add_displacement,
       nullptr},
      {K::Deflection,
       {"deflection", offset, metres, StaticImage::OfBeams},
       &R::deflection,
       &R::add_deflection,
       nullptr},
      {K::Elongation,
       {"elongation", one, metres, StaticImage::OfParts},
       &R::elongation,
       &R::add_elongation,
       nullptr},
      {K::Coordinate,
       {"coordinate", one, of_coordinate},
       &R::coordinate,
       &R::add_coordinate,
       nullptr},
      {K::JointForce,
       {"joint_force", one, newtons},
       &R::force_of_joint,
       &R::add_joint_force,
       &R::joint_force_by},
      {K::DriveForce,
       {"drive_force", one, of_drive},
       &R::drive_force,
       &R::add_drive_force,
       nullptr},
      {K::SectionForce,
       {"section_force", one, of_section},
       &R::section_force,
       &R::add_section_force,
       &R::section_force_by},
      {K::Stress,
       {"stress", one, pascals, StaticImage::OfBeams},
       &R::stress,
       &R::add_stress,
       &R::stress_by},
      {K::Energy, {"energy", one, joules}, &R::energy, &R::add_energy, &R::energy_by},
      {K::Compliance,
       {"compliance", one, joules, StaticImage::OfBeams},
       &R::compliance,
       &R::add_compliance,
       &R::compliance_by},
      {K::AxialStress, {"axial_stress", one, pascals}, &R::member, &R::add_member, &R::member_by},
      {K::Buckling, {"buckling", one, share}, &R::member, &R::add_member, &R::member_by},
      {K::LocalBuckling, {"local_buckling", one, share}, &R::member, &R::add_member, &R::member_by},
      {K::Translation, {"translation", vector, metres}, &R::translation, &R::add_position, nullptr},
      {K::Acceleration,
       {"acceleration", vector, metres_a_square_second},
       &R::acceleration,
       &R::add_acceleration,
       nullptr},
      {K::AngularAcceleration,
       {"angular_acceleration", vector, radians_a_square_second},
       &R::angular_acceleration,
       &R::add_angular_acceleration,
       nullptr},
  }};
  return rows[static_cast<size_t>(kind)];
}

int components(const ResponseSpec& r, bool planar) {
  return ResponseValues<SE3>::columns(r.kind).components(r, planar);
}

const char* name_of(ResponseKind kind) { return ResponseValues<SE3>::columns(kind).name; }

const char* unit(const ResponseSpec& r, const Mechanism& mechanism) {
  return ResponseValues<SE3>::columns(r.kind).unit(r, mechanism);
}

bool has_static_image(const ResponseSpec& r, const Mechanism& mechanism) {
  const int body = deformed_body(r);
  if (r.side != Side::Both || body < 0 || body >= static_cast<int>(mechanism.bodies.size()))
    return false;
  const auto& kind = mechanism.bodies[static_cast<size_t>(body)].kind;
  const StaticImage image = ResponseValues<SE3>::columns(r.kind).image;
  if (std::holds_alternative<BeamSpec>(kind)) return image != StaticImage::None;
  const auto* solid = std::get_if<SolidSpec>(&kind);
  return image == StaticImage::OfParts && solid && solid->as == SolidMotion::Reduced;
}

template <FrameGroup G>
ResponseValues<G>::ResponseValues(const Mechanism& mechanism, const Model<G>& model)
    : mechanism_(mechanism), model_(model), view_(mechanism, model) {}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::operator()(const ResponseSpec& r, const State<G>& s) const {
  const Eigen::VectorXd y = (this->*row(r.kind).value)(r, s);
  return r.side == Side::Both ? y : Eigen::VectorXd(y.cwiseProduct(side_of(r, y)));
}

/// Factor of each component: 1; of one side -1, 0 or 1.
template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::side_of(const ResponseSpec& r, const Eigen::VectorXd& y) {
  const double sign = r.side == Side::Down ? -1 : 1;
  return y.unaryExpr([&](double value) {
    return r.side == Side::Both ? 1. : sign * value > 0 ? sign : 0.;
  });
}

template <FrameGroup G>
std::vector<ResponseGradient<G>> ResponseValues<G>::gradient(const ResponseSpec& r,
                                                             const State<G>& s) const {
  constexpr int dim = G::dim;
  State<G> completed = s;
  model_.complete(completed);
  std::vector<ResponseGradient<G>> all(components(r, G::space_dim == 2));
  Cotangent c;
  const Eigen::VectorXd side = side_of(r, (this->*row(r.kind).value)(r, completed));
  for (size_t i = 0; i < all.size(); ++i) {
    if (side[static_cast<Eigen::Index>(i)] == 0) continue;
    for (auto* x : {&c.h, &c.v, &c.vdot, &c.unknown_h, &c.unknown_v}) x->setZero(model_.size());
    c.lambda.setZero(model_.constraints());
    (this->*row(r.kind).add_gradient)(r, {s, completed, static_cast<int>(i)}, c);
    for (size_t b = 0; b < model_.bodies.size(); ++b) {
      const int at = dim * model_.first_node(static_cast<int>(b));
      const BodyState<G> state = model_.body_state(s, static_cast<int>(b));
      double *h = c.h.data() + at, *v = c.v.data() + at;
      model_.bodies[b]->to_unknowns(state, h, v);
      model_.bodies[b]->rates_to_unknowns(state, h, v, c.vdot.data() + at);
    }
    c.h += c.unknown_h;
    c.v += c.unknown_v;
    if (r.side == Side::Down)
      for (auto* x : {&c.h, &c.v, &c.vdot, &c.lambda}) *x = -*x;
    for (int k = 0; k < model_.nodes(); ++k) {
      const auto h = c.h.template segment<dim>(dim * k), v = c.v.template segment<dim>(dim * k),
                 vdot = c.vdot.template segment<dim>(dim * k);
      if (!h.isZero(0) || !v.isZero(0) || !vdot.isZero(0)) all[i].nodes.push_back({k, h, v, vdot});
    }
    for (int k = 0; k < c.lambda.size(); ++k)
      if (c.lambda[k] != 0) all[i].lambda.push_back({k, c.lambda[k]});
  }
  return all;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::by_parameter(const ResponseSpec& r, const State<G>& s,
                                                const ParameterResidual<G>& parameter) const {
  const auto derivative = row(r.kind).by_parameter;
  Eigen::VectorXd y = Eigen::VectorXd::Zero(components(r, G::space_dim == 2));
  if (!derivative) return y;
  y[0] = (this->*derivative)(r, s, parameter);
  return r.side == Side::Both
             ? y
             : Eigen::VectorXd(y.cwiseProduct(side_of(r, (this->*row(r.kind).value)(r, s))));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::of_neighbour(const ResponseSpec& r, const State<G>& s,
                                                const ResponseValues& neighbour,
                                                const State<G>& seen) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(1);
  if (r.kind == ResponseKind::Stress)
    y[0] = stress_of_neighbour(r, s, neighbour, seen);
  else if (row(r.kind).value == &ResponseValues::member)
    y[0] = member_of_neighbour(r, s, neighbour, seen);
  else
    y = (neighbour.*row(r.kind).value)(r, seen);
  return r.side == Side::Both
             ? y
             : Eigen::VectorXd(y.cwiseProduct(side_of(r, (this->*row(r.kind).value)(r, s))));
}

template <FrameGroup G>
std::vector<SE3> ResponseValues<G>::nodes(const G* H, int body) const {
  std::vector<SE3> frames;
  for (int k = 0; k < model_.bodies[body]->points(); ++k) frames.push_back(view_.node(H, body, k));
  return frames;
}

template <FrameGroup G>
const std::vector<std::vector<StressPoint>>& ResponseValues<G>::points_of(int body) const {
  const auto [known, fresh] = stress_points_.try_emplace(body);
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[body].kind);
  for (size_t e = 0; fresh && e < beam.sections.size(); ++e)
    known->second.push_back(element_stress_points(beam, e));
  return known->second;
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;

}  // namespace liesl
