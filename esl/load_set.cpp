#include "esl/load_set.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>

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
}

template <FrameGroup G>
using Strains = Eigen::Matrix<double, G::dim, Eigen::Dynamic>;

template <FrameGroup G>
Strains<G> strains(const Body<G>& body, const G* H) {
  Strains<G> eps(G::dim, body.elements());
  BodyState<G> s;
  s.H = H;
  for (int e = 0; e < body.elements(); ++e) eps.col(e) = body.strain(s, e);
  return eps;
}

/// g_int(H) = f with H_0 = reference, by Newton's method with extrapolated stress.
template <FrameGroup G>
bool solve_nonlinear(const Beam<G>& beam, const Eigen::VectorXd& f, Frames<G>& H) {
  using Tangent = typename G::Tangent;
  H.assign(beam.reference.begin(), beam.reference.end());
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(beam.size());
  std::vector<Tangent, Eigen::aligned_allocator<Tangent>> stress(beam.elements(), Tangent::Zero());
  BlockTridiagonal<G::dim> A(beam.nodes());
  BlockTridiagonalLU<G::dim> lu;
  double best = std::numeric_limits<double>::infinity(), moved = best, length = 0;
  for (int e = 0; e < beam.elements(); ++e) length += beam.element(e).length();
  for (int i = 0; i < kMaxNewton; ++i) {
    const BodyState<G> s{H.data(), rest.data(), rest.data()};
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
    for (int e = 0; e < beam.elements(); ++e) {
      const auto& element = beam.element(e);
      const Tangent d = G::log(H[e].inverse() * H[e + 1]);
      const Eigen::Matrix<double, 2 * G::dim, 1> pair = -r.segment<2 * G::dim>(G::dim * e);
      stress[e] = element.section_stiffness() * ((d - element.d0()) + BeamElement<G>::P(d) * pair) /
                  element.length();
    }
    for (int k = 1; k < beam.nodes(); ++k)
      H[k] = H[k] * G::exp(Tangent(-r.segment<G::dim>(G::dim * k)));
  }
  return false;
}

/// Up to `count` load cases spread over time, and the one with the largest load.
std::set<int> chosen_cases(const LoadSet& loads, int count) {
  const int n = static_cast<int>(loads.t.size());
  std::set<int> cases;
  if (n == 0) return cases;
  int largest = 0;
  loads.f.colwise().squaredNorm().maxCoeff(&largest);
  cases.insert(largest);
  for (int i = 1; i < count; ++i)
    cases.insert(static_cast<int>(static_cast<long>(n - 1) * i / count));
  return cases;
}

}  // namespace

template <FrameGroup G>
LoadSet extract_loads(const Model<G>& model, const Trajectory<G>& trajectory, int body) {
  const auto* beam = dynamic_cast<const Beam<G>*>(model.bodies[body].get());
  if (!beam)
    throw std::invalid_argument(
        fmt::format("'{}' is rigid: only a beam has internal forces", model.bodies[body]->name));
  LoadSet set;
  set.body = body;
  set.f.setZero(beam->size(), trajectory.size());
  typename Beam<G>::Pair g;
  for (int n = 0; n < trajectory.size(); ++n) {
    set.t.push_back(trajectory.time(n));
    const G* H = trajectory.frames(n) + model.first_node(body);
    for (int e = 0; e < beam->elements(); ++e) {
      beam->element(e).internal_force(H[e], H[e + 1], nullptr, 0, g);
      set.f.col(n).template segment<2 * G::dim>(G::dim * e) += g;
    }
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
  const auto& beam = dynamic_cast<const Beam<G>&>(*model.bodies[loads.body]);
  BlockTridiagonal<G::dim> K = beam.stiffness();
  hold_first_node(K);
  BlockTridiagonalLU<G::dim> lu;
  lu.factor(K);
  Identity identity;
  double largest = 0;
  for (const int n : chosen_cases(loads, cases)) {
    const Strains<G> dynamic =
        strains<G>(beam, trajectory.frames(n) + model.first_node(loads.body));
    const double size = dynamic.cwiseAbs().maxCoeff();
    if (size == 0) continue;
    largest = std::max(largest, size);
    ++identity.cases;
    Frames<G> H;
    const bool solved = solve_nonlinear<G>(beam, loads.f.col(n), H);
    const double off = solved ? (strains<G>(beam, H.data()) - dynamic).cwiseAbs().maxCoeff()
                              : std::numeric_limits<double>::infinity();
    identity.nonlinear = std::max(identity.nonlinear, off);
    Eigen::VectorXd u = loads.f.col(n);
    u.head<G::dim>().setZero();
    lu.solve(u.data());
    for (int e = 0; e < beam.elements(); ++e) {
      const auto& element = beam.element(e);
      const typename G::Tangent eps =
          BeamElement<G>::P(element.d0()) * u.segment<2 * G::dim>(G::dim * e) / element.length();
      identity.linear = std::max(identity.linear, (eps - dynamic.col(e)).cwiseAbs().maxCoeff());
    }
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
