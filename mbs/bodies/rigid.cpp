#include "mbs/bodies/rigid.hpp"

#include <stdexcept>

#include "liegroup/rotation.hpp"
#include "mbs/bodies/beam_element.hpp"

namespace liesl {

/// Dense over node 0 where other nodes follow, else a chain of one. The first moment S is the force
/// that an angular acceleration takes, wdot x S.
template <FrameGroup G>
void Rigid<G>::set_matrices() {
  if constexpr (G::space_dim == 3)
    first_moment_ = vee(inertia_.template block<3, 3>(3, 0).eval());
  else
    first_moment_ = Vector(inertia_(1, 2), -inertia_(0, 2));
  if (this->nodes() > 1) {
    this->M_.set_dense({0}, inertia_);
    this->K_.set_dense({0}, Matrix::Zero());
  } else {
    this->M_.resize(1);
    this->K_.resize(1);
    this->M_.D[0] = inertia_;
  }
}

template <FrameGroup G>
Rigid<G>::Rigid(std::string body_name, std::shared_ptr<const Body<G>> made_of)
    : Body<G>(std::move(body_name), made_of->reference), flexible_(std::move(made_of)) {
  const Body<G>& flexible = *flexible_;
  const int n = this->nodes();
  Eigen::MatrixXd J(dim * n, dim), turned = Eigen::MatrixXd::Zero(dim * n, dim);
  Eigen::MatrixXd MJ = Eigen::MatrixXd::Zero(dim * n, dim), WJ = MJ, WF = MJ, same = MJ;
  for (int k = 0; k < n; ++k) {
    X_.push_back(this->reference[0].inverse() * this->reference[k]);
    J.middleRows<dim>(dim * k) = X_[k].AdInv();
    // Components in the axes of node k of a vector given in those of node 0.
    auto turn = turned.middleRows<dim>(dim * k);
    turn.setIdentity();
    turn.template topLeftCorner<G::space_dim, G::space_dim>() = X_[k].R.transpose();
    if constexpr (G::rotation_dim == 3)
      turn.template bottomRightCorner<3, 3>() = X_[k].R.transpose();
    same.middleRows<dim>(dim * k).setIdentity();
  }
  const Matrices W = flexible.load_distribution(), &M = flexible.mass();
  for (int j = 0; j < dim; ++j) {
    if (!M.is_dense()) M.multiply_add(J.col(j).data(), MJ.col(j).data());
    W.multiply_add(turned.col(j).data(), WJ.col(j).data());
    W.multiply_add(same.col(j).data(), WF.col(j).data());
  }
  const auto moves = [&](size_t a) { return flexible.kind(M.nodes[a]) == NodeKind::Frame; };
  for (size_t a = 0; a < M.nodes.size(); ++a)  // of a reduced body: its frames
    for (size_t b = 0; b < M.nodes.size(); ++b)
      if (moves(a) && moves(b))
        MJ.middleRows<dim>(dim * M.nodes[a]) += M.dense.template block<dim, dim>(dim * a, dim * b) *
                                                J.middleRows<dim>(dim * M.nodes[b]);
  inertia_ = J.transpose() * MJ;
  dead_share_ = Eigen::MatrixXd::Zero(dim * n, dim);
  follower_share_ = dead_share_;
  dead_share_.topRows<dim>() = J.transpose() * WJ;
  follower_share_.topRows<dim>() = J.transpose() * WF;
  set_matrices();
}

template <FrameGroup G>
void Rigid<G>::complete(G* H, double* v, double* vdot, const double*) const {
  using Node = Eigen::Map<Tangent>;
  for (int k = 1; k < this->nodes(); ++k) {
    H[k] = H[0] * X_[k];
    Node(v + dim * k) = X_[k].AdInv() * Node(v);
    Node(vdot + dim * k) = X_[k].AdInv() * Node(vdot);
  }
}

template <FrameGroup G>
Eigen::MatrixXd Rigid<G>::load_share(bool follower) const {
  return follower ? follower_share_ : dead_share_;
}

template <FrameGroup G>
void Rigid<G>::add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                           ForceScale& scale) const {
  const Tangent v = Eigen::Map<const Tangent>(s.v);
  const auto& M = inertia_;
  const Tangent accelerated = M * apparent_acceleration<G>(s, 0, gravity),
                gyroscopic = BeamElement<G>::minus_ad_transpose(v, M * v);
  Eigen::Map<Tangent>{r} += accelerated + gyroscopic;
  // One by one: in free flight their sum is the residual itself.
  scale.add<G>(accelerated);
  scale.add<G>(gyroscopic);
}

template <FrameGroup G>
void Rigid<G>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                             const Tangent*, Matrices& A) const {
  const auto& M = inertia_;
  Matrix tangent = w.mass * M;
  if (w.damping != 0)
    tangent += w.damping *
               BeamElement<G>::minus_ad_transpose_derivative(Eigen::Map<const Tangent>(s.v), M);
  tangent += w.stiffness * M * weight_tangent<G>(s.H[0], gravity);
  if (A.is_dense())
    A.dense = tangent;
  else
    A.D[0] = tangent;
}

template <FrameGroup G>
BodyEnergy Rigid<G>::energy(const BodyState<G>& s, const Vector& gravity) const {
  const Eigen::Map<const Tangent> v(s.v);
  const auto& M = inertia_;
  return {0.5 * v.dot(M * v), 0, -gravity.dot(total_mass() * s.H[0].x + s.H[0].R * first_moment_)};
}

/// U = -g . (m x + R S): d(R S) = R (w x S) = -R S~ w.
template <FrameGroup G>
void Rigid<G>::add_energy_gradient(const BodyState<G>& s, const Vector& gravity,
                                   const BodyEnergy& weight, double* h, double* v) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  Eigen::Map<Tangent> on_h(h), on_v(v);
  on_v += weight.kinetic * (inertia_ * Eigen::Map<const Tangent>(s.v));
  const Vector g = s.H[0].R.transpose() * gravity;
  on_h.template head<sd>() -= weight.potential * total_mass() * g;
  on_h.template tail<rd>() +=
      weight.potential * (RotationOf<G>::cross(first_moment_).transpose() * g);
}

/// h_k = Ad(X_k^-1) h_0, and so the velocities and their rates.
template <FrameGroup G>
void Rigid<G>::to_first(double* x) const {
  using Node = Eigen::Map<Tangent>;
  for (int k = 1; k < this->nodes(); ++k) {
    Node(x + 0) += X_[k].AdInv().transpose() * Node(x + dim * k);
    Node(x + dim * k).setZero();
  }
}

template <FrameGroup G>
void Rigid<G>::to_unknowns(const BodyState<G>&, double* h, double* v) const {
  to_first(h);
  to_first(v);
}

template <FrameGroup G>
void Rigid<G>::rates_to_unknowns(const BodyState<G>&, double*, double*, double* vdot) const {
  to_first(vdot);
}

template <FrameGroup G>
std::unique_ptr<Body<G>> Rigid<G>::derivative(const LawDerivative<G>& law) const {
  if (flexible_)
    return std::make_unique<Rigid>(this->name,
                                   std::shared_ptr<const Body<G>>(flexible_->derivative(law)));
  const auto* inertia = std::get_if<Matrix>(&law);
  if (!inertia)
    throw std::invalid_argument("derivative of rigid body '" + this->name +
                                "': expected that of its inertia");
  return std::make_unique<Rigid>(this->name, this->reference[0], *inertia);
}

template class Rigid<SE2>;
template class Rigid<SE3>;

}  // namespace liesl
