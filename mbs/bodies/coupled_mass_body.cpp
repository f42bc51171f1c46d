#include "mbs/bodies/coupled_mass_body.hpp"

#include <stdexcept>

#include "mbs/linalg/dense.hpp"
#include "mbs/solids/motion_mass.hpp"

namespace liesl {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// d/dv of ad(v)^T pi.
template <class G>
typename G::Matrix turning_of(const typename G::Tangent& pi) {
  typename G::Matrix out;
  for (int j = 0; j < G::dim; ++j) out.col(j) = G::ad(G::Tangent::Unit(j)).transpose() * pi;
  return out;
}

/// s of omega x s, columns of m (omega x s) by the components of omega.
Vector3d centre(const MatrixXd& carried) {
  if (carried.cols() == 1) return {carried(1, 0), -carried(0, 0), 0};
  return 0.5 * Vector3d(carried(1, 2) - carried(2, 1), carried(2, 0) - carried(0, 2),
                        carried(0, 1) - carried(1, 0));
}

}  // namespace

template <FrameGroup G>
CoupledMassBody<G>::CoupledMassBody(std::string body_name, const SolidSpec& spec,
                                    std::vector<G> ports, const Matrix3d& turn)
    : SolidBody<G>(std::move(body_name), spec, std::move(ports), turn) {
  const MatrixXd full = motion_mass(this->model(), this->basis(), this->origin_, turn);
  const Eigen::Index own = this->basis().cols(), size = dim + (1 + kTurns) * n();
  std::vector<Eigen::Index> rows;
  for (int i = 0; i < dim; ++i) rows.push_back(i);
  for (int b = -1; b < kTurns; ++b)
    for (Eigen::Index k = 0; k < own; ++k) rows.push_back(at(b) + k);
  mass_.setZero(size, size);
  mass_(rows, rows) = full;
  InertiaIntegrals& I = this->integrals_;
  constexpr int sd = G::space_dim;
  I.mass = mass_.topLeftCorner(sd, sd).trace() / sd;
  I.first = centre(mass_.block(0, sd, sd, kTurns));
  I.mode.setZero(3, n());
  I.mode.template topRows<sd>() = mass_.block(0, dim, sd, n());
  this->set_constant_matrices();
}

template <FrameGroup G>
std::unique_ptr<BodyWorkspace> CoupledMassBody<G>::make_workspace() const {
  auto room = std::make_unique<Room>();
  this->set_up(*room);
  room->y.setZero(mass_.cols(), 2);
  room->p.setZero(mass_.cols(), 2);
  return room;
}

template <FrameGroup G>
std::unique_ptr<Body<G>> CoupledMassBody<G>::derivative(const LawDerivative<G>&) const {
  throw std::invalid_argument("part '" + this->name +
                              "' is given by matrices, which have no parameters");
}

/// y = [v; omega; edot; omega_b e] and [a; alpha; eddot; alpha_b e + omega_b edot].
template <FrameGroup G>
void CoupledMassBody<G>::set_motion(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                                    MatrixXd& y) const {
  y.col(0).template head<dim>() = v_0;
  y.col(1).template head<dim>() = a_0;
  y.col(0).segment(dim, n()) = m.rate;
  y.col(1).segment(dim, n()) = m.acceleration;
  for (int b = 0; b < kTurns; ++b) {
    const double omega = v_0[G::space_dim + b], alpha = a_0[G::space_dim + b];
    y.col(0).segment(at(b), n()) = omega * m.e;
    y.col(1).segment(at(b), n()) = alpha * m.e + omega * m.rate;
  }
}

template <FrameGroup G>
void CoupledMassBody<G>::inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                                       Tangent& f_0, VectorXd& q, ForceScale& scale,
                                       typename FloatingBody<G>::Workspace& work) const {
  Room& room = static_cast<Room&>(work);
  set_motion(m, v_0, a_0, room.y);
  room.p.noalias() = mass_ * room.y;
  const auto p = room.p.col(0), rate = room.p.col(1);
  Tangent momentum = p.template head<dim>(), accelerated = rate.template head<dim>();
  q += rate.segment(dim, n());
  for (int b = 0; b < kTurns; ++b) {
    const auto own = p.segment(at(b), n());
    const int row = G::space_dim + b;
    momentum[row] += m.e.dot(own);
    accelerated[row] += m.e.dot(rate.segment(at(b), n())) + m.rate.dot(own);
    q -= v_0[row] * own;
  }
  const Tangent gyroscopic = -(G::ad(v_0).transpose() * momentum);
  f_0 += accelerated + gyroscopic;
  scale.add<G>(accelerated);
  scale.add<G>(gyroscopic);
}

template <FrameGroup G>
MatrixXd CoupledMassBody<G>::by_velocities(const VectorXd& e, bool rate) const {
  MatrixXd J = MatrixXd::Zero(mass_.rows(), dim + n());
  if (!rate) J.topRows(dim + n()).setIdentity();
  for (int b = 0; b < kTurns; ++b) J.block(at(b), G::space_dim + b, n(), 1) = e;
  return J;
}

/// J^T (W^T M W) J.
template <FrameGroup G>
MatrixXd CoupledMassBody<G>::inertia_matrix(const Motion& m) const {
  const MatrixXd J = by_velocities(m.e, false);
  return linalg::transposed_product(J, linalg::product(mass_, J));
}

template <FrameGroup G>
VectorXd CoupledMassBody<G>::kinetic_by_e(const Motion& m, const Tangent& v_0) const {
  MatrixXd y = MatrixXd::Zero(mass_.cols(), 2);
  set_motion(m, v_0, Tangent::Zero(), y);
  const VectorXd p = mass_ * y.col(0);
  VectorXd out = VectorXd::Zero(n());
  for (int b = 0; b < kTurns; ++b) out += v_0[G::space_dim + b] * p.segment(at(b), n());
  return out;
}

/// f = J^T p' + J'^T p - [ad(v_0)^T pi_0; sum_b omega_b p_b] at constant velocities: what depends
/// on e is the rows omega_b e of y and J.
template <FrameGroup G>
MatrixXd CoupledMassBody<G>::inertia_by_e(const Motion& m, const Tangent& v_0,
                                          const Tangent& a_0) const {
  MatrixXd y = MatrixXd::Zero(mass_.cols(), 2), dy = MatrixXd::Zero(mass_.cols(), n()), da = dy;
  set_motion(m, v_0, a_0, y);
  for (int b = 0; b < kTurns; ++b) {
    dy.middleRows(at(b), n()).diagonal().setConstant(v_0[G::space_dim + b]);
    da.middleRows(at(b), n()).diagonal().setConstant(a_0[G::space_dim + b]);
  }
  const MatrixXd p = mass_ * y, dp = linalg::product(mass_, dy),
                 dp_rate = linalg::product(mass_, da);
  const MatrixXd J = by_velocities(m.e, false), J_rate = by_velocities(m.rate, true);
  MatrixXd momentum = linalg::transposed_product(J, dp);
  MatrixXd out = linalg::transposed_product(J, dp_rate) + linalg::transposed_product(J_rate, dp);
  for (int b = 0; b < kTurns; ++b) {
    const int row = G::space_dim + b;
    momentum.row(row) += p.col(0).segment(at(b), n()).transpose();
    out.row(row) += p.col(1).segment(at(b), n()).transpose();
    out.bottomRows(n()) -= v_0[row] * dp.middleRows(at(b), n());
  }
  out.topRows(dim) -= G::ad(v_0).transpose() * momentum.topRows(dim);
  return out;
}

/// Of the same at constant e and accelerations; y' has alpha_b e + omega_b edot.
template <FrameGroup G>
MatrixXd CoupledMassBody<G>::inertia_by_rates(const Motion& m, const Tangent& v_0) const {
  MatrixXd y = MatrixXd::Zero(mass_.cols(), 2);
  set_motion(m, v_0, Tangent::Zero(), y);
  const MatrixXd J = by_velocities(m.e, false), J_rate = by_velocities(m.rate, true);
  MatrixXd da = J_rate;
  for (int b = 0; b < kTurns; ++b)
    da.block(at(b), dim, n(), n()).diagonal().array() += v_0[G::space_dim + b];
  const MatrixXd dp = linalg::product(mass_, J), dp_rate = linalg::product(mass_, da);
  const VectorXd p = mass_ * y.col(0), pi = J.transpose() * p;
  const MatrixXd momentum = linalg::transposed_product(J, dp);
  MatrixXd out = linalg::transposed_product(J, dp_rate) + linalg::transposed_product(J_rate, dp);
  for (int b = 0; b < kTurns; ++b) {
    const int row = G::space_dim + b;
    const auto own = p.segment(at(b), n());
    out.block(row, dim, 1, n()) += own.transpose();
    out.block(dim, row, n(), 1) -= own;
    out.bottomRows(n()) -= v_0[row] * dp.middleRows(at(b), n());
  }
  out.topRows(dim) -= G::ad(v_0).transpose() * momentum.topRows(dim);
  out.topLeftCorner(dim, dim) -= turning_of<G>(Tangent(pi.template head<dim>()));
  return out;
}

template class CoupledMassBody<SE2>;
template class CoupledMassBody<SE3>;

}  // namespace liesl
