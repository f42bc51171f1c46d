#include "esl/static_part.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

constexpr int kColumnsATask = 256;  // load cases solved by one task

/// Number of the local direction of "x", ..., "rz"; -1 if there is none.
std::vector<int> directions(const std::string& letters) {
  static const std::string kNames[] = {"x", "y", "z", "rx", "ry", "rz"};
  std::vector<int> out;
  for (size_t i = 0; i < letters.size(); ++i) {
    if (letters[i] == ',') continue;
    const std::string name = letters[i] == 'r' ? letters.substr(i, 2) : letters.substr(i, 1);
    const auto found = std::find(std::begin(kNames), std::end(kNames), name);
    out.push_back(found == std::end(kNames) ? -1 : static_cast<int>(found - std::begin(kNames)));
    if (letters[i] == 'r') ++i;
  }
  return out;
}

/// A rigid motion h of node 0, [size of G] increments: that of node k is Ad(H_k^-1 H_0) h.
template <FrameGroup G>
typename StaticPart<G>::Law rigid_motions(const Body<G>& beam) {
  typename StaticPart<G>::Law motions;
  for (const auto& H : beam.reference) motions.push_back((H.inverse() * beam.reference[0]).Ad());
  return motions;
}

template <FrameGroup G>
typename G::Matrix held_motions(const typename StaticPart<G>::Law& rigid,
                                const std::vector<int>& fixed) {
  typename G::Matrix held;
  for (int i = 0; i < G::dim; ++i) held.row(i) = rigid[fixed[i] / G::dim].row(fixed[i] % G::dim);
  return held;
}

}  // namespace

template <FrameGroup G>
PartSupport read_support(const std::vector<std::string>& support, const Mechanism& mechanism,
                         const Model<G>& model, int body) {
  PartSupport held;
  const std::string& name = mechanism.bodies[body].name;
  std::vector<std::string> places = support.empty() ? std::vector<std::string>{"start"} : support;
  if (places[0] == "inertia_relief") {
    held.inertia_relief = true;
    if (model.bodies[body]->total_mass() <= 0)
      throw std::invalid_argument(
          fmt::format("support of '{}': inertia relief of a part without mass; expected a density, "
                      "or nodes that hold it",
                      name));
    places = {"start"};
  }
  std::set<int> fixed;
  for (const auto& text : places) {
    const size_t colon = text.find(':');
    const auto port = mechanism.port(name + "." + text.substr(0, colon));
    if (!port)
      throw std::invalid_argument(fmt::format(
          "support of '{}': no node '{}'; expected start, end, mid or nodeK", name, text));
    const SE3 align = model.space.alignment(mechanism.frame(*port));
    const auto letters =
        colon == std::string::npos ? std::string("xyzrxryrz") : text.substr(colon + 1);
    for (const int d : directions(letters)) {
      if (d < 0)
        throw std::invalid_argument(fmt::format(
            "support of '{}': '{}'; expected directions among x, y, z, rx, ry, rz", name, text));
      const typename G::Tangent local = model.space.reduce_local(SE3::Tangent::Unit(d), align);
      int index = 0;
      if (local.cwiseAbs().maxCoeff(&index) > 0.5) fixed.insert(G::dim * port->node + index);
    }
  }
  if (static_cast<int>(fixed.size()) != G::dim)
    throw std::invalid_argument(fmt::format(
        "support of '{}' holds {} directions; expected {}, as many as the part has rigid motions",
        name, fixed.size(), G::dim));
  held.fixed.assign(fixed.begin(), fixed.end());
  const typename G::Matrix motions =
      held_motions<G>(rigid_motions(*model.bodies[body]), held.fixed);
  if (linalg::rank(motions, 1e-9) < G::dim)
    throw std::invalid_argument(
        fmt::format("support of '{}' leaves it a rigid motion: '{}'; expected directions that hold "
                    "it, as start",
                    name, fmt::join(places, "', '")));
  return held;
}

template <FrameGroup G>
StaticPart<G>::StaticPart(const BeamChain<G>& beam, PartSupport held, Eigen::MatrixXd outputs)
    : beam_(beam), held_(std::move(held)), C_(std::move(outputs)), rigid_(rigid_motions<G>(beam)) {
  for (int e = 0; e < beam.elements(); ++e) {
    const auto& d = beam.d0(e);
    P0_.push_back(BeamElement<G>::P(d));
    T_.push_back(G::T(d));
    back_.push_back(G::exp(-d).Ad());
    length_.push_back(beam.length(e));
  }
  held_inverse_ = linalg::inverse<G::dim>(held_motions<G>(rigid_, held_.fixed));
}

template <FrameGroup G>
void StaticPart<G>::set_loads(const Eigen::MatrixXd& f) {
  f_ = f;
  if (!held_.inertia_relief || f.cols() == 0) return;
  Eigen::MatrixXd R(beam_.size(), dim), MR = Eigen::MatrixXd::Zero(beam_.size(), dim);
  for (int k = 0; k < beam_.nodes(); ++k) R.middleRows<dim>(dim * k) = beam_.reference[k].AdInv();
  for (int j = 0; j < dim; ++j) beam_.mass().multiply_add(R.col(j).data(), MR.col(j).data());
  f_ -= MR * linalg::solve(R.transpose() * MR, R.transpose() * f);
}

template <FrameGroup G>
void StaticPart<G>::solve_column(double* x, std::vector<Strain>& strain, int column) const {
  using Tangent = typename G::Tangent;
  using Node = Eigen::Map<Tangent>;
  const int n = static_cast<int>(P0_.size());
  Tangent resultant = Tangent::Zero();
  for (const int i : held_.fixed) x[i] = 0;
  for (int k = 0; k <= n; ++k) resultant += rigid_[k].transpose() * Node(x + dim * k);
  const Tangent reaction = -held_inverse_.transpose() * resultant;
  for (int i = 0; i < dim; ++i) x[held_.fixed[i]] = reaction[i];
  for (int e = n - 1; e >= 0; --e) {
    const Tangent carried = Node(x + dim * (e + 1));  // P_B^T n_e, all that acts beyond
    strain[e].col(column) = flexibility_[e] * (T_[e].transpose() * carried);
    Node(x + dim * e) += back_[e].transpose() * carried;
  }
  Node(x).setZero();
  for (int e = 0; e < n; ++e)
    Node(x + dim * (e + 1)) = T_[e] * strain[e].col(column) + back_[e] * Node(x + dim * e);
  Tangent gap;
  for (int i = 0; i < dim; ++i) gap[i] = x[held_.fixed[i]];
  const Tangent motion = held_inverse_ * gap;
  for (int k = 0; k <= n; ++k) Node(x + dim * k) -= rigid_[k] * motion;
  for (const int i : held_.fixed) x[i] = 0;
}

template <FrameGroup G>
void StaticPart<G>::solve_columns(Eigen::MatrixXd& x, std::vector<Strain>& strain) const {
  strain.assign(P0_.size(), Strain(dim, x.cols()));
  tbb::parallel_for(tbb::blocked_range<int>(0, static_cast<int>(x.cols()), kColumnsATask),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int n = range.begin(); n < range.end(); ++n)
                        solve_column(x.col(n).data(), strain, n);
                    });
}

template <FrameGroup G>
bool StaticPart<G>::solve(const Law& K_s) {
  flexibility_.resize(K_s.size());
  for (size_t e = 0; e < K_s.size(); ++e) {
    flexibility_[e] = length_[e] * linalg::inverse<dim>(K_s[e]);
    if (!flexibility_[e].allFinite()) return false;
  }
  u_ = f_;
  solve_columns(u_, strain_u_);
  mu_ = C_;
  solve_columns(mu_, strain_mu_);
  y_ = linalg::transposed_product(C_, u_);
  return u_.allFinite() && mu_.allFinite();
}

template <FrameGroup G>
void StaticPart<G>::add_gradient(int e, const Matrix& dK_s, Eigen::MatrixXd& dy) const {
  const Eigen::MatrixXd n = linalg::product(dK_s / length_[e], strain_u_[e]);
  linalg::subtract_transposed_product(strain_mu_[e], n, dy.topRows(outputs()));
}

template <FrameGroup G>
void StaticPart<G>::add_gradient_direct(const Law& dK, Eigen::MatrixXd& dy) const {
  Eigen::MatrixXd du = multiply(dK, strain_u_);
  std::vector<Strain> unused;
  solve_columns(du, unused);
  linalg::subtract_transposed_product(C_, du, dy.topRows(outputs()));
}

template <FrameGroup G>
Eigen::RowVectorXd StaticPart<G>::compliance_gradient(int e, const Matrix& dK_s) const {
  const Eigen::MatrixXd n = linalg::product(dK_s / length_[e], strain_u_[e]);
  return -strain_u_[e].cwiseProduct(n).colwise().sum();
}

template <FrameGroup G>
Eigen::MatrixXd StaticPart<G>::multiply(const Law& dK, const std::vector<Strain>& strain) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(beam_.size(), strain.front().cols());
  for (size_t e = 0; e < P0_.size(); ++e)
    out.middleRows(dim * static_cast<int>(e), 2 * dim) +=
        linalg::transposed_product(P0_[e] / length_[e], linalg::product(dK[e], strain[e]));
  return out;
}

template <FrameGroup G>
void StaticPart<G>::add_second(const std::vector<Law>& dK, const Second& d2K,
                               const Eigen::MatrixXd& w, Eigen::MatrixXd& h) const {
  // The sum over cases goes into the displacement: ubar_o = sum_n w(o, n) u_n, one an output.
  std::vector<Strain> ubar, unused;
  for (const auto& strain : strain_u_) ubar.push_back(linalg::product(strain, w.transpose()));
  const int n = static_cast<int>(dK.size());
  std::vector<Eigen::MatrixXd> K_mu(n), solved(n);
  for (int i = 0; i < n; ++i) {
    if (dK[i].empty()) continue;
    K_mu[i] = multiply(dK[i], strain_mu_);
    solved[i] = multiply(dK[i], ubar);
    solve_columns(solved[i], unused);
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      if (dK[i].empty() || dK[j].empty()) continue;
      double sum = K_mu[i].cwiseProduct(solved[j]).sum() + K_mu[j].cwiseProduct(solved[i]).sum();
      if (!d2K[i][j].empty()) sum -= mu_.cwiseProduct(multiply(d2K[i][j], ubar)).sum();
      h(i, j) += sum;
    }
}

template <FrameGroup G>
Eigen::MatrixXd StaticPart<G>::strain_output(const BeamChain<G>& beam, int e) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(beam.size(), dim);
  c.middleRows<2 * dim>(dim * e) = BeamElement<G>::P(beam.d0(e)).transpose() / beam.length(e);
  return c;
}

template PartSupport read_support(const std::vector<std::string>&, const Mechanism&,
                                  const Model<SE2>&, int);
template PartSupport read_support(const std::vector<std::string>&, const Mechanism&,
                                  const Model<SE3>&, int);
template class StaticPart<SE2>;
template class StaticPart<SE3>;

}  // namespace liesl
