#include "mbs/bodies/solid_body.hpp"

#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <stdexcept>

#include "liegroup/rotation.hpp"
#include "mbs/linalg/dense.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Map9 = Eigen::Map<const Eigen::Matrix<double, 9, 1>>;

/// Components of [u; w] in space that a tangent of G has.
template <class G>
constexpr auto kinds() {
  if constexpr (G::space_dim == 3)
    return std::array{0, 1, 2, 3, 4, 5};
  else
    return std::array{0, 1, 5};
}
template <class G>
Eigen::Matrix<double, 6, 1> in_space(const typename G::Tangent& h) {
  Eigen::Matrix<double, 6, 1> full = Eigen::Matrix<double, 6, 1>::Zero();
  for (int i = 0; i < G::dim; ++i) full[kinds<G>()[i]] = h[i];
  return full;
}
template <class G>
typename G::Tangent from_space(const Vector3d& u, const Vector3d& w) {
  typename G::Tangent h;
  for (int i = 0; i < G::dim; ++i)
    h[i] = kinds<G>()[i] < 3 ? u[kinds<G>()[i]] : w[kinds<G>()[i] - 3];
  return h;
}

/// int r x y of int r y^T.
Vector3d axial(const Matrix3d& A) {
  return {A(1, 2) - A(2, 1), A(2, 0) - A(0, 2), A(0, 1) - A(1, 0)};
}

Matrix3d as_matrix(const VectorXd& nine) { return Eigen::Map<const Matrix3d>(nine.data()); }

/// Turn of the port coordinates [u; w] of SE(2) or SE(3) from the axes of the mesh.
template <class G>
typename G::Matrix port_turn(const Matrix3d& turn) {
  Eigen::Matrix<double, 6, 6> full = Eigen::Matrix<double, 6, 6>::Zero();
  full.topLeftCorner<3, 3>() = full.bottomRightCorner<3, 3>() = turn;
  typename G::Matrix part;
  for (int i = 0; i < G::dim; ++i)
    for (int j = 0; j < G::dim; ++j) part(i, j) = full(kinds<G>()[i], kinds<G>()[j]);
  return part;
}

}  // namespace

template <FrameGroup G>
SolidBody<G>::SolidBody(std::string body_name, const SolidSpec& spec, std::vector<G> ports,
                        const Matrix3d& turn)
    : FloatingBody<G>(std::move(body_name),
                      [&] {  // amplitudes are kept dim a node, at the first interface
                        auto nodes = ports;
                        nodes.insert(nodes.end(), (spec.modes + dim - 1) / dim, ports.at(0));
                        return nodes;
                      }()),
      origin_(spec.interfaces()[0].point),
      turn_(turn),
      ports_(static_cast<int>(ports.size())),
      damping_(spec.damping),
      model_(spec.model),
      fractions_(solid_fractions(spec).value),
      shares_(relaxed_shares(fractions_)) {
  const SolidModel& model = *model_;
  const VectorXd& v = fractions_;
  const ReducedSolid reduced = reduce(model, v, ReductionKind::CraigBampton, spec.modes);
  if (!reduced.converged) throw std::runtime_error("modes of '" + this->name + "' not found");
  const int ni = dim * (ports_ - 1), n = ni + spec.modes;
  basis_ = reduced.basis.rightCols(n);  // the first port is held
  for (int i = 0; i + 1 < ports_; ++i)  // e has the axes of the ports
    basis_.middleCols(dim * i, dim) *= port_turn<G>(turn).transpose();
  loads_ = model.stiffness(v).template selfadjointView<Eigen::Lower>() * basis_;
  const MatrixXd K_e = basis_.transpose() * loads_;
  std::vector<NodeKind> kind(this->nodes(), NodeKind::Amplitudes);
  std::fill_n(kind.begin(), ports_, NodeKind::Frame);
  this->reduce_to(std::move(kind), 0.5 * (K_e + K_e.transpose()),
                  (2 * std::numbers::pi * reduced.frequencies).cwiseAbs2());
  set_integrals(inertia_integrals(model, v, basis_));
  this->set_constant_matrices();
}

/// dPsi/dp; a factor serves all parameters of one design.
template <FrameGroup G>
MatrixXd SolidBody<G>::basis_derivative(const FractionDerivative& law) const {
  const std::lock_guard lock(*asking_);
  if (!modes_ || modes_->fractions() != law.fractions)
    modes_ = std::make_shared<ModeDerivative>(*law.model, law.fractions, basis_);
  return (*modes_)(*law.model, law.derivative);
}

/// K_e' = Psi^T K' Psi + Psi'^T K Psi + Psi^T K Psi'. Stiffness has the slope s'(v) of the ersatz
/// law, integrals are linear in the fractions.
template <FrameGroup G>
SolidBody<G>::SolidBody(const SolidBody& body, const FractionDerivative& law)
    : FloatingBody<G>(body),
      origin_(body.origin_),
      turn_(body.turn_),
      ports_(body.ports_),
      damping_(body.damping_),
      model_(body.model_),
      fractions_(law.derivative),
      shares_(relaxed_shares_derivative(law.fractions, law.derivative)),
      basis_(body.basis_derivative(law)) {
  const MatrixXd& Psi = body.basis_;
  MatrixXd dK_e = Psi.transpose() * (law.model->stiffness_derivative(law.fractions, law.derivative)
                                         .template selfadjointView<Eigen::Lower>() *
                                     Psi);
  const MatrixXd turned = basis_.transpose() * body.loads_;  // Psi'^T K Psi
  dK_e += turned + turned.transpose();
  this->become_derivative(dK_e, false);
  set_integrals(
      inertia_integrals_derivative(*law.model, law.fractions, Psi, law.derivative, basis_));
  this->set_constant_matrices();
}

template <FrameGroup G>
SolidBody<G>::SolidBody(const SolidBody& body, const ScaleDerivative& law) : SolidBody(body) {
  this->become_derivative(law.stiffness * (basis_.transpose() * loads_), law.mass == 0);
  basis_ *= law.stress;
  shares_.setZero();
  InertiaIntegrals& I = integrals_;
  I.mass *= law.mass;
  I.first *= law.mass;
  I.second *= law.mass;
  I.mode *= law.mass;
  for (MatrixXd* of : {&M_e_, &cross_, &product_}) *of *= law.mass;
  this->set_constant_matrices();
}

template <FrameGroup G>
std::unique_ptr<Body<G>> SolidBody<G>::derivative(const LawDerivative<G>& law) const {
  if (const auto* scale = std::get_if<ScaleDerivative>(&law))
    return std::unique_ptr<Body<G>>(new SolidBody(*this, *scale));
  const auto* cells = std::get_if<FractionDerivative>(&law);
  const bool fits = cells && cells->model && cells->model->size() == basis_.rows() &&
                    cells->fractions.size() == cells->model->mesh().cell_count() &&
                    cells->derivative.size() == cells->fractions.size();
  if (!fits)
    throw std::invalid_argument("derivative of meshed part '" + this->name +
                                "': expected that of the fractions of its cells, or of a scale");
  return std::unique_ptr<Body<G>>(new SolidBody(*this, *cells));
}

/// About the first interface, in its axes, padded to the size of e.
template <FrameGroup G>
void SolidBody<G>::set_integrals(const InertiaIntegrals& mesh) {
  const Vector3d& origin = origin_;
  const Matrix3d& turn = turn_;
  const int n = static_cast<int>(mesh.mode.cols()), padded = this->reduced_size();
  InertiaIntegrals& I = integrals_;
  I.mass = mesh.mass;
  I.first = turn * (mesh.first - I.mass * origin);
  const Matrix3d moved = mesh.second - mesh.first * origin.transpose() -
                         origin * mesh.first.transpose() + I.mass * origin * origin.transpose();
  I.second = turn * moved * turn.transpose();
  I.mode.setZero(3, padded);
  I.mode.leftCols(n) = turn * mesh.mode;
  cross_.setZero(9, padded);
  product_.setZero(9 * padded, padded);
  M_e_.setZero(padded, padded);
  const auto put = [&](const Matrix3d& A, auto&& nine) {
    const Matrix3d turned = turn * A * turn.transpose();
    nine = Map9(turned.data());
  };
  for (int k = 0; k < n; ++k) {
    put(mesh.cross[k] - origin * mesh.mode.col(k).transpose(), cross_.col(k));
    for (int l = 0; l < n; ++l) {
      put(mesh.product[l * n + k], product_.template block<9, 1>(9 * k, l));
      M_e_(k, l) = mesh.product[l * n + k].trace();
    }
  }
}

template <FrameGroup G>
std::unique_ptr<BodyWorkspace> SolidBody<G>::make_workspace() const {
  auto room = std::make_unique<Room>();
  this->set_up(*room);
  room->C.setZero(9, this->reduced_size());
  room->D.setZero(9, this->reduced_size());
  return room;
}

template <FrameGroup G>
MatrixXd SolidBody<G>::moments(const VectorXd& e) const {
  MatrixXd C = cross_;
  Eigen::Map<VectorXd>(C.data(), C.size()).noalias() += product_ * e;
  return C;
}

template <FrameGroup G>
void SolidBody<G>::inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0,
                                 Tangent& f_0, VectorXd& q, ForceScale& scale,
                                 typename FloatingBody<G>::Workspace& work) const {
  MatrixXd &C = static_cast<Room&>(work).C, &D = static_cast<Room&>(work).D;
  const auto velocity = in_space<G>(v_0), rate = in_space<G>(a_0);
  const Vector3d omega = velocity.template tail<3>();
  const Matrix3d turning = hat(omega), alpha = hat(Vector3d(rate.template tail<3>()));
  const InertiaIntegrals& I = integrals_;
  C = cross_;
  Eigen::Map<VectorXd>(C.data(), C.size()).noalias() += product_ * m.e;
  Eigen::Map<VectorXd>(D.data(), D.size()).noalias() = product_ * m.rate;
  const Vector3d S = I.first + I.mode * m.e;
  const Eigen::Matrix<double, 9, 1> own = cross_ * m.e, all = C * m.e, slow = C * m.rate,
                                    fast = C * m.acceleration;
  const auto matrix = [](const auto& nine) { return Eigen::Map<const Matrix3d>(nine.data()); };
  const Matrix3d J = I.second + matrix(own).transpose() + matrix(all);
  // What is left at rest, and what turning adds; both drive the modes.
  const Vector3d uniform = rate.template head<3>(),
                 carried = omega.cross(velocity.template head<3>());
  const Matrix3d centripetal = turning * turning;
  const Tangent accelerated =
      from_space<G>(I.mass * uniform + alpha * S + I.mode * m.acceleration,
                    S.cross(uniform) + axial(J * alpha.transpose() + matrix(fast)));
  const Tangent gyroscopic = from_space<G>(
      I.mass * carried + centripetal * S + 2 * turning * (I.mode * m.rate),
      S.cross(carried) +
          axial(J * centripetal.transpose() + 2 * matrix(slow) * turning.transpose()));
  f_0 += accelerated + gyroscopic;
  scale.add<G>(accelerated);
  scale.add<G>(gyroscopic);
  const Matrix3d field = (alpha + centripetal).transpose(), coriolis = 2 * turning.transpose();
  q.noalias() += I.mode.transpose() * (uniform + carried);
  q.noalias() += C.transpose() * Map9(field.data());
  q.noalias() += D.transpose() * Map9(coriolis.data());
  q.noalias() += M_e_ * m.acceleration;
}

/// Product rule on `inertia_force`: what depends on e is S, C and J.
template <FrameGroup G>
MatrixXd SolidBody<G>::inertia_by_e(const Motion& m, const Tangent& v_0, const Tangent& a_0) const {
  const auto velocity = in_space<G>(v_0), rate = in_space<G>(a_0);
  const Vector3d v = velocity.template head<3>(), omega = velocity.template tail<3>();
  const Matrix3d turning = hat(omega);
  const Matrix3d W = hat(Vector3d(rate.template tail<3>())) + turning * turning,
                 field = W.transpose();
  const Eigen::Index n = this->reduced_size();
  const MatrixXd C = moments(m.e);
  const Vector3d a = Vector3d(rate.template head<3>()) + omega.cross(v);
  MatrixXd out = MatrixXd::Zero(dim + n, n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const VectorXd column = product_.col(k);
    const Eigen::Map<const MatrixXd> dC(column.data(), 9, n);  // dD as well
    const Vector3d mode = integrals_.mode.col(k);
    const Matrix3d dJ =
        as_matrix(cross_.col(k)).transpose() + as_matrix(C.col(k)) + as_matrix(dC * m.e);
    out.col(k).head(dim) = from_space<G>(
        W * mode, mode.cross(a) + axial(dJ * field + as_matrix(dC * m.acceleration) +
                                        2 * as_matrix(dC * m.rate) * turning.transpose()));
    out.col(k).tail(n) = dC.transpose() * Map9(field.data());
  }
  return out;
}

/// What depends on edot is D and the Coriolis terms, on v_0 all that turns.
template <FrameGroup G>
MatrixXd SolidBody<G>::inertia_by_rates(const Motion& m, const Tangent& v_0) const {
  const auto velocity = in_space<G>(v_0);
  const Vector3d v = velocity.template head<3>(), omega = velocity.template tail<3>();
  const Matrix3d turning = hat(omega), coriolis = 2 * turning.transpose();
  const InertiaIntegrals& I = integrals_;
  const Eigen::Index n = this->reduced_size();
  const MatrixXd C = moments(m.e);
  const Vector3d S = I.first + I.mode * m.e;
  const VectorXd slow = C * m.rate;
  const Matrix3d J = I.second + as_matrix(cross_ * m.e).transpose() + as_matrix(C * m.e);
  MatrixXd D(9, n);
  Eigen::Map<VectorXd>(D.data(), D.size()).noalias() = product_ * m.rate;
  MatrixXd out = MatrixXd::Zero(dim + n, dim + n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const VectorXd column = product_.col(k);
    const Eigen::Map<const MatrixXd> dD(column.data(), 9, n);
    out.col(dim + k).head(dim) =
        from_space<G>(2 * turning * Vector3d(I.mode.col(k)), axial(as_matrix(C.col(k)) * coriolis));
    out.col(dim + k).tail(n) = dD.transpose() * Map9(coriolis.data());
  }
  const auto nine = [](const Matrix3d& A) { return VectorXd(Map9(A.data())); };
  for (int j = 0; j < dim; ++j) {
    const auto direction = in_space<G>(Tangent::Unit(j));
    const Vector3d dv = direction.template head<3>(), dw = direction.template tail<3>();
    const Matrix3d turn = hat(dw), dW = turn * turning + turning * turn;
    const Vector3d da = omega.cross(dv) + dw.cross(v);
    out.col(j).head(dim) = from_space<G>(
        I.mass * da + dW * S + 2 * turn * (I.mode * m.rate),
        S.cross(da) + axial(J * dW.transpose() + 2 * as_matrix(slow) * turn.transpose()));
    out.col(j).tail(n) = I.mode.transpose() * da + C.transpose() * nine(dW.transpose()) +
                         D.transpose() * nine(2 * turn.transpose());
  }
  return out;
}

/// [m, -S~, N; S~, tr(J) - J, int rho r x phi; N^T, ..., M_e].
template <FrameGroup G>
MatrixXd SolidBody<G>::inertia_matrix(const Motion& m) const {
  const InertiaIntegrals& I = integrals_;
  const int n = this->reduced_size();
  const MatrixXd C = moments(m.e);
  const Matrix3d J = I.second + as_matrix(cross_ * m.e).transpose() + as_matrix(C * m.e);
  const Vector3d S = I.first + I.mode * m.e;
  MatrixXd full(6 + n, 6 + n);
  full.topLeftCorner<3, 3>() = I.mass * Matrix3d::Identity();
  full.block<3, 3>(3, 0) = hat(S);
  full.block<3, 3>(3, 3) = J.trace() * Matrix3d::Identity() - J;
  full.bottomLeftCorner(n, 3) = I.mode.transpose();
  for (int k = 0; k < n; ++k) full.block<1, 3>(6 + k, 3) = axial(as_matrix(C.col(k))).transpose();
  full.bottomRightCorner(n, n) = M_e_;
  full.topRightCorner(6, n) = full.bottomLeftCorner(n, 6).transpose().eval();
  full.block<3, 3>(0, 3) = full.block<3, 3>(3, 0).transpose().eval();
  const auto own = kinds<G>();
  std::vector<int> rows(own.begin(), own.end());
  for (int k = 0; k < n; ++k) rows.push_back(6 + k);
  return full(rows, rows);
}

template <FrameGroup G>
auto SolidBody<G>::inertia_tangents(const Motion& m, const Tangent& v_0, const Tangent& a_0) const
    -> InertiaTangents {
  InertiaTangents out{inertia_matrix(m), inertia_by_rates(m, v_0), inertia_by_e(m, v_0, a_0),
                      VectorXd::Zero(this->reduced_size())};
  const auto work = make_workspace();
  Tangent f_0 = Tangent::Zero();
  ForceScale scale;
  inertia_force(m, v_0, a_0, f_0, out.q, scale,
                static_cast<typename FloatingBody<G>::Workspace&>(*work));
  return out;
}

template <FrameGroup G>
void SolidBody<G>::complete(G* H, double*, double*, const double*) const {
  for (int k = ports_; k < this->nodes(); ++k) H[k] = H[0];
}

template <FrameGroup G>
VectorXd SolidBody<G>::coordinates(const BodyState<G>& s) const {
  Motion m = this->at_reference();
  this->measure(s, false, m);
  return m.e.head(basis_.cols());
}

template <FrameGroup G>
void SolidBody<G>::add_coordinates_gradient(const BodyState<G>& s, const VectorXd& c,
                                            double* h) const {
  Motion m = this->at_reference();
  this->measure(s, true, m);
  VectorXd padded = VectorXd::Zero(this->reduced_size()), by_rate = padded;
  VectorXd v = VectorXd::Zero(this->size());
  padded.head(c.size()) = c;
  this->add_unknowns(m, s, padded, by_rate, h, v.data());
}

template <FrameGroup G>
VectorXd SolidBody<G>::free_frequencies(int count, int kept) const {
  const Eigen::Index n = dim * ports_ + kept;
  const auto all = linalg::generalized_eigenvalues(this->K_.dense.topLeftCorner(n, n),
                                                   this->M_.dense.topLeftCorner(n, n));
  if (!all) throw std::runtime_error("free frequencies of '" + this->name + "' not found");
  const auto elastic = all->segment(dim, std::min<Eigen::Index>(count, n - dim));
  return elastic.cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi);
}

template <FrameGroup G>
double SolidBody<G>::dissipation(const BodyState<G>& s) const {
  if (damping_ == 0) return 0;
  Motion m = this->at_reference();
  this->measure(s, true, m);
  return damping_ * m.rate.dot(this->reduced_stiffness() * m.rate);
}

template <FrameGroup G>
BodyEnergy SolidBody<G>::energy(const BodyState<G>& s, const Vector& gravity) const {
  Motion m = this->at_reference();
  this->measure(s, true, m);
  VectorXd rate(dim + m.rate.size());
  rate << Eigen::Map<const Tangent>(s.v), m.rate;
  const Vector3d S = integrals_.first + integrals_.mode * m.e;
  BodyEnergy energy;
  energy.kinetic = 0.5 * rate.dot(inertia_matrix(m) * rate);
  energy.elastic = 0.5 * m.e.dot(this->reduced_stiffness() * m.e);
  energy.potential =
      -gravity.dot(integrals_.mass * s.H[0].x + s.H[0].R * S.template head<G::space_dim>());
  return energy;
}

/// With S and J of the deformed part dT/de_l = v . (omega x N_l) + omega^T (tr dJ_l - dJ_l) omega/2
/// + sum_k edot_k omega . axial(P_kl), P_kl = int rho phi_l phi_k^T.
template <FrameGroup G>
VectorXd SolidBody<G>::kinetic_by_e(const Motion& m, const Tangent& v_0) const {
  const int n = this->reduced_size();
  const auto velocity = in_space<G>(v_0);
  const Vector3d u = velocity.template head<3>(), omega = velocity.template tail<3>();
  VectorXd out(n);
  for (int l = 0; l < n; ++l) {
    const Matrix3d first = as_matrix(cross_.col(l));
    const Eigen::Map<const Eigen::MatrixXd> P(product_.col(l).data(), 9, n);
    const Matrix3d second = as_matrix(P * m.e);
    const Matrix3d dJ = first + first.transpose() + second + second.transpose();
    const double turning = omega.dot((dJ.trace() * omega - dJ * omega)) / 2;
    out[l] = u.dot(omega.cross(Vector3d(integrals_.mode.col(l)))) + turning +
             omega.dot(axial(as_matrix(P * m.rate)));
  }
  return out;
}

/// T = r^T M(e) r / 2 with r = [v_0; edot]: dT/dr = M r.
template <FrameGroup G>
void SolidBody<G>::add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                       const BodyEnergy& weight, double* h, double* v) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  Motion m = this->at_reference();
  this->measure(s, true, m);
  const Eigen::Map<const Tangent> v_0(s.v);
  const int n = this->reduced_size();
  VectorXd rate(dim + n);
  rate << v_0, m.rate;
  const VectorXd momentum = inertia_matrix(m) * rate;
  const Vector g = s.H[0].R.transpose() * gravity;
  const VectorXd on_e = weight.elastic * (this->reduced_stiffness() * m.e) +
                        weight.kinetic * kinetic_by_e(m, v_0) -
                        weight.potential * (integrals_.mode.template topRows<sd>().transpose() * g);
  Eigen::Map<Tangent> on_h(h), on_v(v);
  on_v += weight.kinetic * momentum.template head<dim>();
  const Vector S = (integrals_.first + integrals_.mode * m.e).template head<sd>();
  on_h.template head<sd>() -= weight.potential * integrals_.mass * g;
  on_h.template tail<rd>() += weight.potential * (RotationOf<G>::cross(S).transpose() * g);
  this->add_unknowns(m, s, on_e, weight.kinetic * momentum.tail(n), h, v);
}

template <FrameGroup G>
double SolidBody<G>::axial_stiffness() const {
  double largest = 0;
  for (int i = 0; i + 1 < ports_; ++i)
    largest = std::max(
        largest, this->reduced_stiffness().diagonal().segment(dim * i, G::space_dim).maxCoeff());
  return largest;
}

template class SolidBody<SE2>;
template class SolidBody<SE3>;

}  // namespace liesl
