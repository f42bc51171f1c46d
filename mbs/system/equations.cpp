#include "mbs/system/equations.hpp"

#include <limits>

namespace liesl {

template <FrameGroup G>
Equations<G>::Equations(const Model<G>& m) : model(m) {
  r.setZero(m.size());
  phi.setZero(m.constraints());
  gap = compliance = estimate = phi;
  if (m.penalty.form == ConstraintForm::Penalty) compliance = m.penalty.weight.cwiseInverse();
  scales_.resize(m.bodies.size());
  left_out_.resize(m.bodies.size());
  for (const auto& c : m.couplings) {
    CouplingData data;
    data.B.setZero(c.acting, 2 * dim);
    data.force.setZero(c.acting);
    data.rate.setZero(c.acting);
    data.slope.setZero(c.acting);
    couplings.push_back(std::move(data));
  }
  for (const auto& body : m.bodies) work_.push_back(body->make_workspace());
  for (const auto& body : m.bodies)
    round_off_ = std::max(round_off_, 4 * std::numeric_limits<double>::epsilon() *
                                          body->axial_stiffness() * m.extent);
}

template <FrameGroup G>
void Equations<G>::evaluate(const State<G>& s, const Eigen::VectorXd& previous,
                            const LoadLevel& level, const SectionForces* stress) {
  clear();
  add_bodies(s, level, stress);
  add_loads(s, level);
  add_couplings(s, previous, level);
  ForceScale sum;
  for (const auto& scale : scales_) {
    sum.force += scale.force;
    sum.moment += scale.moment;
  }
  scale_ = sum.norm(model.length);
}

template <FrameGroup G>
void Equations<G>::evaluate_couplings(const State<G>& s, const Eigen::VectorXd& previous,
                                      const LoadLevel& level) {
  clear();
  add_couplings(s, previous, level);
}

template <FrameGroup G>
void Equations<G>::clear() {
  for (auto& scale : scales_) scale = {};
  r.setZero();
  phi.setZero();
}

template <FrameGroup G>
void Equations<G>::add_couplings(const State<G>& s, const Eigen::VectorXd& previous,
                                 const LoadLevel& level) {
  for (size_t c = 0; c < couplings.size(); ++c)
    add_coupling(model.couplings[c], couplings[c], s, previous, level);
  gap = phi;
  if (model.penalty.form != ConstraintForm::Multipliers) add_compliance(s, level.t);
}

template <FrameGroup G>
void Equations<G>::add_bodies(const State<G>& s, const LoadLevel& level,
                              const SectionForces* stress) {
  const typename Model<G>::Vector gravity = level.factor * model.gravity_at(level.t);
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    if (left_out_[b]) continue;
    BodyState<G> state = model.body_state(s, static_cast<int>(b));
    state.work = work_[b].get();
    if (stress && !(*stress)[b].empty()) state.stress = (*stress)[b].front().data();
    double* out = r.data() + dim * model.first_node(static_cast<int>(b));
    model.bodies[b]->add_internal(state, out, scales_[b]);
    model.bodies[b]->add_inertia(state, gravity, out, scales_[b]);
  }
}

template <FrameGroup G>
void Equations<G>::add_loads(const State<G>& s, const LoadLevel& level) {
  for (const auto& load : model.loads) {
    const double factor = load_value(load.scale, level);
    if (load.port.body >= 0 && factor != 0)
      add_load(model, load, factor, s, r, scales_[load.port.body]);
  }
}

template <FrameGroup G>
void Equations<G>::add_load(const Model<G>& model, const Load<G>& load, double factor,
                            const State<G>& s, Eigen::VectorXd& out, ForceScale& scale) {
  using Tangent = typename G::Tangent;
  if (load.port.body < 0) return;
  const auto local = [&load](const G& H) {
    Tangent f = load.wrench;
    if (load.follower) return f;
    f.template head<G::space_dim>() = H.R.transpose() * load.wrench.template head<G::space_dim>();
    if constexpr (G::rotation_dim == 3)
      f.template tail<3>() = H.R.transpose() * load.wrench.template tail<3>();
    return f;
  };
  if (!load.spread) {
    const Tangent f = factor * local(load.port.frame(s.H));
    out.template segment<dim>(dim * load.port.node) -= load.port.J.transpose() * f;
    scale.add<G>(f);
    return;
  }
  const int first = model.first_node(load.port.body), n = model.bodies[load.port.body]->nodes();
  if (load.share.size() > 0) {
    out.segment(dim * first, dim * n).noalias() -= load.share * (factor * local(s.H[first]));
    scale.add<G>(Tangent(factor * load.wrench * load.share.template topRows<1>().norm()));
    return;
  }
  model.bodies[load.port.body]->add_spread_curvature(model.body_state(s, load.port.body),
                                                     {factor * load.wrench, load.follower},
                                                     out.data() + dim * first);
  for (int k = 0; k < n; ++k) {
    const Tangent y = factor * local(s.H[first + k]);
    const auto& W = load.distribution;
    auto at = [&](int i) { return out.template segment<dim>(dim * (first + i)); };
    const Tangent f = W.D[k] * y;
    at(k) -= f;
    if (k > 0) at(k - 1) -= W.U[k - 1] * y;
    if (k + 1 < n) at(k + 1) -= W.L[k] * y;
    scale.add<G>(f);
  }
}

template <FrameGroup G>
void Equations<G>::add_coupling(const Coupling<G>& c, CouplingData& data, const State<G>& s,
                                const Eigen::VectorXd& previous, const LoadLevel& level) {
  using Segment = Eigen::Matrix<double, dim, 1>;
  const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
  Segment on_a = Segment::Zero(), on_b = Segment::Zero();
  typename Row<G>::Gradient g;
  for (int i = 0; i < c.acting; ++i) {
    const CouplingRow<G>& e = c.rows[i];
    e.row.gradient(motion, g);
    auto B = data.B.row(i);
    if (c.a.body < 0)
      B.template head<dim>().setZero();
    else
      B.template head<dim>().noalias() = g.template head<dim>().transpose() * c.a.J;
    if (c.b.body < 0)
      B.template tail<dim>().setZero();
    else
      B.template tail<dim>().noalias() = g.template tail<dim>().transpose() * c.b.J;
    const double value = e.row.value(motion, previous[c.first_row + i]);
    double f;
    if (e.role == Role::Constraint) {
      phi[c.first_constraint + i] += value - e.target(level.t);
      f = s.lambda[c.first_constraint + i];
    } else {
      double rate = 0;
      if (c.a.body >= 0)
        rate += B.template head<dim>().dot(s.v.template segment<dim>(dim * c.a.node));
      if (c.b.body >= 0)
        rate += B.template tail<dim>().dot(s.v.template segment<dim>(dim * c.b.node));
      data.rate[i] = rate;
      f = e.law.elastic(value) + e.law.damping * rate - load_value(e.law.force, level);
      data.force[i] = f;
      data.slope[i] = e.law.slope(value);
    }
    on_a += f * B.template head<dim>().transpose();
    on_b += f * B.template tail<dim>().transpose();
  }
  const auto act = [&](const PortOf<G>& port, const Segment& f) {
    if (port.body < 0) return;
    r.template segment<dim>(dim * port.node) += f;
    scales_[port.body].template add<G>(f);
  };
  act(c.a, on_a);
  act(c.b, on_b);
}

template <FrameGroup G>
void Equations<G>::add_compliance(const State<G>& s, double t) {
  phi -= compliance.cwiseProduct(s.lambda - estimate);
  if (damping == 0) return;
  for (size_t index = 0; index < couplings.size(); ++index) {
    const Coupling<G>& c = model.couplings[index];
    for (int i = 0; i < c.constraints; ++i) {
      const auto B = couplings[index].B.row(i);
      double rate = -c.rows[i].target.rate(t);
      if (c.a.body >= 0)
        rate += B.template head<dim>().dot(s.v.template segment<dim>(dim * c.a.node));
      if (c.b.body >= 0)
        rate += B.template tail<dim>().dot(s.v.template segment<dim>(dim * c.b.node));
      phi[c.first_constraint + i] += damping * rate;
    }
  }
}

template <FrameGroup G>
void Equations<G>::observe(const State<G>& s, const Eigen::VectorXd& previous,
                           Eigen::VectorXd& rows) const {
  for (const auto& c : model.couplings) {
    const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const int row = c.first_row + static_cast<int>(i);
      rows[row] = c.rows[i].row.value(motion, previous[row]);
    }
  }
}

template <FrameGroup G>
double Equations<G>::load_power(const State<G>& s) {
  r.setZero();
  add_loads(s, {s.t, 1});
  return -r.dot(s.v);
}

template <FrameGroup G>
double Equations<G>::residual() const {
  return norm_of(0, model.nodes());
}

template <FrameGroup G>
double Equations<G>::residual(int body) const {
  return norm_of(model.first_node(body), model.bodies[body]->nodes());
}

template <FrameGroup G>
double Equations<G>::norm_of(int first, int nodes) const {
  ForceScale sum;
  for (int k = first; k < first + nodes; ++k) sum.add<G>(r.template segment<dim>(dim * k));
  return sum.norm(model.length);
}

template <FrameGroup G>
void Equations<G>::velocity_target(double t, Eigen::VectorXd& rate) const {
  rate.setZero();
  for (const auto& c : model.couplings)
    for (int i = 0; i < c.constraints; ++i)
      rate[c.first_constraint + i] += c.rows[i].target.rate(t);
}

template <FrameGroup G>
void Equations<G>::acceleration_target(const State<G>& s, double t, Eigen::VectorXd& rate) const {
  rate.setZero();
  for (const auto& c : model.couplings) {
    const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
    Eigen::Matrix<double, 2 * dim, 1> v = Eigen::Matrix<double, 2 * dim, 1>::Zero();
    if (c.a.body >= 0) v.template head<dim>() = c.a.J * s.v.template segment<dim>(dim * c.a.node);
    if (c.b.body >= 0) v.template tail<dim>() = c.b.J * s.v.template segment<dim>(dim * c.b.node);
    for (int i = 0; i < c.constraints; ++i)
      rate[c.first_constraint + i] +=
          c.rows[i].target.acceleration(t) - v.dot(c.rows[i].row.hessian(motion) * v);
  }
}

template class Equations<SE2>;
template class Equations<SE3>;

}  // namespace liesl
