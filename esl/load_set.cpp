#include "esl/load_set.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "esl/corotational.hpp"
#include "mbs/system/retract.hpp"

namespace liesl {
namespace {

constexpr int kMaxNewton = 40;
constexpr double kRoundOff =
    1e-9;  // of the part's length: a correction that Newton's method ends with

/// Makes node 0 fixed: its rows and columns become those of the identity.
template <int N>
void hold_first_node(BlockTridiagonal<N>& A) {
  A.D[0].setIdentity();
  if (A.blocks() > 1) {
    A.U[0].setZero();
    A.L[0].setZero();
  }
  if (!A.U2.empty()) {
    A.U2[0].setZero();
    A.L2[0].setZero();
  }
}

template <FrameGroup G>
typename Body<G>::Strains strains(const Body<G>& body, const G* H) {
  typename Body<G>::Strains eps(G::dim, body.elements());
  BodyState<G> s;
  s.H = H;
  for (int e = 0; e < body.elements(); ++e) eps.col(e) = body.strain(s, e);
  return eps;
}

template <FrameGroup G>
double length_of(const Body<G>& body) {
  double length = 0;
  for (int k = 0; k + 1 < body.nodes(); ++k)
    length += (body.reference[k + 1].x - body.reference[k].x).norm();
  return length;
}

/// Loads of a body at H, that of its last node in the axes that `settle_spin` gives it: those of a
/// chain in space spin freely, and the static problem knows nothing of the spin of the motion.
template <FrameGroup G>
Eigen::VectorXd settled_loads(const Body<G>& body, const G* H, Eigen::VectorXd f) {
  Frames<G> settled(H, H + body.nodes());
  body.settle_spin(settled.data());
  G turn = settled.back().inverse() * H[body.nodes() - 1];
  turn.x.setZero();
  f.tail<G::dim>() = (turn.inverse().Ad().transpose() * f.tail<G::dim>()).eval();
  return f;
}

/// g_int(H) = f with H_0 = reference, by Newton's method with extrapolated stress.
template <FrameGroup G>
bool solve_nonlinear(const Body<G>& beam, const Eigen::VectorXd& f, State<G>& at) {
  using Tangent = typename G::Tangent;
  at.H.assign(beam.reference.begin(), beam.reference.end());
  std::vector<int> frames, positions;  // the first node is held
  for (int k = 1; k < beam.nodes(); ++k)
    (beam.kind(k) == NodeKind::Position ? positions : frames).push_back(k);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(beam.size());
  typename Body<G>::Stresses stress(beam.stresses(), Tangent::Zero());
  BodyMatrix<G::dim> A(beam.nodes());
  A.set_form(beam.stiffness());
  BlockTridiagonalLU<G::dim> lu;
  double best = std::numeric_limits<double>::infinity(), moved = best;
  const double length = length_of(beam);
  for (int i = 0; i < kMaxNewton; ++i) {
    BodyState<G> s{at.H.data(), rest.data(), rest.data()};
    s.stress = stress.front().data();
    Eigen::VectorXd r = -f;
    ForceScale scale;
    beam.add_internal(s, r.data(), scale);
    r.head<G::dim>().setZero();
    const double size = r.norm();
    if (!std::isfinite(size)) return false;
    if (size == 0 || (size >= best && moved <= kRoundOff * length))
      return true;  // no better is possible
    best = std::min(best, size);
    beam.exact_tangent(s, Body<G>::Vector::Zero(), {}, stress.data(), A);
    hold_first_node(A);
    if (!lu.factor(A)) return false;
    lu.solve(r.data());
    moved = r.norm();
    const Eigen::VectorXd delta = -r;
    beam.extrapolate_stress(s, delta.data(), stress.data());
    retract(at, delta, NodeUpdate::Screw, {frames, positions, {}}, at);
    beam.turn_axes(at.H.data());
    beam.settle_spin(at.H.data());
  }
  return false;
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
    const Eigen::VectorXd f = settled_loads(body, H, loads.f.col(n));
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
    const bool solved = linear || solve_nonlinear<G>(body, f, at);
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
