/// @file
/// Gradients of the kinds of responses, as cotangents: what a unit of the response is of an
/// increment [u; w] of a frame, in its own axes. Of a position x of a frame (R, x), d . x gives
/// [R^T d; 0].

#include "mbs/bodies/beam_element.hpp"
#include "mbs/system/energy.hpp"
#include "mbs/system/penalty.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {
namespace {

SE3::Tangent force(const Vec3& u) { return (SE3::Tangent() << u, Vec3::Zero()).finished(); }
SE3::Tangent wrench(const Vec3& u, const Vec3& w) { return (SE3::Tangent() << u, w).finished(); }

Vec3 direction(const ResponseSpec& r, int component) {
  return r.axis ? *r.axis : Vec3(Vec3::Unit(component));
}

/// Gradient of a . chord_offset: on the frames of the chain, [6] each.
std::vector<SE3::Tangent> chord_gradient(const std::vector<SE3>& nodes, double s,
                                         const Eigen::Vector2d& a) {
  std::vector<SE3::Tangent> out(nodes.size(), SE3::Tangent::Zero());
  const int n = static_cast<int>(nodes.size()) - 1;
  const int e = std::min(n - 1, static_cast<int>(s * n + 1e-9));
  const double inside = s * n - e;
  const bool at_node = inside <= 1e-9;
  SE3::Tangent d = SE3::Tangent::Zero();
  SE3 point = nodes[e];
  if (!at_node) {
    d = SE3::log(nodes[e].inverse() * nodes[e + 1]);
    point = nodes[e] * SE3::exp(inside * d);
  }
  const Vec3 span = nodes[n].x - nodes[0].x, c = span.normalized(), y0 = nodes[0].R.col(1);
  const Vec3 t = y0 - y0.dot(c) * c, y = t.normalized(), o = point.x - nodes[0].x;
  // f = o . (a_0 y + a_1 c x y), backwards.
  const Vec3 by_o = a[0] * y + a[1] * c.cross(y), by_y = a[0] * o + a[1] * o.cross(c);
  const Vec3 by_t = (by_y - y.dot(by_y) * y) / t.norm(), by_y0 = by_t - c.dot(by_t) * c;
  const Vec3 by_c = a[1] * y.cross(o) - c.dot(by_t) * y0 - y0.dot(c) * by_t;
  const Vec3 by_span = (by_c - c.dot(by_c) * c) / span.norm();
  const Mat3& R = nodes[0].R;
  out[0] += wrench(R.transpose() * (-by_span - by_o), Vec3::UnitY().cross(R.transpose() * by_y0));
  out[n] += force(nodes[n].R.transpose() * by_span);
  const SE3::Tangent on_point = force(point.R.transpose() * by_o);
  if (at_node) {
    out[e] += on_point;
  } else {
    const Eigen::Matrix<double, 12, 1> pair = BeamElement<SE3>::Q(d, inside).transpose() * on_point;
    out[e] += pair.head<6>();
    out[e + 1] += pair.tail<6>();
  }
  return out;
}

}  // namespace

template <FrameGroup G>
void ResponseValues<G>::add_port(Eigen::VectorXd& out, const Port& port,
                                 const SE3::Tangent& f) const {
  if (port.body < 0) return;
  const SE3::Tangent on_node = port.offset.AdInv().transpose() * f;
  auto node = out.template segment<G::dim>(G::dim * (model_.first_node(port.body) + port.node));
  for (int j = 0; j < G::dim; ++j)
    node[j] += view_.local(Tangent::Unit(j), port.body, port.node).dot(on_node);
}

template <FrameGroup G>
void ResponseValues<G>::add_row(Eigen::VectorXd& out, const Coupling<G>& c,
                                const Eigen::Matrix<double, 2 * G::dim, 1>& g) const {
  constexpr int dim = G::dim;
  if (c.a.body >= 0)
    out.template segment<dim>(dim * c.a.node) += c.a.J.transpose() * g.template head<dim>();
  if (c.b.body >= 0)
    out.template segment<dim>(dim * c.b.node) += c.b.J.transpose() * g.template tail<dim>();
}

template <FrameGroup G>
void ResponseValues<G>::add_section_force_of(int body, int element, ElementPlace place,
                                             const SE3::Tangent& f, const At& at,
                                             Cotangent& out) const {
  const int node = element + node_of(place), first = G::dim * model_.first_node(body);
  Tangent reduced;
  for (int j = 0; j < G::dim; ++j) reduced[j] = view_.local(Tangent::Unit(j), body, node).dot(f);
  end_force(body).add_gradient(*model_.bodies[body], model_.body_state(at.s, body), element, place,
                               reduced, out.h.data() + first);
}

template <FrameGroup G>
void ResponseValues<G>::add_position(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const SE3 F = view_.frame(at.s.H.data(), r.at);
  add_port(out.h, r.at, force(F.R.transpose() * direction(r, at.component)));
}

/// d . R u: R^T d on u, and u x R^T d on the rotation; d . u in the port's own axes.
template <FrameGroup G>
void ResponseValues<G>::add_velocity(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const Vec3 d = direction(r, at.component);
  if (r.in == Axes::Body) return add_port(out.v, r.at, force(d));
  const SE3 F = view_.frame(at.s.H.data(), r.at);
  const Vec3 u = view_.velocity(at.s.v.data(), r.at).template head<3>();
  const Vec3 local = F.R.transpose() * d;
  add_port(out.h, r.at, wrench(Vec3::Zero(), u.cross(local)));
  add_port(out.v, r.at, force(local));
}

template <FrameGroup G>
void ResponseValues<G>::add_angular_velocity(const ResponseSpec& r, const At& at,
                                             Cotangent& out) const {
  const Vec3 d = direction(r, at.component);
  if (r.in == Axes::Body) return add_port(out.v, r.at, wrench(Vec3::Zero(), d));
  const Vec3 w = view_.velocity(at.s.v.data(), r.at).template tail<3>();
  const Vec3 local = view_.frame(at.s.H.data(), r.at).R.transpose() * d;
  add_port(out.h, r.at, wrench(Vec3::Zero(), w.cross(local)));
  add_port(out.v, r.at, wrench(Vec3::Zero(), local));
}

/// d . R b, b = u' + w x u: b x R^T d on the rotation, and with l = R^T d (l = d in the port's own
/// axes) l on u', l x w on u, u x l on w.
template <FrameGroup G>
void ResponseValues<G>::add_acceleration(const ResponseSpec& r, const At& at,
                                         Cotangent& out) const {
  const SE3::Tangent v = view_.velocity(at.s.v.data(), r.at);
  const Vec3 u = v.template head<3>(), w = v.template tail<3>();
  Vec3 l = direction(r, at.component);
  if (r.in == Axes::Inertial) {
    l = view_.frame(at.s.H.data(), r.at).R.transpose() * l;
    const Vec3 b = port_rate(r, at.s).template head<3>() + w.cross(u);
    add_port(out.h, r.at, wrench(Vec3::Zero(), b.cross(l)));
  }
  add_port(out.v, r.at, wrench(l.cross(w), u.cross(l)));
  add_port(out.vdot, r.at, force(l));
}

template <FrameGroup G>
void ResponseValues<G>::add_angular_acceleration(const ResponseSpec& r, const At& at,
                                                 Cotangent& out) const {
  Vec3 l = direction(r, at.component);
  if (r.in == Axes::Inertial) {
    l = view_.frame(at.s.H.data(), r.at).R.transpose() * l;
    add_port(out.h, r.at, wrench(Vec3::Zero(), port_rate(r, at.s).template tail<3>().cross(l)));
  }
  add_port(out.vdot, r.at, wrench(Vec3::Zero(), l));
}

/// p = R_0^T (x - x_0): dp = R_0^T R u - u_0 - w_0 x p. In inertial axes R_0 (p - p*), p* of the
/// undeformed body: along d as p along R_0^T d, but that p* turns with R_0 instead of p.
template <FrameGroup G>
void ResponseValues<G>::add_displacement(const ResponseSpec& r, const At& at,
                                         Cotangent& out) const {
  const Port base{r.at.body, 0, SE3::identity()};
  const SE3 F0 = view_.frame(at.s.H.data(), base), F = view_.frame(at.s.H.data(), r.at);
  Vec3 d = direction(r, at.component), p = F0.R.transpose() * (F.x - F0.x);
  if (r.in == Axes::Inertial) {
    d = F0.R.transpose() * d;
    p = (mechanism_.frame(base).inverse() * mechanism_.frame(r.at)).x;
  }
  add_port(out.h, r.at, force(F.R.transpose() * (F0.R * d)));
  add_port(out.h, base, wrench(-d, d.cross(p)));
}

/// d/d(increment) of log(R R*^T) = T_l^-1(phi) R w in inertial axes, of log(R*^T R) T_r^-1(phi) w
/// in those of the port.
template <FrameGroup G>
void ResponseValues<G>::add_rotation(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const Vec3 d = direction(r, at.component);
  const SE3 F = view_.frame(at.s.H.data(), r.at);
  const Vec3 phi = rotation_of(r, at.s);
  if (r.in == Axes::Body)
    return add_port(out.h, r.at, wrench(Vec3::Zero(), SO3::Tinv(phi).transpose() * d));
  add_port(out.h, r.at,
           wrench(Vec3::Zero(), F.R.transpose() * (SO3::Tinv(Vec3(-phi)).transpose() * d)));
}

template <FrameGroup G>
void ResponseValues<G>::add_deflection(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const std::vector<SE3> now = nodes(at.s.H.data(), r.body);
  double place = r.s;
  Eigen::Vector2d a = Eigen::Vector2d::Unit(G::space_dim == 3 ? at.component : in_plane(r.body));
  if (r.everywhere) {
    const DeflectionAt largest = largest_deflection(r.body, now);
    if (largest.offset.norm() == 0) return;
    a = largest.offset.normalized();
    place = largest.place;
  }
  const auto on_nodes = chord_gradient(now, place, a);
  for (size_t k = 0; k < on_nodes.size(); ++k)
    add_port(out.h, {r.body, static_cast<int>(k), SE3::identity()}, on_nodes[k]);
}

template <FrameGroup G>
void ResponseValues<G>::add_elongation(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const SE3 from = view_.frame(at.s.H.data(), r.at), to = view_.frame(at.s.H.data(), r.to);
  const double length = (to.x - from.x).norm();
  if (length == 0) return;
  const Vec3 e = (to.x - from.x) / length;
  add_port(out.h, r.to, force(to.R.transpose() * e));
  add_port(out.h, r.at, force(-(from.R.transpose() * e)));
}

template <FrameGroup G>
void ResponseValues<G>::add_coordinate(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const Coupling<G>* c = find_joint(mechanism_, model_, r.joint);
  if (!c) return;
  const RelativeMotion<G> motion(c->a.frame(at.s.H), c->b.frame(at.s.H));
  for (const CouplingRow<G>& e : c->rows) {
    if (e.coordinate != r.coordinate) continue;
    typename Row<G>::Gradient g;
    e.row.gradient(motion, g);
    add_row(out.h, *c, g);
  }
}

template <FrameGroup G>
void ResponseValues<G>::add_drive_force(const ResponseSpec& r, const At&, Cotangent& out) const {
  if (const int row = drive_row(r); row >= 0) out.lambda[row] -= 1;
}

/// f = -sum F_i b_i, b_i the force of row i on port b, F_i a multiplier or the force of a law:
/// a . df = -sum a . b_i dF_i - sum F_i a . D b_i, a = f/|f| or a direction; of a law
/// dF = (df/dq g + c D g v) . h + c g . dv. A direction a = R^T d that stays in space while port b
/// turns by w gives da . f = (f x a) . w.
template <FrameGroup G>
void ResponseValues<G>::add_joint_force(const ResponseSpec& r, const At& at, Cotangent& out) const {
  constexpr int dim = G::dim, sd = G::space_dim;
  const Coupling<G>* c = find_joint(mechanism_, model_, r.joint);
  if (!c) return;
  const RelativeMotion<G> motion(c->a.frame(at.s.H), c->b.frame(at.s.H));
  const int rows = rows_of_force(mechanism_, *c, r.joint);
  std::vector<typename Row<G>::Gradient> g(rows);
  std::vector<double> F(rows);
  typename Row<G>::Vector f = Row<G>::Vector::Zero();
  for (int i = 0; i < rows; ++i) {
    c->rows[i].row.gradient(motion, g[i]);
    F[i] = row_force(*c, i, g[i], at.s);
    f -= F[i] * g[i].template segment<sd>(dim);
  }
  const typename Row<G>::Vector a = force_direction(r, *c, f, at.s);
  if (a.isZero(0)) return;
  typename Row<G>::Gradient v = Row<G>::Gradient::Zero(), on_h = v, on_v = v;
  if (c->a.body >= 0)
    v.template head<dim>() = c->a.J * at.s.v.template segment<dim>(dim * c->a.node);
  if (c->b.body >= 0)
    v.template tail<dim>() = c->b.J * at.s.v.template segment<dim>(dim * c->b.node);
  for (int i = 0; i < rows; ++i) {
    const double by_force = -a.dot(g[i].template segment<sd>(dim));
    const auto hessian = c->rows[i].row.hessian(motion);
    on_h -= F[i] * hessian.template middleRows<sd>(dim).transpose() * a;
    if (i < c->constraints) {
      out.lambda[c->first_constraint + i] += by_force;
      continue;
    }
    const ForceLaw& law = c->rows[i].law;
    on_h += by_force * (law.slope(at.s.rows[c->first_row + i]) * g[i] +
                        law.damping * (hessian.transpose() * v));
    on_v += by_force * law.damping * g[i];
  }
  if (r.axis && r.in == Axes::Inertial) {
    if constexpr (sd == 2)
      on_h[2 * dim - 1] += f[0] * a[1] - f[1] * a[0];
    else
      on_h.template tail<3>() += f.cross(a);
  }
  add_row(out.h, *c, on_h);
  add_row(out.v, *c, on_v);
}

template <FrameGroup G>
void ResponseValues<G>::add_section_force(const ResponseSpec& r, const At& at,
                                          Cotangent& out) const {
  add_section_force_of(r.body, r.element, r.place, SE3::Tangent::Unit(r.component), at, out);
}

template <FrameGroup G>
void ResponseValues<G>::add_stress(const ResponseSpec& r, const At& at, Cotangent& out) const {
  if (is_meshed(r.body)) return add_cell_stress(r, at, out);
  const StressAt largest = largest_stress(r, at.s);
  if (largest.value == 0) return;
  const auto& S = points_of(r.body)[largest.element][largest.point].S;
  add_section_force_of(r.body, largest.element, largest.place, S.transpose() * largest.gradient, at,
                       out);
}

template <FrameGroup G>
void ResponseValues<G>::add_body_energy(int body, const BodyEnergy& weight, const At& at,
                                        Cotangent& out) const {
  const int first = G::dim * model_.first_node(body);
  model_.bodies[body]->add_energy_gradient(
      model_.body_state(at.unknowns, body), model_.gravity_at(at.s.t), weight,
      out.unknown_h.data() + first, out.unknown_v.data() + first);
}

template <FrameGroup G>
void ResponseValues<G>::add_energy(const ResponseSpec&, const At& at, Cotangent& out) const {
  for (size_t b = 0; b < model_.bodies.size(); ++b)
    add_body_energy(static_cast<int>(b), {1, 1, 1}, at, out);
  const bool penalised = model_.penalty.form != ConstraintForm::Multipliers;
  const Eigen::VectorXd forces =
      penalised ? Eigen::VectorXd(model_.penalty.weight.cwiseProduct(openings(model_, at.s)))
                : Eigen::VectorXd();
  for (const auto& c : model_.couplings) {
    const RelativeMotion<G> motion(c.a.frame(at.s.H), c.b.frame(at.s.H));
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const CouplingRow<G>& e = c.rows[i];
      typename Row<G>::Gradient g;
      if (penalised && e.role == Role::Constraint) {
        e.row.gradient(motion, g);
        add_row(out.h, c, forces[c.first_constraint + static_cast<int>(i)] * g);
      }
      if (e.role != Role::Compliant) continue;
      e.row.gradient(motion, g);
      add_row(out.h, c, e.law.elastic(at.s.rows[c.first_row + static_cast<int>(i)]) * g);
    }
  }
}

template <FrameGroup G>
void ResponseValues<G>::add_compliance(const ResponseSpec& r, const At& at, Cotangent& out) const {
  add_body_energy(r.body, {0, 2, 0}, at, out);
}

template <FrameGroup G>
double ResponseValues<G>::section_force_by(const ResponseSpec& r, const State<G>& s,
                                           const ParameterResidual<G>& parameter) const {
  const Body<G>* body = parameter.body(r.body);
  if (!body) return 0;
  return section_force_of(*body, s, r.body, r.element, r.place)[r.component];
}

template <FrameGroup G>
double ResponseValues<G>::joint_force_by(const ResponseSpec& r, const State<G>& s,
                                         const ParameterResidual<G>& parameter) const {
  constexpr int dim = G::dim, sd = G::space_dim;
  const Coupling<G>* c = find_joint(mechanism_, model_, r.joint);
  if (!c) return 0;
  const RelativeMotion<G> motion(c->a.frame(s.H), c->b.frame(s.H));
  typename Row<G>::Vector f = Row<G>::Vector::Zero(), by_p = f;
  const int rows = rows_of_force(mechanism_, *c, r.joint);
  for (int i = 0; i < rows; ++i) {
    typename Row<G>::Gradient g;
    c->rows[i].row.gradient(motion, g);
    f -= row_force(*c, i, g, s) * g.template segment<sd>(dim);
    if (i < c->constraints) continue;
    const double q = s.rows[c->first_row + i], rate = rate_of(*c, g, s);
    by_p -= parameter.force_derivative(c->rows[i], q, rate, {s.t, 1}) * g.template segment<sd>(dim);
  }
  return force_direction(r, *c, f, s).dot(by_p);
}

template <FrameGroup G>
double ResponseValues<G>::stress_by(const ResponseSpec& r, const State<G>& s,
                                    const ParameterResidual<G>& parameter) const {
  if (is_meshed(r.body)) return cell_stress_by(r, s, parameter);
  const Body<G>* body = parameter.body(r.body);
  if (!body) return 0;
  const StressAt largest = largest_stress(r, s);
  if (largest.value == 0) return 0;
  const SE3::Tangent n = section_force_of(*body, s, r.body, largest.element, largest.place);
  Vec3 sigma = points_of(r.body)[largest.element][largest.point].S * n;
  for (const auto& part : parameter.parameter().parts)
    if (const auto* beam = std::get_if<BeamDerivative>(&part);
        beam && beam->body == r.body && !beam->stress.empty())
      sigma += beam->stress[largest.element][largest.point] * largest.n;
  return largest.gradient.dot(sigma);
}

/// (d sigma_vM/d sigma) . sigma of the neighbour.
template <FrameGroup G>
double ResponseValues<G>::stress_of_neighbour(const ResponseSpec& r, const State<G>& s,
                                              const ResponseValues& neighbour,
                                              const State<G>& seen) const {
  if (is_meshed(r.body)) return cell_stress_of_neighbour(r, s, neighbour, seen);
  const StressAt largest = largest_stress(r, s);
  if (largest.value == 0) return 0;
  const SE3::Tangent n = neighbour.section_force_of(*neighbour.model_.bodies[r.body], seen, r.body,
                                                    largest.element, largest.place);
  const Vec3 sigma = neighbour.points_of(r.body)[largest.element][largest.point].S * n;
  return largest.gradient.dot(sigma);
}

template <FrameGroup G>
double ResponseValues<G>::energy_by(const ResponseSpec&, const State<G>& s,
                                    const ParameterResidual<G>& parameter) const {
  double sum = 0;
  for (size_t b = 0; b < model_.bodies.size(); ++b)
    if (const Body<G>* body = parameter.body(static_cast<int>(b)))
      sum += total(body->energy(model_.body_state(s, static_cast<int>(b)), model_.gravity_at(s.t)));
  for (const auto& part : parameter.parameter().parts)
    if (const auto* by = std::get_if<ForceDerivative>(&part))
      for (const auto& c : model_.couplings)
        for (size_t i = 0; i < c.rows.size(); ++i) {
          const CouplingRow<G>& e = c.rows[i];
          if (e.force != by->force || e.role != Role::Compliant) continue;
          const double q = s.rows[c.first_row + static_cast<int>(i)], stretch = q - e.law.rest;
          sum += 0.5 * by->stiffness * stretch * stretch - e.law.elastic(q) * by->rest;
        }
  if (model_.penalty.form != ConstraintForm::Multipliers) {
    Eigen::VectorXd phi_p = Eigen::VectorXd::Zero(model_.constraints());
    parameter.add_target(s.t, 0, phi_p);
    sum += model_.penalty.weight.cwiseProduct(openings(model_, s)).dot(phi_p);
    for (const auto& part : parameter.parameter().parts)
      if (const auto* by = std::get_if<PenaltyDerivative>(&part))
        sum += penalty_energy_derivative(*by, model_, s);
  }
  return sum;
}

template <FrameGroup G>
double ResponseValues<G>::compliance_by(const ResponseSpec& r, const State<G>& s,
                                        const ParameterResidual<G>& parameter) const {
  const Body<G>* body = parameter.body(r.body);
  return body ? 2 * body->energy(model_.body_state(s, r.body), model_.gravity).elastic : 0;
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;

}  // namespace liesl
