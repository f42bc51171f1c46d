#include "optim/problems/mechanism_statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/solvers/free_motion.hpp"

namespace liesl {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// @param motions of `free_motions` at the state s
template <FrameGroup G>
MechanismMoves moves(const Model<G>& model, const State<G>& s, const Eigen::MatrixXd& motions) {
  return MechanismMoves(fmt::format(
      "the mechanism can move at t = {:.6g} s with its drives held, and has no static problem{}; "
      "expected drives or springs on all that moves, or limits with surrogate = \"auto\"",
      s.t, motions.cols() > 0 ? ": " + describe_free_motion(model, s, motions) : ""));
}

}  // namespace

template <FrameGroup G>
MechanismStatics<G>::MechanismStatics(const DesignSimulator<G>& simulator, const DesignRun<G>& run,
                                      const std::vector<int>& records)
    : simulator_(simulator), run_(run) {
  for (const int n : records) {
    if (records_.contains(n)) continue;
    Record record = loaded(n);
    const Solved now = solved(*run.model, record);
    // What is free is so at every instant but dead points, which `solved` refuses.
    if (records_.empty())
      if (const MatrixXd motions = free_motions(*run.model, now.S->matrix()); motions.cols() > 0)
        throw moves(*run.model, record.state, motions);
    record.u_k = now.u;
    records_.emplace(n, std::move(record));
  }
}

template <FrameGroup G>
double MechanismStatics<G>::value(const ResponseSpec& response, int record, const VectorXd& x,
                                  VectorXd* slope) {
  const Record& n = records_.at(record);
  const Solved& now = solution(record, x);
  const ResponseValues<G> values(run_.mechanism, *run_.model);
  const MatrixXd C = by_increments(values, response, n.state);
  const VectorXd y = values(response, n.state) + C.transpose() * (now.u - n.u_k);
  const double v = y.norm();
  if (slope && v == 0) slope->setZero(x.size());
  if (slope && v > 0) {
    VectorXd mu = C * y / v;
    now.S->lu().solve_transposed(mu);
    *slope = slopes(n, now.u, mu);
  }
  return v;
}

template <FrameGroup G>
auto MechanismStatics<G>::loaded(int record) const -> Record {
  const Model<G>& model = *run_.model;
  Record out{model.initial_state(), VectorXd::Zero(model.size() + model.constraints()), {}};
  run_.simulation.trajectory.read(record, out.state);
  out.state.v.setZero();
  out.state.vdot.setZero();
  out.state.lambda.setZero();
  ForceScale scale;
  for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b)
    model.bodies[b]->add_internal(model.body_state(out.state, b),
                                  out.f.data() + G::dim * model.first_node(b), scale);
  return out;
}

template <FrameGroup G>
auto MechanismStatics<G>::designed(const VectorXd& x) const -> Designed {
  Designed d;
  d.mechanism = simulator_.design().apply(simulator_.mechanism(), x);
  d.model = std::make_shared<Model<G>>(Model<G>::build(d.mechanism, run_.model->space));
  for (const Parameter& p : simulator_.design().parameters(d.mechanism, x))
    d.by.push_back(std::make_unique<ParameterResidual<G>>(d.mechanism, *d.model, p));
  return d;
}

template <FrameGroup G>
auto MechanismStatics<G>::assembled(const Model<G>& model, const Record& n)
    -> std::unique_ptr<IterationMatrix<G>> {
  State<G> s = n.state;
  const LoadLevel unloaded{s.t, 0};
  Equations<G> equations(model);
  equations.evaluate(s, s.rows, unloaded);
  auto S = std::make_unique<IterationMatrix<G>>(model);
  S->assemble(equations, s, unloaded);
  return S;
}

template <FrameGroup G>
auto MechanismStatics<G>::solved(const Model<G>& model, const Record& n) -> Solved {
  constexpr double kSingular = 1e-14;  // reciprocal condition: round-off
  const State<G>& s = n.state;
  Solved out{assembled(model, n), n.f};
  if (!out.S->factor() || out.S->lu().reciprocal_condition() < kSingular)
    throw moves(model, s, free_motions(model, out.S->matrix()));
  out.S->lu().solve(out.u);
  return out;
}

template <FrameGroup G>
auto MechanismStatics<G>::solution(int record, const VectorXd& x) -> const Solved& {
  if (x_.size() != x.size() || x_ != x) {
    solved_.clear();
    at_ = designed(x);
    x_ = x;
  }
  const auto found = solved_.find(record);
  if (found != solved_.end()) return found->second;
  return solved_.emplace(record, solved(*at_.model, records_.at(record))).first->second;
}

template <FrameGroup G>
MatrixXd MechanismStatics<G>::by_increments(const ResponseValues<G>& values,
                                            const ResponseSpec& response, const State<G>& s) const {
  const auto gradients = values.gradient(response, s);
  const Model<G>& model = *run_.model;
  MatrixXd C = MatrixXd::Zero(model.size() + model.constraints(),
                              static_cast<Eigen::Index>(gradients.size()));
  for (std::size_t i = 0; i < gradients.size(); ++i)
    for (const auto& node : gradients[i].nodes)
      C.col(static_cast<Eigen::Index>(i)).template segment<G::dim>(G::dim * node.node) += node.h;
  return C;
}

template <FrameGroup G>
bool MechanismStatics<G>::has_fourth_order() const {
  const auto& bodies = at_.mechanism.bodies;
  return std::any_of(bodies.begin(), bodies.end(), [](const BodySpec& body) {
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    return beam && beam->order == 4;
  });
}

template <FrameGroup G>
double MechanismStatics<G>::difference(Eigen::Index i, const Record& n, const VectorXd& u,
                                       const VectorXd& mu) const {
  constexpr double kStep = 1e-4;  // of the variable: the error is of its square
  const double h = kStep * x_[i];
  double sum = 0;
  for (const double side : {1.0, -1.0}) {
    const Designed moved = designed(x_ + side * h * VectorXd::Unit(x_.size(), i));
    sum += side * mu.dot(assembled(*moved.model, n)->matrix() * u);
  }
  return -sum / (2 * h);
}

template <FrameGroup G>
VectorXd MechanismStatics<G>::slopes(const Record& n, const VectorXd& u, const VectorXd& mu) const {
  VectorXd out = VectorXd::Zero(x_.size());
  if (has_fourth_order()) {
    for (Eigen::Index i = 0; i < x_.size(); ++i) out[i] = difference(i, n, u, mu);
    return out;
  }
  const Model<G>& model = *run_.model;
  const State<G>& s = n.state;
  for (std::size_t i = 0; i < at_.by.size(); ++i)
    for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
      const Body<G>* change = at_.by[i]->body(b);
      if (!change) continue;
      const typename Body<G>::Stresses rest(std::size_t(change->stresses()), G::Tangent::Zero());
      BodyMatrix<G::dim> K(change->nodes());
      K.set_form(change->stiffness());
      change->exact_tangent(model.body_state(s, b), Model<G>::Vector::Zero(), {}, rest.data(), K);
      each_block(K, G::dim * model.first_node(b), [&](int row, int column, const auto& block) {
        out[static_cast<Eigen::Index>(i)] -=
            mu.segment(row, block.rows()).dot(block * u.segment(column, block.cols()));
      });
    }
  return out;
}

template class MechanismStatics<SE2>;
template class MechanismStatics<SE3>;

}  // namespace liesl
