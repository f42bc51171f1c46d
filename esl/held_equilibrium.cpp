#include "esl/held_equilibrium.hpp"

#include "mbs/bodies/segment_law.hpp"
#include "mbs/system/retract.hpp"

namespace liesl {
namespace {

constexpr int kMaxNewton = 40;
constexpr double kRoundOff =
    1e-9;  // of the part's length: a correction that Newton's method ends with

template <FrameGroup G>
double length_of(const Body<G>& body) {
  double length = 0;
  for (int k = 0; k + 1 < body.nodes(); ++k)
    length += (body.reference[k + 1].x - body.reference[k].x).norm();
  return length;
}

/// Adds d(R_k^T F_k)/dq of the forces F_k = R_k f_k on positions, whose axes R_k turn with the
/// chain: of a load in these axes, which keeps its f, the tangent of the body has left it out. By
/// central differences of `turn_axes`; what axes turn beyond the next node but one, carried along
/// in space, is left to the iteration.
template <FrameGroup G>
void add_turn_of_axes(const Body<G>& body, const Eigen::VectorXd& f, const State<G>& at,
                      const MovedNodes& nodes, BodyMatrix<G::dim>& A) {
  constexpr double kStep = 1e-6;  // of the part's length, rad: errors of 1e-10
  const double length = length_of(body);
  const int reach = A.U2.empty() ? 1 : 2;
  State<G> moved = at;
  Eigen::VectorXd dq = Eigen::VectorXd::Zero(body.size());
  for (int c = nodes.positions.empty() ? body.size() : G::dim; c < body.size(); ++c) {
    const int j = c / G::dim;
    const double h = c % G::dim < G::space_dim ? kStep * length : kStep;
    for (const double step : {h, -h}) {
      dq[c] = step;
      retract(at, dq, NodeUpdate::Screw, nodes, moved);
      body.turn_axes(moved.H.data());
      for (const int k : nodes.positions)
        if (std::abs(k - j) <= reach)
          block_of<G::dim>(A, k, j).col(c % G::dim).template head<G::space_dim>() +=
              moved.H[k].R.transpose() * (at.H[k].R * f.segment<G::space_dim>(G::dim * k)) /
              (2 * step);
    }
    dq[c] = 0;
  }
}

/// Moves the points of a chain by increments dq, each segment by its stretch and its turn: straight
/// ways of points would stretch what turns far, and Newton's method would go astray.
template <FrameGroup G>
void lay_chain(const Body<G>& chain, const State<G>& from, const Eigen::VectorXd& dq,
               State<G>& to) {
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  const auto moved = [&](int k) -> Vector {
    return from.H[k].R * dq.segment<G::space_dim>(G::dim * k);
  };
  for (int e = 0; e + 1 < chain.nodes(); ++e) {
    const Vector d = from.H[e + 1].x - from.H[e].x, change = moved(e + 1) - moved(e);
    const double l = d.norm(), stretch = d.dot(change) / l;
    const Vector turn = (change - stretch / l * d) / l;
    const double angle = turn.norm();
    to.H[e + 1].x = to.H[e].x + (l + stretch) * (std::cos(angle) / l * d +
                                                 (angle > 0 ? std::sin(angle) / angle : 1) * turn);
  }
}

/// g_int(H) = f with H_0 held, from the shape `at`, by Newton's method with extrapolated stress.
template <FrameGroup G>
bool solve_nonlinear(const Body<G>& beam, const Eigen::VectorXd& f, State<G>& at) {
  using Tangent = typename G::Tangent;
  std::vector<int> frames, positions;  // the first node is held
  for (int k = 1; k < beam.nodes(); ++k)
    (beam.kind(k) == NodeKind::Position ? positions : frames).push_back(k);
  const MovedNodes nodes{frames, positions, {}};
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(beam.size());
  BodyState<G> s{at.H.data(), rest.data(), rest.data()};
  typename Body<G>::Stresses stress(beam.stresses(), Tangent::Zero());
  beam.extrapolate_stress(s, rest.data(), stress.data());
  BodyMatrix<G::dim> A(beam.nodes());
  A.set_form(beam.stiffness());
  BlockTridiagonalLU<G::dim> lu;
  double best = std::numeric_limits<double>::infinity(), moved = best;
  const double length = length_of(beam);
  State<G> from = at;
  for (int i = 0; i < kMaxNewton; ++i) {
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
    add_turn_of_axes(beam, f, at, nodes, A);
    hold_first_node(A);
    if (!lu.factor(A)) return false;
    lu.solve(r.data());
    moved = r.norm();
    const Eigen::VectorXd delta = -r;
    beam.extrapolate_stress(s, delta.data(), stress.data());
    from.H = at.H;
    retract(from, delta, NodeUpdate::Screw, nodes, at);
    if (!positions.empty()) lay_chain(beam, from, delta, at);
    beam.turn_axes(at.H.data());
    beam.settle_spin(at.H.data());
  }
  return false;
}

}  // namespace

template <FrameGroup G>
bool held_equilibrium(const Body<G>& beam, const Eigen::VectorXd& f, State<G>& at) {
  constexpr double kLeastStep = 1. / 64;  // of the load
  at.H.assign(beam.reference.begin(), beam.reference.end());
  for (double reached = 0, step = 1; reached < 1;) {
    State<G> next = at;
    const double share = std::min(reached + step, 1.);
    if (solve_nonlinear<G>(beam, share * f, next)) {
      at = std::move(next);
      reached = share;
      step *= 2;
    } else if ((step /= 2) < kLeastStep) {
      return false;
    }
  }
  return true;
}

template bool held_equilibrium(const Body<SE2>&, const Eigen::VectorXd&, State<SE2>&);
template bool held_equilibrium(const Body<SE3>&, const Eigen::VectorXd&, State<SE3>&);

}  // namespace liesl
