#include "esl/static_part.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <set>
#include <stdexcept>

namespace liesl {
namespace {

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

}  // namespace

template <FrameGroup G>
HeldPart read_support(const std::vector<std::string>& support, const Mechanism& mechanism,
                      const Model<G>& model, int body) {
  HeldPart held;
  const std::string& name = mechanism.bodies[body].name;
  std::vector<std::string> places = support.empty() ? std::vector<std::string>{"start"} : support;
  if (places[0] == "inertia_relief") {
    held.inertia_relief = true;
    places = {"start"};
  }
  std::set<int> fixed;
  for (const auto& text : places) {
    const size_t colon = text.find(':');
    const auto port = mechanism.port(name + "." + text.substr(0, colon));
    if (!port) throw std::invalid_argument(fmt::format("support of '{}': no node '{}'; expected start, end, mid or nodeK", name, text));
    const SE3 align = model.space.alignment(mechanism.frame(*port));
    const auto letters = colon == std::string::npos ? std::string("xyzrxryrz") : text.substr(colon + 1);
    for (const int d : directions(letters)) {
      if (d < 0) throw std::invalid_argument(fmt::format("support of '{}': '{}'; expected directions among x, y, z, rx, ry, rz", name, text));
      const typename G::Tangent local = model.space.reduce_local(SE3::Tangent::Unit(d), align);
      int index = 0;
      if (local.cwiseAbs().maxCoeff(&index) > 0.5) fixed.insert(G::dim * port->node + index);
    }
  }
  if (static_cast<int>(fixed.size()) != G::dim)
    throw std::invalid_argument(fmt::format("support of '{}' holds {} directions; expected {}, as many as the part has rigid motions",
                                            name, fixed.size(), G::dim));
  held.fixed.assign(fixed.begin(), fixed.end());
  return held;
}

template <FrameGroup G>
StaticPart<G>::StaticPart(const Beam<G>& beam, HeldPart held, Eigen::MatrixXd outputs)
    : beam_(beam), held_(std::move(held)), C_(std::move(outputs)), K_(beam.nodes()) {
  for (int e = 0; e < beam.elements(); ++e) {
    P0_.push_back(BeamElement<G>::P(beam.element(e).d0()));
    length_.push_back(beam.element(e).length());
  }
  strain_u_.resize(P0_.size());
  strain_mu_.resize(P0_.size());
}

template <FrameGroup G>
void StaticPart<G>::set_loads(const Eigen::MatrixXd& f) {
  f_ = f;
  if (!held_.inertia_relief || f.cols() == 0) return;
  Eigen::MatrixXd R(beam_.size(), dim), MR = Eigen::MatrixXd::Zero(beam_.size(), dim);
  for (int k = 0; k < beam_.nodes(); ++k) R.middleRows<dim>(dim * k) = beam_.reference[k].AdInv();
  for (int j = 0; j < dim; ++j) beam_.mass().multiply_add(R.col(j).data(), MR.col(j).data());
  const Matrix inertia = R.transpose() * MR;
  f_ -= MR * inertia.inverse() * (R.transpose() * f);
}

template <FrameGroup G>
void StaticPart<G>::solve_columns(Eigen::MatrixXd& x) const {
  for (const int i : held_.fixed) x.row(i).setZero();
  for (int n = 0; n < x.cols(); ++n) lu_.solve(x.col(n).data());
}

template <FrameGroup G>
bool StaticPart<G>::solve(const Law& K_s) {
  K_.set_zero();
  for (size_t e = 0; e < P0_.size(); ++e)
    K_.add_element(static_cast<int>(e), (P0_[e].transpose() * K_s[e] * P0_[e] / length_[e]).eval());
  for (const int i : held_.fixed) {
    const int k = i / dim, row = i % dim;
    K_.D[k].row(row).setZero();
    K_.D[k].col(row).setZero();
    K_.D[k](row, row) = 1;
    if (k > 0) {
      K_.U[k - 1].col(row).setZero();
      K_.L[k - 1].row(row).setZero();
    }
    if (k + 1 < K_.blocks()) {
      K_.U[k].row(row).setZero();
      K_.L[k].col(row).setZero();
    }
  }
  if (!lu_.factor(K_)) return false;
  u_ = f_;
  solve_columns(u_);
  mu_ = C_;
  solve_columns(mu_);
  y_ = C_.transpose() * u_;
  for (size_t e = 0; e < P0_.size(); ++e) {
    strain_u_[e] = P0_[e] * u_.middleRows<2 * dim>(dim * static_cast<int>(e));
    strain_mu_[e] = P0_[e] * mu_.middleRows<2 * dim>(dim * static_cast<int>(e));
  }
  return u_.allFinite() && mu_.allFinite();
}

template <FrameGroup G>
void StaticPart<G>::add_gradient(int e, const Matrix& dK_s, Eigen::MatrixXd& dy) const {
  const Strain n = dK_s * strain_u_[e];
  dy.topRows(outputs()).noalias() -= (strain_mu_[e].transpose() / length_[e]) * n;
}

template <FrameGroup G>
Eigen::RowVectorXd StaticPart<G>::compliance_gradient(int e, const Matrix& dK_s) const {
  return -strain_u_[e].cwiseProduct(dK_s * strain_u_[e]).colwise().sum() / length_[e];
}

template <FrameGroup G>
Eigen::MatrixXd StaticPart<G>::multiply(const Law& dK, const Eigen::MatrixXd& u) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(u.rows(), u.cols());
  for (size_t e = 0; e < P0_.size(); ++e) {
    const int row = dim * static_cast<int>(e);
    out.middleRows<2 * dim>(row) +=
        P0_[e].transpose() * (dK[e] * (P0_[e] * u.middleRows<2 * dim>(row))) / length_[e];
  }
  return out;
}

template <FrameGroup G>
void StaticPart<G>::add_second(const std::vector<Law>& dK, const Second& d2K, const Eigen::MatrixXd& w,
                               Eigen::MatrixXd& h) const {
  // The sum over cases goes into the displacement: ubar_o = sum_n w(o, n) u_n, one an output.
  const Eigen::MatrixXd ubar = u_ * w.transpose();
  const int n = static_cast<int>(dK.size());
  std::vector<Eigen::MatrixXd> K_ubar(n), K_mu(n), solved(n);
  for (int i = 0; i < n; ++i) {
    if (dK[i].empty()) continue;
    K_ubar[i] = multiply(dK[i], ubar);
    K_mu[i] = multiply(dK[i], mu_);
    for (const int f : held_.fixed) {
      K_ubar[i].row(f).setZero();
      K_mu[i].row(f).setZero();
    }
    solved[i] = K_ubar[i];
    solve_columns(solved[i]);
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
Eigen::MatrixXd StaticPart<G>::strain_output(const Beam<G>& beam, int e) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(beam.size(), dim);
  const auto& element = beam.element(e);
  c.middleRows<2 * dim>(dim * e) = BeamElement<G>::P(element.d0()).transpose() / element.length();
  return c;
}

template HeldPart read_support(const std::vector<std::string>&, const Mechanism&, const Model<SE2>&, int);
template HeldPart read_support(const std::vector<std::string>&, const Mechanism&, const Model<SE3>&, int);
template class StaticPart<SE2>;
template class StaticPart<SE3>;

}  // namespace liesl
