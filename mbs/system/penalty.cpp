#include "mbs/system/penalty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace liesl {
namespace {

constexpr double kStiffer = 1000;    // than the bodies
constexpr double kRounding = 1e-13;  // of the length: openings below are none
constexpr double kLeast = 1e-7;      // m, and of the length: deformations below count as that

/// The largest entries of a body on the diagonal of translations and of rotations.
struct Largest {
  double translation = 0, rotation = 0;

  template <class G>
  void take(const Body<G>& body, double inertia) {
    const auto& K = body.stiffness();
    const auto& M = body.mass();
    const auto at = [&](int i, double k, double m) {
      double& largest = i < G::space_dim ? translation : rotation;
      largest = std::max(largest, k + inertia * m);
    };
    for (int node = 0; node < body.nodes(); ++node)
      for (int i = 0; i < G::dim && body.kind(node) == NodeKind::Frame; ++i)
        at(i, K.diagonal(node, i), M.diagonal(node, i));
  }
};

template <class G>
bool deforms(const Body<G>& body) {
  const auto& K = body.stiffness();
  return K.is_dense() ? !K.dense.isZero(0) : K.is_sparse() || body.elements() > 0;
}

double rounded_up(double weight) {
  return weight > 0 ? std::pow(10, std::ceil(std::log10(weight) - 1e-9)) : 1;
}

void require_not_negative(const char* what, double value) {
  if (!(value >= 0) || !std::isfinite(value))
    throw std::invalid_argument(
        fmt::format("penalty: expected {} of at least 0, got {:g}", what, value));
}

template <FrameGroup G, class At>
void for_each_constraint(const Model<G>& model, const At& at) {
  for (const Coupling<G>& c : model.couplings)
    for (int i = 0; i < c.constraints; ++i) at(c, c.rows[static_cast<size_t>(i)], i);
}

/// Of joints that hold on to something: springs and bushings join no bodies, and gears have the
/// bodies of their joints.
template <FrameGroup G>
JointGraph graph_of_joints(const Model<G>& model) {
  std::vector<JointGraph::Ends> joints;
  for (const Coupling<G>& c : model.couplings)
    if (c.is_joint && c.constraints > 0) joints.push_back({c.a.body, c.b.body});
  return {static_cast<int>(model.bodies.size()), joints};
}

}  // namespace

template <FrameGroup G>
Penalty build_penalty(const PenaltySpec& spec, const Model<G>& model) {
  Penalty penalty{spec.form, {}, spec.damping, spec.displacement, spec.rotation};
  if (spec.form == ConstraintForm::Multipliers) return penalty;
  require_not_negative("a weight of displacements", spec.displacement);
  require_not_negative("a weight of rotations", spec.rotation);
  require_not_negative("a damping", spec.damping);
  if (!(spec.step > 0)) throw std::invalid_argument("penalty: expected a step above 0 s");
  Largest largest;
  for (const auto& body : model.bodies) largest.take(*body, 1 / (spec.step * spec.step));
  if (penalty.displacement == 0) penalty.displacement = rounded_up(kStiffer * largest.translation);
  if (penalty.rotation == 0) penalty.rotation = rounded_up(kStiffer * largest.rotation);
  penalty.weight.setZero(model.constraints());
  for_each_constraint(model, [&](const Coupling<G>& c, const CouplingRow<G>& row, int i) {
    if (!c.continued)
      penalty.weight[c.first_constraint + i] =
          is_length(row.row) ? penalty.displacement : penalty.rotation;
  });
  return penalty;
}

template <FrameGroup G>
Eigen::VectorXd openings(const Model<G>& model, const State<G>& s) {
  Eigen::VectorXd phi = Eigen::VectorXd::Zero(model.constraints());
  for_each_constraint(model, [&](const Coupling<G>& c, const CouplingRow<G>& row, int i) {
    phi[c.first_constraint + i] += s.rows[c.first_row + i] - row.target(s.t);
  });
  return phi;
}

template <FrameGroup G>
double penalty_energy(const Model<G>& model, const State<G>& s) {
  if (model.penalty.form == ConstraintForm::Multipliers) return 0;
  return 0.5 * model.penalty.weight.dot(openings(model, s).cwiseAbs2());
}

template <FrameGroup G>
double PenaltyWork<G>::step(const State<G>& s) {
  if (model_.penalty.form == ConstraintForm::Multipliers) return 0;
  const Eigen::VectorXd opening = openings(model_, s);
  double work = 0;
  if (!first_)
    work = -0.5 * (lambda_ + s.lambda).dot(opening - opening_) +
           0.5 * model_.penalty.weight.dot(opening.cwiseAbs2() - opening_.cwiseAbs2());
  first_ = false;
  lambda_ = s.lambda;
  opening_ = opening;
  return work;
}

template <FrameGroup G>
double penalty_energy_derivative(const PenaltyDerivative& by, const Model<G>& model,
                                 const State<G>& s) {
  const Eigen::VectorXd phi = openings(model, s);
  double sum = 0;
  for_each_constraint(model, [&](const Coupling<G>& c, const CouplingRow<G>& row, int i) {
    if (c.continued) return;
    const double opening = phi[c.first_constraint + i];
    sum += 0.5 * (is_length(row.row) ? by.displacement : by.rotation) * opening * opening;
  });
  return sum;
}

template <FrameGroup G>
JointOpening<G>::JointOpening(const Model<G>& model) : model_(model) {
  lever_.setOnes(model.constraints());
  opening_.setZero(model.constraints());
  for_each_constraint(model, [&](const Coupling<G>& c, const CouplingRow<G>& row, int i) {
    if (!c.continued && !is_length(row.row)) lever_[c.first_constraint + i] = model.length;
  });
  for (const auto& body : model.bodies) deforms_.push_back(deforms(*body));
  deformation_.assign(model.bodies.size(), 0);
  rigid_ = std::none_of(deforms_.begin(), deforms_.end(), [](bool is) { return is; });
}

template <FrameGroup G>
void JointOpening<G>::step(const Eigen::VectorXd& gap, const State<G>& s) {
  opening_ = opening_.cwiseMax(gap.cwiseProduct(lever_).cwiseAbs());
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    if (!deforms_[b]) continue;
    const Body<G>& body = *model_.bodies[b];
    const G* H = s.H.data() + model_.first_node(static_cast<int>(b));
    const int middle = body.points() / 2;
    const G moved = H[middle] * body.reference[middle].inverse();
    for (int k = 0; k < body.points(); ++k)
      deformation_[b] = std::max(deformation_[b], (H[k].x - (moved * body.reference[k]).x).norm());
  }
}

/// By how much the bodies deform that stand beside a joint; all where none does. It counts as no
/// less than what joints that are as closed as augmented ones, to 1e-9 m, are a hundredth of: a
/// loop of stiff bodies that carries next to nothing needs no more.
template <FrameGroup G>
double JointOpening<G>::beside(const JointGraph& graph, const Coupling<G>& c) const {
  const std::vector<int> bodies = graph.beside({c.a.body, c.b.body}, deforms_);
  double largest = kLeast * std::min(1., model_.length);
  for (const int b : bodies) largest = std::max(largest, deformation_[static_cast<size_t>(b)]);
  for (const double d : deformation_)
    if (bodies.empty()) largest = std::max(largest, d);
  return largest;
}

template <FrameGroup G>
auto JointOpening<G>::worst() const -> Worst {
  const JointGraph graph = graph_of_joints(model_);
  Worst found;
  if (!rigid_) found.deformation = *std::max_element(deformation_.begin(), deformation_.end());
  for (const Coupling<G>& c : model_.couplings) {
    if (c.constraints == 0) continue;
    Worst one{c.name, opening_.segment(c.first_constraint, c.constraints).maxCoeff()};
    const double against = rigid_ ? model_.length : one.deformation = beside(graph, c);
    if (one.opening > kRounding * model_.length && against > 0) one.share = one.opening / against;
    if (found.joint.empty() || one.share > found.share) found = one;
  }
  return found;
}

template Penalty build_penalty(const PenaltySpec&, const Model<SE2>&);
template Penalty build_penalty(const PenaltySpec&, const Model<SE3>&);
template Eigen::VectorXd openings(const Model<SE2>&, const State<SE2>&);
template Eigen::VectorXd openings(const Model<SE3>&, const State<SE3>&);
template double penalty_energy(const Model<SE2>&, const State<SE2>&);
template double penalty_energy(const Model<SE3>&, const State<SE3>&);
template double penalty_energy_derivative(const PenaltyDerivative&, const Model<SE2>&,
                                          const State<SE2>&);
template double penalty_energy_derivative(const PenaltyDerivative&, const Model<SE3>&,
                                          const State<SE3>&);
template class PenaltyWork<SE2>;
template class PenaltyWork<SE3>;
template class JointOpening<SE2>;
template class JointOpening<SE3>;

}  // namespace liesl
