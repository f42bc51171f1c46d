#include "mbs/system/parameter_residual.hpp"

#include <algorithm>
#include <stdexcept>

#include "mbs/bodies/beam.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "mbs/system/body_law.hpp"
#include "mbs/system/penalty.hpp"

namespace liesl {
namespace {

/// Data of body `body` if it is of this kind, else null.
template <class Kind>
const Kind* kind_of(const Mechanism& mechanism, int body) {
  const bool known = body >= 0 && body < static_cast<int>(mechanism.bodies.size());
  return known ? std::get_if<Kind>(&mechanism.bodies[body].kind) : nullptr;
}

/// f, df/dt or d^2f/dt^2.
double derivative(const TimeFunction& f, double t, int order) {
  return order == 0 ? f(t) : order == 1 ? f.rate(t) : f.acceleration(t);
}

double value(const FunctionDerivative& by_p, double t, int order = 0) {
  double sum = 0;
  for (const WeightedFunction& f : by_p) sum += f.weight * derivative(f.function, t, order);
  return sum;
}

/// d(force)/dp of a law.
double by_law(const ForceDerivative& by, const ForceLaw& law, double q, double rate,
              const LoadLevel& level) {
  return by.stiffness * (q - law.rest) + by.damping * rate - law.slope(q) * by.rest -
         by.factor * load_value(law.force, level) - level.factor * value(by.function, level.t);
}

std::string expected(const char* what, int number) {
  return "expected the number of a " + std::string(what) + ", got " + std::to_string(number);
}

}  // namespace

template <FrameGroup G>
ParameterResidual<G>::ParameterResidual(const Mechanism& mechanism, const Model<G>& model,
                                        const Parameter& parameter)
    : model_(model),
      parameter_(parameter),
      bodies_(model.bodies.size()),
      work_(model.bodies.size()) {
  std::string problems;
  for (const auto& part : parameter.parts) {
    const std::string problem =
        std::visit([&](const auto& p) { return add_part(mechanism, p); }, part);
    if (!problem.empty()) problems += (problems.empty() ? "" : "; ") + problem;
  }
  if (!problems.empty())
    throw std::invalid_argument("parameter '" + parameter.name + "': " + problems);
  std::sort(nodes_.begin(), nodes_.end());
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
}

template <FrameGroup G>
void ParameterResidual<G>::add_nodes(int first, int count) {
  for (int k = first; k < first + count; ++k) nodes_.push_back(k);
}

template <FrameGroup G>
void ParameterResidual<G>::add_nodes_of(int body) {
  add_nodes(model_.first_node(body), model_.bodies[body]->nodes());
}

template <FrameGroup G>
std::string ParameterResidual<G>::set_body(int body, const LawDerivative<G>& law) {
  if (bodies_[body])
    return "body '" + model_.bodies[body]->name + "' is named twice, expected one sum of both";
  bodies_[body] = model_.bodies[body]->derivative(law);
  work_[body] = bodies_[body]->make_workspace();
  return "";
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism, const BeamDerivative& part) {
  const auto* beam = kind_of<BeamSpec>(mechanism, part.body);
  if (!beam) return expected("beam", part.body);
  if (part.laws.size() != beam->sections.size())
    return "expected section laws of " + std::to_string(beam->sections.size()) +
           " elements of beam '" + mechanism.bodies[part.body].name + "', got " +
           std::to_string(part.laws.size());
  const Body<G>& body = *model_.bodies[part.body];
  for (std::size_t e = 0; e < part.laws.size(); ++e) {
    if (part.laws[e].K.isZero(0) && part.laws[e].M.isZero(0)) continue;
    const auto [first, count] = body.nodes_of(static_cast<int>(e));
    add_nodes(model_.first_node(part.body) + first, count);
  }
  return set_body(part.body, reduce_laws(*beam, part.laws, model_.space));
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism,
                                           const RigidDerivative& part) {
  const auto* rigid = kind_of<RigidSpec>(mechanism, part.body);
  if (!rigid) return expected("rigid body", part.body);
  add_nodes_of(part.body);
  const SE3 align = model_.space.alignment(rigid->frame);
  return set_body(part.body, typename G::Matrix(model_.space.reduce_law(
                                 generalized_inertia_derivative(*rigid, part), align)));
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism,
                                           const SolidDerivative& part) {
  const auto* solid = kind_of<SolidSpec>(mechanism, part.body);
  if (!solid) return expected("meshed part", part.body);
  if (part.fractions.size() != solid->mesh().cell_count())
    return "expected fractions of " + std::to_string(solid->mesh().cell_count()) +
           " cells of part '" + mechanism.bodies[part.body].name + "', got " +
           std::to_string(part.fractions.size());
  add_nodes_of(part.body);
  return set_body(part.body, FractionDerivative{solid->model.get(), solid_fractions(*solid).value,
                                                part.fractions});
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism, const SolidScale& part) {
  if (!kind_of<SolidSpec>(mechanism, part.body)) return expected("meshed part", part.body);
  add_nodes_of(part.body);
  return set_body(part.body, ScaleDerivative{part.stiffness(), part.mass(), part.E});
}

template <FrameGroup G>
template <class Matches>
void ParameterResidual<G>::add_rows(RowDerivative part, Matches matches) {
  for (const auto& c : model_.couplings)
    for (size_t i = 0; i < c.rows.size(); ++i)
      if (matches(c.rows[i])) {
        part.coupling = &c;
        part.equation = &c.rows[i];
        part.row = static_cast<int>(i);
        rows_.push_back(part);
        if (c.rows[i].role == Role::Constraint) continue;
        if (c.a.body >= 0) add_nodes(c.a.node, 1);
        if (c.b.body >= 0) add_nodes(c.b.node, 1);
      }
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism,
                                           const ForceDerivative& part) {
  if (part.force < 0 || part.force >= static_cast<int>(mechanism.forces.size()))
    return expected("force", part.force);
  add_rows({nullptr, nullptr, 0, part, 0},
           [&](const CouplingRow<G>& e) { return e.force == part.force; });
  return "";
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism,
                                           const DriveDerivative& part) {
  if (part.drive < 0 || part.drive >= static_cast<int>(mechanism.drives.size()))
    return expected("drive", part.drive);
  add_rows({nullptr, nullptr, 0, {}, part.factor, part.motion}, [&](const CouplingRow<G>& e) {
    return e.drive == part.drive && e.role == Role::Constraint;
  });
  return "";
}

/// Of augmented ones the rows are closed whatever the weights are.
template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism&, const PenaltyDerivative& part) {
  if (model_.penalty.form != ConstraintForm::Penalty) return "expected constraints by penalties";
  compliance_.setZero(model_.constraints());
  for (const auto& c : model_.couplings) {
    for (int i = 0; i < c.constraints && !c.continued; ++i) {
      const bool length = is_length(c.rows[static_cast<size_t>(i)].row);
      const double weight = model_.penalty.weight[c.first_constraint + i];
      compliance_[c.first_constraint + i] =
          (length ? part.displacement : part.rotation) / (weight * weight);
    }
  }
  return "";
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism&, const StepDerivative& part) {
  step_ += part.relative;
  add_rows({nullptr, nullptr, 0, {}, 0, {}, part.relative},
           [](const CouplingRow<G>& e) { return e.drive >= 0 && e.role == Role::Constraint; });
  return "";
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism& mechanism, const LoadDerivative& part) {
  if (part.load < 0 || part.load >= static_cast<int>(model_.loads.size()))
    return expected("load", part.load);
  const Load<G>& load = model_.loads[part.load];
  add_nodes_of(mechanism.loads[part.load].port.body);
  LoadChange change{&load, part.factor, part.scale, load,
                    !part.force.isZero(0) || !part.moment.isZero(0)};
  const SE3::Tangent wrench = (SE3::Tangent() << part.force, part.moment).finished();
  const SE3 frame = mechanism.frame(mechanism.loads[part.load].port);
  change.components.wrench = load.follower
                                 ? model_.space.reduce_local(wrench, model_.space.alignment(frame))
                                 : model_.space.reduce_wrench(part.force, part.moment);
  loads_.push_back(std::move(change));
  return "";
}

template <FrameGroup G>
std::string ParameterResidual<G>::add_part(const Mechanism&, const NearbyMechanisms& part) {
  if (parameter_.parts.size() > 1) return "expected nearby mechanisms alone";
  nearby_ = std::make_unique<NearbyModels<G>>(part, model_);
  add_nodes(0, model_.nodes());
  return "";
}

/// Loads are quadratic in their wrench at most (LineLoad), so that half the difference to either
/// side is the derivative; those of nodes are linear.
template <FrameGroup G>
void ParameterResidual<G>::add_load(const LoadChange& l, const typename G::Tangent& wrench,
                                    const typename G::Tangent& change, const State<G>& s,
                                    Eigen::VectorXd& r_p) const {
  ForceScale unused;
  Load<G>& load = l.components;
  const typename G::Tangent of_components = load.wrench;
  if (load.spread) {
    turned_.setZero(r_p.size());
    load.wrench = wrench - change;
    Equations<G>::add_load(model_, load, 1, s, turned_, unused);
    r_p -= 0.5 * turned_;
    turned_.setZero();
    load.wrench = wrench + change;
    Equations<G>::add_load(model_, load, 1, s, turned_, unused);
    r_p += 0.5 * turned_;
  } else {
    load.wrench = change;
    Equations<G>::add_load(model_, load, 1, s, r_p, unused);
  }
  load.wrench = of_components;
}

template <FrameGroup G>
void ParameterResidual<G>::add(const State<G>& s, const Eigen::VectorXd& previous,
                               const LoadLevel& level, Eigen::VectorXd& r_p,
                               Eigen::VectorXd& phi_p) const {
  if (nearby_) return nearby_->add(s, previous, level, r_p, phi_p);
  const typename Model<G>::Vector gravity = level.factor * model_.gravity_at(level.t);
  ForceScale unused;
  for (size_t b = 0; b < bodies_.size(); ++b) {
    if (!bodies_[b]) continue;
    BodyState<G> state = model_.body_state(s, static_cast<int>(b));
    state.work = work_[b].get();
    double* out = r_p.data() + dim * model_.first_node(static_cast<int>(b));
    bodies_[b]->add_internal(state, out, unused);
    bodies_[b]->add_inertia(state, gravity, out, unused);
    for (const Load<G>& load : model_.loads)
      if (load.spread && load.port.body == static_cast<int>(b))
        bodies_[b]->add_spread_derivative(
            state, {load_value(load.scale, level) * load.wrench, load.follower}, out);
  }
  for (const LoadChange& l : loads_) {
    const double scale = load_value(l.load->scale, level);
    typename G::Tangent change =
        (l.factor * scale + level.factor * value(l.scale, level.t)) * l.load->wrench;
    if (l.of_components) change += scale * l.components.wrench;
    add_load(l, scale * l.load->wrench, change, s, r_p);
  }
  for (const RowDerivative& row : rows_)
    if (row.equation->role != Role::Constraint) add_force(row, s, previous, level, r_p);
  add_target(level.t, 0, phi_p);
  if (compliance_.size() > 0) phi_p += compliance_.cwiseProduct(s.lambda);
}

template <FrameGroup G>
void ParameterResidual<G>::add_target(double t, int order, Eigen::VectorXd& phi_p) const {
  for (const RowDerivative& row : rows_) {
    if (row.equation->role != Role::Constraint) continue;
    phi_p[row.coupling->first_constraint + row.row] -=
        (row.target - order * row.stretched) * derivative(row.equation->target, t, order) +
        value(row.motion, t, order);
  }
}

template <FrameGroup G>
double ParameterResidual<G>::force_derivative(const CouplingRow<G>& row, double q, double rate,
                                              const LoadLevel& level) const {
  double sum = 0;
  for (const auto& part : parameter_.parts)
    if (const auto* by = std::get_if<ForceDerivative>(&part); by && by->force == row.force)
      sum += by_law(*by, row.law, q, rate, level);
  return sum;
}

template <FrameGroup G>
void ParameterResidual<G>::add_force(const RowDerivative& row, const State<G>& s,
                                     const Eigen::VectorXd& previous, const LoadLevel& level,
                                     Eigen::VectorXd& r_p) const {
  using Tangent = typename G::Tangent;
  const Coupling<G>& c = *row.coupling;
  const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
  typename Row<G>::Gradient g;
  row.equation->row.gradient(motion, g);
  const Tangent B_a = c.a.J.transpose() * g.template head<dim>(),
                B_b = c.b.J.transpose() * g.template tail<dim>();
  double rate = 0;
  if (c.a.body >= 0) rate += B_a.dot(s.v.template segment<dim>(dim * c.a.node));
  if (c.b.body >= 0) rate += B_b.dot(s.v.template segment<dim>(dim * c.b.node));
  const double q = row.equation->row.value(motion, previous[c.first_row + row.row]);
  const double f = by_law(row.law, row.equation->law, q, rate, level);
  if (c.a.body >= 0) r_p.template segment<dim>(dim * c.a.node) += f * B_a;
  if (c.b.body >= 0) r_p.template segment<dim>(dim * c.b.node) += f * B_b;
}

template class ParameterResidual<SE2>;
template class ParameterResidual<SE3>;

}  // namespace liesl
