#include "esl/load_set.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "esl/corotational.hpp"
#include "esl/held_equilibrium.hpp"

namespace liesl {
namespace {

template <FrameGroup G>
typename Body<G>::Strains strains(const Body<G>& body, const G* H) {
  typename Body<G>::Strains eps(G::dim, body.elements());
  BodyState<G> s;
  s.H = H;
  for (int e = 0; e < body.elements(); ++e) eps.col(e) = body.strain(s, e);
  return eps;
}

/// Turns the load of the last node into the axes that `settle_spin` gives it: those of a chain in
/// space spin freely, and the static problem knows nothing of the spin of the motion.
template <FrameGroup G>
void settle_loads(const Body<G>& body, const G* H, Eigen::Ref<Eigen::VectorXd> f) {
  Frames<G> settled(H, H + body.nodes());
  body.settle_spin(settled.data());
  const G& last = H[body.nodes() - 1];
  if (settled.back().R == last.R) return;
  G turn = settled.back().inverse() * last;
  turn.x.setZero();
  f.tail<G::dim>() = (turn.inverse().Ad().transpose() * f.tail<G::dim>()).eval();
}

}  // namespace

std::set<int> spread_cases(const Eigen::MatrixXd& loads, int count) {
  const auto n = loads.cols();
  std::set<int> cases;
  if (n == 0) return cases;
  int largest = 0;
  loads.colwise().squaredNorm().maxCoeff(&largest);
  cases.insert(largest);
  for (int i = 1; i < count; ++i) cases.insert(static_cast<int>((n - 1) * i / count));
  return cases;
}

template <FrameGroup G>
LoadSet extract_loads(const Model<G>& model, const Trajectory<G>& trajectory, int index) {
  const Body<G>& body = *model.bodies[index];
  const BeamChain<G>* classical =
      model.formalism == Formalism::Classical ? BeamChain<G>::of(body) : nullptr;
  if (body.elements() == 0)
    throw std::invalid_argument(
        fmt::format("'{}' is rigid: only a beam has internal forces", body.name));
  LoadSet set;
  set.body = index;
  set.f.setZero(body.size(), trajectory.size());
  for (int n = 0; n < trajectory.size(); ++n) {
    set.t.push_back(trajectory.time(n));
    const G* H = trajectory.frames(n) + model.first_node(index);
    double* f = set.f.col(n).data();
    if (classical)
      add_corotational_force(*classical, H, f);
    else
      body.add_elastic_force(H, f);
    settle_loads<G>(body, H, set.f.col(n));
  }
  return set;
}

double load_change(const std::vector<LoadSet>& f, const std::vector<LoadSet>& before, int dim,
                   int space_dim, double length) {
  double change = 0, total = 0;
  if (f.size() != before.size()) throw std::invalid_argument("load sets of different parts");
  for (size_t i = 0; i < f.size(); ++i) {
    if (f[i].f.rows() != before[i].f.rows() || f[i].f.cols() != before[i].f.cols())
      throw std::invalid_argument("load sets of different size");
    Eigen::VectorXd weight(f[i].f.rows());
    for (int k = 0; k < weight.size(); ++k) weight[k] = k % dim < space_dim ? 1 : 1 / length;
    for (int n = 0; n < f[i].f.cols(); ++n) {
      change += weight.cwiseProduct(f[i].f.col(n) - before[i].f.col(n)).norm();
      total += weight.cwiseProduct(before[i].f.col(n)).norm();
    }
  }
  return total > 0 ? change / total : 0;
}

template <FrameGroup G>
Identity check_identity(const Model<G>& model, const Trajectory<G>& trajectory,
                        const LoadSet& loads, int cases) {
  const Body<G>& body = *model.bodies[loads.body];
  const bool linear = body.mass().is_dense();  // a modal body is linear: no second problem
  BlockTridiagonal<G::dim> K = body.free_stiffness();
  hold_first_node(K);
  BlockTridiagonalLU<G::dim> lu;
  lu.factor(K);
  Identity identity;
  double largest = 0;
  for (const int n : spread_cases(loads.f, cases)) {
    const G* H = trajectory.frames(n) + model.first_node(loads.body);
    const typename Body<G>::Strains dynamic = strains<G>(body, H);
    const Eigen::VectorXd f = loads.f.col(n);
    const double size = dynamic.cwiseAbs().maxCoeff();
    if (size == 0) continue;
    largest = std::max(largest, size);
    ++identity.cases;
    Eigen::VectorXd u = f;
    u.head<G::dim>().setZero();
    lu.solve(u.data());
    const double off = (body.strains_at_rest(u) - dynamic).cwiseAbs().maxCoeff();
    identity.linear = std::max(identity.linear, off);
    State<G> at;
    const bool solved = linear || held_equilibrium<G>(body, f, at);
    identity.nonlinear =
        std::max(identity.nonlinear,
                 linear   ? off
                 : solved ? (strains<G>(body, at.H.data()) - dynamic).cwiseAbs().maxCoeff()
                          : std::numeric_limits<double>::infinity());
  }
  if (largest > 0) {
    identity.nonlinear /= largest;
    identity.linear /= largest;
  }
  return identity;
}

template LoadSet extract_loads(const Model<SE2>&, const Trajectory<SE2>&, int);
template LoadSet extract_loads(const Model<SE3>&, const Trajectory<SE3>&, int);
template Identity check_identity(const Model<SE2>&, const Trajectory<SE2>&, const LoadSet&, int);
template Identity check_identity(const Model<SE3>&, const Trajectory<SE3>&, const LoadSet&, int);

}  // namespace liesl
