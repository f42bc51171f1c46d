/// @file
/// Values of the kinds of responses.

#include <cmath>
#include <stdexcept>

#include "mbs/system/energy.hpp"
#include "mbs/system/response_value.hpp"
#include "mbs/system/vertex.hpp"

namespace liesl {
namespace {

Eigen::VectorXd scalar(double v) { return Eigen::VectorXd::Constant(1, v); }

Eigen::VectorXd along(const ResponseSpec& r, const Vec3& v) {
  return r.axis ? scalar(r.axis->dot(v)) : Eigen::VectorXd(v);
}

/// Nodes of a beam or interfaces of a part, where the scene puts them.
std::vector<SE3> nodes_at_rest(const BodySpec& body) {
  if (const auto* beam = std::get_if<BeamSpec>(&body.kind)) return beam->nodes;
  const auto& part = std::get<SolidSpec>(body.kind);
  std::vector<SE3> frames;
  for (size_t k = 0; k < part.interfaces().size(); ++k)
    frames.push_back(part.port(static_cast<int>(k)));
  return frames;
}

/// From the first node to the last, with the axes across it that offsets have components along.
class Chord {
 public:
  explicit Chord(const std::vector<SE3>& nodes) : start_(nodes.front().x) {
    const Vec3 chord = (nodes.back().x - start_).normalized();
    y_ = nodes.front().R.col(1);
    y_ = (y_ - y_.dot(chord) * chord).normalized();
    z_ = chord.cross(y_);
  }
  Eigen::Vector2d offset(const Vec3& point) const {
    const Vec3 from_start = point - start_;
    return {from_start.dot(y_), from_start.dot(z_)};
  }

 private:
  Vec3 start_, y_, z_;
};

/// The point at the share s of the elements of a chain.
Vec3 point_at(const std::vector<SE3>& nodes, double s) {
  const int n = static_cast<int>(nodes.size()) - 1;
  const int e = std::min(n - 1, static_cast<int>(s * n + 1e-9));
  const double inside = s * n - e;
  Vec3 point = nodes[e].x;
  if (inside > 1e-9) {
    const SE3::Tangent d = SE3::log(nodes[e].inverse() * nodes[e + 1]);
    point = (nodes[e] * SE3::exp(inside * d)).x;
  }
  return point;
}

}  // namespace

Eigen::Vector2d chord_offset(const std::vector<SE3>& nodes, double s) {
  return Chord(nodes).offset(point_at(nodes, s));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::position(const ResponseSpec& r, const State<G>& s) const {
  return along(r, view_.frame(s.H.data(), r.at).x);
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::translation(const ResponseSpec& r, const State<G>& s) const {
  return along(r, view_.frame(s.H.data(), r.at).x - mechanism_.frame(r.at).x);
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::velocity(const ResponseSpec& r, const State<G>& s) const {
  const Vec3 u = view_.velocity(s.v.data(), r.at).template head<3>();
  return along(r, r.in == Axes::Body ? u : Vec3(view_.frame(s.H.data(), r.at).R * u));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::angular_velocity(const ResponseSpec& r,
                                                    const State<G>& s) const {
  const Vec3 w = view_.velocity(s.v.data(), r.at).template tail<3>();
  return along(r, r.in == Axes::Body ? w : Vec3(view_.frame(s.H.data(), r.at).R * w));
}

/// A node between the ends of a chain of segments is a position: its axes are no unknowns.
template <FrameGroup G>
SE3::Tangent ResponseValues<G>::port_rate(const ResponseSpec& r, const State<G>& s) const {
  const Body<G>& body = *model_.bodies[r.at.body];
  if (body.kind(r.at.node) == NodeKind::Position)
    throw std::invalid_argument("response '" + r.name + "': node " + std::to_string(r.at.node) +
                                " of '" + body.name +
                                "' is a point without axes; expected a node at an end");
  return view_.velocity(s.vdot.data(), r.at);
}

/// R (u' + w x u)
template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::acceleration(const ResponseSpec& r, const State<G>& s) const {
  const SE3::Tangent v = view_.velocity(s.v.data(), r.at);
  const Vec3 a =
      port_rate(r, s).template head<3>() + v.template tail<3>().cross(v.template head<3>().eval());
  return along(r, r.in == Axes::Body ? a : Vec3(view_.frame(s.H.data(), r.at).R * a));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::angular_acceleration(const ResponseSpec& r,
                                                        const State<G>& s) const {
  const Vec3 a = port_rate(r, s).template tail<3>();
  return along(r, r.in == Axes::Body ? a : Vec3(view_.frame(s.H.data(), r.at).R * a));
}

template <FrameGroup G>
Vec3 ResponseValues<G>::rotation_of(const ResponseSpec& r, const State<G>& s) const {
  const Mat3 R = view_.frame(s.H.data(), r.at).R, start = mechanism_.frame(r.at).R;
  return r.in == Axes::Body ? SO3::log(Mat3(start.transpose() * R))
                            : SO3::log(Mat3(R * start.transpose()));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::rotation(const ResponseSpec& r, const State<G>& s) const {
  return along(r, rotation_of(r, s));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::displacement(const ResponseSpec& r, const State<G>& s) const {
  const Port base{r.at.body, 0, SE3::identity()};
  const SE3 F0 = view_.frame(s.H.data(), base);
  const Vec3 p = (F0.inverse() * view_.frame(s.H.data(), r.at)).x -
                 (mechanism_.frame(base).inverse() * mechanism_.frame(r.at)).x;
  return along(r, r.in == Axes::Body ? p : Vec3(F0.R * p));
}

template <FrameGroup G>
Eigen::Vector2d ResponseValues<G>::deflection_at(int body, const std::vector<SE3>& now,
                                                 double place) const {
  return chord_offset(now, place) - chord_offset(nodes_at_rest(mechanism_.bodies[body]), place);
}

template <FrameGroup G>
auto ResponseValues<G>::largest_deflection(int body, const std::vector<SE3>& now) const
    -> DeflectionAt {
  const std::vector<SE3> rest = nodes_at_rest(mechanism_.bodies[body]);
  const Chord chord(now), at_rest(rest);
  DeflectionAt largest;
  const int n = static_cast<int>(now.size()) - 1;
  for (int k = 1; k < n; ++k) {
    const double place = double(k) / n;
    const Eigen::Vector2d offset =
        chord.offset(point_at(now, place)) - at_rest.offset(point_at(rest, place));
    if (offset.norm() > largest.offset.norm()) largest = {place, offset};
  }
  return largest;
}

/// Sizes of the deflection at the nodes before, at and after a place.
template <FrameGroup G>
std::array<double, 3> ResponseValues<G>::beside(int body, const std::vector<SE3>& now,
                                                double place) const {
  const double h = 1. / static_cast<double>(now.size() - 1);
  const auto size = [&](double at) {
    return at < 0.5 * h || at > 1 - 0.5 * h ? 0 : deflection_at(body, now, at).norm();
  };
  return {size(place - h), size(place), size(place + h)};
}

template <FrameGroup G>
double ResponseValues<G>::above_the_nodes(const ResponseSpec& r, const State<G>& s) const {
  if (r.kind != ResponseKind::Deflection || !r.everywhere || is_meshed(r.body)) return 0;
  const std::vector<SE3> now = nodes(s.H.data(), r.body);
  const DeflectionAt largest = largest_deflection(r.body, now);
  if (largest.offset.isZero(0)) return 0;
  const auto [before, middle, after] = beside(r.body, now, largest.place);
  return vertex_above({-1, before}, {0, middle}, {1, after});
}

template <FrameGroup G>
int ResponseValues<G>::in_plane(int body) const {
  if constexpr (G::space_dim == 2) {
    const Vec3 normal = model_.space.frame.R.col(2);
    const SE3 first = mechanism_.frame({body, 0, SE3::identity()});
    return std::abs(first.R.col(1).dot(normal)) < 0.5 ? 0 : 1;
  }
  return 0;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::deflection(const ResponseSpec& r, const State<G>& s) const {
  const std::vector<SE3> now = nodes(s.H.data(), r.body);
  if (r.everywhere) return scalar(largest_deflection(r.body, now).offset.norm());
  const Eigen::Vector2d offset = deflection_at(r.body, now, r.s);
  return G::space_dim == 3 ? Eigen::VectorXd(offset) : scalar(offset[in_plane(r.body)]);
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::elongation(const ResponseSpec& r, const State<G>& s) const {
  const G* H = s.H.data();
  return scalar((view_.frame(H, r.to).x - view_.frame(H, r.at).x).norm() -
                (mechanism_.frame(r.to).x - mechanism_.frame(r.at).x).norm());
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::coordinate(const ResponseSpec& r, const State<G>& s) const {
  return scalar(joint_coordinates(mechanism_, model_, r.joint, s).at(r.coordinate));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::force_of_joint(const ResponseSpec& r, const State<G>& s) const {
  const Vec3 f = joint_force(mechanism_, model_, r.joint, s).template head<3>();
  if (!r.axis) return scalar(f.norm());
  const Port& b = mechanism_.joints[static_cast<size_t>(r.joint)].b;
  return scalar(r.axis->dot(r.in == Axes::Body ? f : Vec3(view_.frame(s.H.data(), b).R * f)));
}

template <FrameGroup G>
auto ResponseValues<G>::force_direction(const ResponseSpec& r, const Coupling<G>& c,
                                        const typename Row<G>::Vector& f, const State<G>& s) const
    -> typename Row<G>::Vector {
  if (!r.axis) return f.norm() == 0 ? f : f.normalized();
  const SE3 b = mechanism_.frame(mechanism_.joints[static_cast<size_t>(r.joint)].b);
  const Vec3 d = r.in == Axes::Body ? Vec3(b.R * *r.axis) : *r.axis;
  typename Row<G>::Vector a;
  if constexpr (G::space_dim == 2)
    a = (model_.space.frame.R.transpose() * d).template head<2>();
  else
    a = d;
  return r.in == Axes::Body ? a : typename Row<G>::Vector(c.b.frame(s.H).R.transpose() * a);
}

template <FrameGroup G>
int ResponseValues<G>::drive_row(const ResponseSpec& r) const {
  const Coupling<G>* c = find_joint(mechanism_, model_, r.joint);
  for (int i = 0; c && i < c->constraints; ++i) {
    const CouplingRow<G>& row = c->rows[static_cast<size_t>(i)];
    if (row.drive >= 0 &&
        mechanism_.drives[static_cast<size_t>(row.drive)].coordinate == r.coordinate)
      return c->first_constraint + i;
  }
  return -1;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::drive_force(const ResponseSpec& r, const State<G>& s) const {
  const int row = drive_row(r);
  return scalar(row < 0 ? 0 : -s.lambda[row]);
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::section_force(const ResponseSpec& r, const State<G>& s) const {
  return scalar(
      section_force_of(*model_.bodies[r.body], s, r.body, r.element, r.place)[r.component]);
}

template <FrameGroup G>
SE3::Tangent ResponseValues<G>::section_force_of(const Body<G>& body, const State<G>& s, int number,
                                                 int element, ElementPlace place) const {
  return view_.local(end_force(number)(body, model_.body_state(s, number), element, place), number,
                     element + node_of(place));
}

template <FrameGroup G>
const EndForce<G>& ResponseValues<G>::end_force(int body) const {
  return end_forces_.try_emplace(body, model_, body).first->second;
}

template <FrameGroup G>
auto ResponseValues<G>::largest_stress(const ResponseSpec& r, const State<G>& s) const -> StressAt {
  const auto& points = points_of(r.body);
  StressAt largest;
  const Body<G>& body = *model_.bodies[r.body];
  const EndForce<G>& force = end_force(r.body);
  const BodyState<G> state = model_.body_state(s, r.body);
  const bool one = r.point >= 0;
  const auto all = one ? std::vector<std::array<Tangent, 2>>() : force.all(body, state);
  for (int e = one ? r.element : 0; e < (one ? r.element + 1 : body.elements()); ++e) {
    const size_t half = points[e].size() / 2;
    for (const auto place : {ElementPlace::First, ElementPlace::Last}) {
      const auto end = static_cast<size_t>(node_of(place)), first = end * half;
      const auto point = static_cast<size_t>(r.point);
      if (one && (point < first || point >= first + half)) continue;
      const SE3::Tangent n =
          view_.local(one ? force(body, state, e, place) : all[static_cast<size_t>(e)][end], r.body,
                      e + node_of(place));
      for (size_t i = first; i < first + half; ++i) {
        if (r.point >= 0 && static_cast<int>(i) != r.point) continue;
        const Vec3 sigma = points[e][i].S * n;
        const double value = std::sqrt(sigma[0] * sigma[0] + 3 * sigma.tail<2>().squaredNorm());
        if (value <= largest.value) continue;
        const Vec3 weighted(sigma[0], 3 * sigma[1], 3 * sigma[2]);
        largest = {e, place, static_cast<int>(i), value, weighted / value, n};
      }
    }
  }
  return largest;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::stress(const ResponseSpec& r, const State<G>& s) const {
  return scalar(is_meshed(r.body) ? largest_cell(r.body, s).value() : largest_stress(r, s).value);
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::energy(const ResponseSpec&, const State<G>& s) const {
  return scalar(total(mechanical_energy(model_, s)));
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::compliance(const ResponseSpec& r, const State<G>& s) const {
  return scalar(
      2 * model_.bodies[r.body]->energy(model_.body_state(s, r.body), model_.gravity).elastic);
}

template <FrameGroup G>
const Coupling<G>* find_joint(const Mechanism& mechanism, const Model<G>& model, int joint) {
  for (const auto& c : model.couplings)
    if (c.is_joint && c.name == mechanism.joints[joint].name) return &c;
  return nullptr;
}

template <FrameGroup G>
double rate_of(const Coupling<G>& c, const typename Row<G>::Gradient& g, const State<G>& s) {
  constexpr int dim = G::dim;
  double rate = 0;
  if (c.a.body >= 0)
    rate += g.template head<dim>().dot(c.a.J * s.v.template segment<dim>(dim * c.a.node));
  if (c.b.body >= 0)
    rate += g.template tail<dim>().dot(c.b.J * s.v.template segment<dim>(dim * c.b.node));
  return rate;
}

template <FrameGroup G>
double row_force(const Coupling<G>& c, int row, const typename Row<G>::Gradient& g,
                 const State<G>& s) {
  if (row < c.constraints) return s.lambda[c.first_constraint + row];
  const ForceLaw& law = c.rows[row].law;
  return law.elastic(s.rows[c.first_row + row]) + law.damping * rate_of(c, g, s) - law.force(s.t);
}

template <FrameGroup G>
int rows_of_force(const Mechanism& mechanism, const Coupling<G>& c, int joint) {
  return kind_of(mechanism.joints[joint].type).elastic ? c.acting : c.constraints;
}

template <FrameGroup G>
SE3::Tangent joint_force(const Mechanism& mechanism, const Model<G>& model, int joint,
                         const State<G>& s) {
  SE3::Tangent total = SE3::Tangent::Zero();
  const Coupling<G>* c = find_joint(mechanism, model, joint);
  if (!c) return total;
  const G a = c->a.frame(s.H), b = c->b.frame(s.H);
  const RelativeMotion<G> motion(a, b);
  typename G::Tangent f = G::Tangent::Zero();
  const int rows = rows_of_force(mechanism, *c, joint);
  for (int i = 0; i < rows; ++i) {
    typename Row<G>::Gradient g;
    c->rows[i].row.gradient(motion, g);
    f -= row_force(*c, i, g, s) * g.template tail<G::dim>();
  }
  // The joint's port has the inertial axes at the start; turn into the port's own.
  const JointSpec& spec = mechanism.joints[joint];
  const SE3 own = mechanism.frame(spec.b);
  const SE3::Tangent inertial = model.space.embed_local(f, SE3::identity());
  Mat3 axes = Mat3::Identity();
  if constexpr (G::space_dim == 2) axes = model.space.frame.R;
  total << own.R.transpose() * axes * inertial.template head<3>(),
      own.R.transpose() * axes * inertial.template tail<3>();
  return total;
}

template <FrameGroup G>
std::vector<double> joint_coordinates(const Mechanism& mechanism, const Model<G>& model, int joint,
                                      const State<G>& s) {
  std::vector<double> q(kind_of(mechanism.joints[joint].type).coordinates.size(), 0.0);
  if (const Coupling<G>* c = find_joint(mechanism, model, joint))
    for (size_t i = 0; i < c->rows.size(); ++i)
      if (const int k = c->rows[i].coordinate; k >= 0)
        q[k] = s.rows[c->first_row + static_cast<int>(i)];
  return q;
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;
template int rows_of_force(const Mechanism&, const Coupling<SE2>&, int);
template int rows_of_force(const Mechanism&, const Coupling<SE3>&, int);
template double rate_of(const Coupling<SE2>&, const Row<SE2>::Gradient&, const State<SE2>&);
template double rate_of(const Coupling<SE3>&, const Row<SE3>::Gradient&, const State<SE3>&);
template double row_force(const Coupling<SE2>&, int, const Row<SE2>::Gradient&, const State<SE2>&);
template double row_force(const Coupling<SE3>&, int, const Row<SE3>::Gradient&, const State<SE3>&);
template const Coupling<SE2>* find_joint(const Mechanism&, const Model<SE2>&, int);
template const Coupling<SE3>* find_joint(const Mechanism&, const Model<SE3>&, int);
template SE3::Tangent joint_force(const Mechanism&, const Model<SE2>&, int, const State<SE2>&);
template SE3::Tangent joint_force(const Mechanism&, const Model<SE3>&, int, const State<SE3>&);
template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE2>&, int,
                                               const State<SE2>&);
template std::vector<double> joint_coordinates(const Mechanism&, const Model<SE3>&, int,
                                               const State<SE3>&);

}  // namespace liesl
