/// @file
/// The exact tangent of bodies in a floating frame.

#include <array>
#include <cmath>
#include <numbers>

#include "mbs/bodies/floating.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

constexpr int kTerms = 20;        // of the series below: 1e-16 up to 1 rad, 1e-12 at pi
constexpr double kSmall = 1e-18;  // of a term against the sum: the next ones are smaller still

/// B_2m/(2m)! = (-1)^(m+1) 2 zeta(2m)/(2 pi)^2m, m = 1, 2, ...
std::array<double, kTerms> bernoulli_over_factorial() {
  std::array<double, kTerms> c{1. / 12, -1. / 720, 1. / 30240};
  for (int m = 4; m <= kTerms; ++m) {
    double zeta = 0;
    for (int k = 60; k >= 1; --k) zeta += std::pow(k, -2 * m);
    c[m - 1] = (m % 2 ? 2 : -2) * zeta / std::pow(2 * std::numbers::pi, 2 * m);
  }
  return c;
}

/// D_u [D_u [T^-1(u) a] b] by T^-1(u) = I + ad(u)/2 + sum_m B_2m/(2m)! ad(u)^2m, |w| < 2 pi.
template <FrameGroup G>
typename G::Matrix second_dTinv(const typename G::Tangent& u, const typename G::Tangent& a,
                                const typename G::Tangent& b) {
  using Tangent = typename G::Tangent;
  using Matrix = typename G::Matrix;
  static const auto coefficient = bernoulli_over_factorial();
  const Matrix U = G::ad(u), B = G::ad(b);
  // Powers of ad(u) on a, and their derivatives by u: along b, along unit vectors, along both.
  const auto along_units = [](const Tangent& x) -> Matrix { return -G::ad(x); };  // ad(e_j) x
  Tangent x = a, xb = Tangent::Zero();
  Matrix xj = Matrix::Zero(), xjb = Matrix::Zero(), sum = Matrix::Zero();
  for (int k = 1; k <= 2 * kTerms; ++k) {
    xjb = (U * xjb + B * xj + along_units(xb)).eval();
    xj = (U * xj + along_units(x)).eval();
    xb = (U * xb + B * x).eval();
    x = (U * x).eval();
    if (k % 2 == 1) continue;
    const Matrix term = coefficient[k / 2 - 1] * xjb;
    sum += term;
    if (k > 2 && term.cwiseAbs().maxCoeff() < kSmall * sum.cwiseAbs().maxCoeff()) break;
  }
  return sum;
}

/// ad(h)^T f = adT(f) h
template <FrameGroup G>
typename G::Matrix ad_transposed_of(const typename G::Tangent& f) {
  typename G::Matrix A;
  for (int j = 0; j < G::dim; ++j) A.col(j) = G::ad(G::Tangent::Unit(j)).transpose() * f;
  return A;
}

}  // namespace

/// With y = v_i - c, c = Ad(Y^-1) v_0, z = vdot_i - Ad(Y^-1) vdot_0 + ad(y) c as in `measure`, and
/// g = h_i - Ad(Y^-1) h_0 the increment of Y: du = T^-1 g, dc = ad(c) g, dy = -ad(c) g.
template <FrameGroup G>
auto FloatingBody<G>::kinematics(const BodyState<G>& s, const Motion& m) const -> Kinematics {
  using Node = Eigen::Map<const Tangent>;
  using Matrix = typename G::Matrix;
  const int ni = interface_size();
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(ni, dim + ni);
  Kinematics k{zero, zero, zero};
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i), node = dim * interfaces_[i];
    const Matrix back = m.Y[i].AdInv();
    const Tangent u = m.e.template segment<dim>(at), rate = m.rate.template segment<dim>(at);
    const Tangent c = back * Node(s.v), a = back * Node(s.vdot), y = Node(s.v + node) - c;
    const Tangent z = Node(s.vdot + node) - a + G::ad(y) * c;
    const Matrix Ti = G::Tinv(u), Dy = G::dTinv(u, y), ad_c = G::ad(c), ad_y = G::ad(y);
    Matrix along;  // the derivative of T^-1 along the rate
    for (int j = 0; j < dim; ++j) along.col(j) = G::dTinv(u, Tangent::Unit(j)) * rate;
    const Matrix rate_g = Dy * Ti - Ti * ad_c;
    const Matrix by_y = along + rate_g, by_c = Ti * ad_y;
    const auto set = [&](Eigen::MatrixXd& D, const Matrix& own, const Matrix& frame) {
      D.template block<dim, dim>(at, dim + at) = own;
      D.template block<dim, dim>(at, 0) = frame;
    };
    set(k.acceleration_by_v, by_y, (by_c - by_y) * back);
    const Matrix dz = -G::ad(a) + ad_c * ad_c + ad_y * ad_c;
    const Matrix acceleration_g = G::dTinv(u, z) * Ti + Ti * dz + second_dTinv<G>(u, y, rate) * Ti -
                                  along * ad_c + Dy * rate_g;
    set(k.rate, rate_g, -rate_g * back);
    set(k.acceleration, acceleration_g, -acceleration_g * back);
  }
  return k;
}

template <FrameGroup G>
void FloatingBody<G>::add_unknowns_of_acceleration(const Motion& m, const BodyState<G>& s,
                                                   const Eigen::VectorXd& c, double* h, double* v,
                                                   double* vdot) const {
  using Node = Eigen::Map<Tangent>;
  const Kinematics k = kinematics(s, m);
  const int ni = interface_size();
  const Eigen::VectorXd on_h = k.acceleration.transpose() * c.head(ni),
                        on_v = k.acceleration_by_v.transpose() * c.head(ni),
                        on_rates = increments(m).transpose() * c;
  const auto add = [](double* x, int node, const Eigen::VectorXd& share, int at) {
    Node(x + dim * node) += share.template segment<dim>(at);
  };
  for (const auto& [x, share] : {std::pair{h, &on_h}, {v, &on_v}, {vdot, &on_rates}}) {
    add(x, 0, *share, 0);
    for (size_t i = 0; i < interfaces_.size(); ++i)
      add(x, interfaces_[i], *share, dim + dim * static_cast<int>(i));
  }
  for (size_t i = 0; i < slots_.size(); ++i)
    add(vdot, slots_[i], on_rates, dim + ni + dim * static_cast<int>(i));
}

/// Of f = T^-T(u) q on node i and -Ad(Y^-1)^T f on the frame: df = D_u[T^-T(u) q] T^-1(u) g,
/// d(Ad(Y^-1)^T f) = -Ad(Y^-1)^T ad(g)^T f + ...
template <FrameGroup G>
void FloatingBody<G>::add_turning(const Motion& m, const Eigen::VectorXd& q, double weight,
                                  Matrices& A) const {
  using Matrix = typename G::Matrix;
  for (size_t i = 0; i < interfaces_.size(); ++i) {
    const int at = dim * static_cast<int>(i);
    const Tangent u = m.e.template segment<dim>(at), q_i = q.template segment<dim>(at);
    const Matrix Ti = G::Tinv(u), back = m.Y[i].AdInv();
    const Matrix bends = weight * G::dTinvT(u, q_i) * Ti;  // df = bends g
    const Tangent f = weight * Ti.transpose() * q_i;
    const Matrix on_frame = back.transpose() * (ad_transposed_of<G>(f) - bends);
    A.dense.template block<dim, dim>(dim + at, dim + at) += bends;
    A.dense.template block<dim, dim>(dim + at, 0) -= bends * back;
    A.dense.template block<dim, dim>(0, dim + at) += on_frame;
    A.dense.template block<dim, dim>(0, 0) -= on_frame * back;
  }
}

template <FrameGroup G>
auto FloatingBody<G>::linearise(const BodyState<G>& s, const Vector& gravity) const
    -> Linearisation {
  Linearisation at{at_reference(), {}, {}};
  measure(s, true, at.motion);
  at.inertia = inertia_tangents(at.motion, Eigen::Map<const Tangent>(s.v),
                                apparent_acceleration<G>(s, 0, gravity));
  at.by_frames = kinematics(s, at.motion);
  return at;
}

/// r = [f_0; 0] + E^T q with the forces [f_0; q] of inertia, and K_e (e + c edot) in q. Of these
/// d = by_e E + by_frames: what goes by the frames without e reaches those of the body alone.
template <FrameGroup G>
void FloatingBody<G>::set_exact(const BodyState<G>& s, const Vector& gravity,
                                const Linearisation& at, TangentWeights w, Matrices& A) const {
  using Eigen::MatrixXd;
  const Motion& m = at.motion;
  const MatrixXd &M = at.inertia.mass, &C = at.inertia.by_rates;
  const Kinematics& k = at.by_frames;
  const int n = reduced_size(), ni = interface_size(), size = dim + n;
  const double c = this->damping();
  A.dense.setZero(size, size);
  auto by_e = A.dense.rightCols(n);
  if (w.mass != 0) by_e = w.mass * M.rightCols(n);
  if (w.damping != 0) by_e += w.damping * C.rightCols(n);
  if (w.stiffness != 0) by_e += w.stiffness * at.inertia.by_e;
  if (const double stiff = w.stiffness + w.damping * c; stiff != 0)
    by_e.bottomRows(n) += stiff * K_e_;
  MatrixXd by_frames = MatrixXd::Zero(size, dim + ni);
  by_frames.leftCols(dim) = w.mass * M.leftCols(dim) + w.damping * C.leftCols(dim);
  if (w.damping != 0 || w.stiffness != 0)
    by_frames += linalg::product(M.middleCols(dim, ni),
                                 w.damping * k.acceleration_by_v + w.stiffness * k.acceleration);
  if (w.stiffness != 0) {
    by_frames += linalg::product(C.middleCols(dim, ni), w.stiffness * k.rate);
    by_frames.leftCols(dim) += w.stiffness * M.leftCols(dim) * weight_tangent<G>(s.H[0], gravity);
    by_frames.bottomRows(n) += linalg::product(K_e_.leftCols(ni), w.stiffness * c * k.rate);
  }
  add_frames(m, by_frames, A);
  if (w.stiffness != 0) add_turning(m, at.inertia.q + K_e_ * (m.e + c * m.rate), w.stiffness, A);
  for (int j = size - unused_; j < size; ++j) A.dense(j, j) = w.mass + w.stiffness;
}

template <FrameGroup G>
void FloatingBody<G>::exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                                    const Tangent*, Matrices& A) const {
  set_exact(s, gravity, linearise(s, gravity), w, A);
}

template <FrameGroup G>
void FloatingBody<G>::exact_tangents(const BodyState<G>& s, const Vector& gravity, const Tangent*,
                                     Matrices& K, Matrices& C, Matrices& M) const {
  const Linearisation at = linearise(s, gravity);
  set_exact(s, gravity, at, {0, 0, 1}, K);
  set_exact(s, gravity, at, {0, 1, 0}, C);
  set_exact(s, gravity, at, {1, 0, 0}, M);
}

template auto FloatingBody<SE2>::kinematics(const BodyState<SE2>&, const Motion&) const
    -> Kinematics;
template auto FloatingBody<SE3>::kinematics(const BodyState<SE3>&, const Motion&) const
    -> Kinematics;
template void FloatingBody<SE2>::add_unknowns_of_acceleration(const Motion&, const BodyState<SE2>&,
                                                              const Eigen::VectorXd&, double*,
                                                              double*, double*) const;
template void FloatingBody<SE3>::add_unknowns_of_acceleration(const Motion&, const BodyState<SE3>&,
                                                              const Eigen::VectorXd&, double*,
                                                              double*, double*) const;
template void FloatingBody<SE2>::add_turning(const Motion&, const Eigen::VectorXd&, double,
                                             Matrices&) const;
template void FloatingBody<SE3>::add_turning(const Motion&, const Eigen::VectorXd&, double,
                                             Matrices&) const;
template auto FloatingBody<SE2>::linearise(const BodyState<SE2>&, const Vector&) const
    -> Linearisation;
template auto FloatingBody<SE3>::linearise(const BodyState<SE3>&, const Vector&) const
    -> Linearisation;
template void FloatingBody<SE2>::set_exact(const BodyState<SE2>&, const Vector&,
                                           const Linearisation&, TangentWeights, Matrices&) const;
template void FloatingBody<SE3>::set_exact(const BodyState<SE3>&, const Vector&,
                                           const Linearisation&, TangentWeights, Matrices&) const;
template void FloatingBody<SE2>::exact_tangent(const BodyState<SE2>&, const Vector&, TangentWeights,
                                               const Tangent*, Matrices&) const;
template void FloatingBody<SE3>::exact_tangent(const BodyState<SE3>&, const Vector&, TangentWeights,
                                               const Tangent*, Matrices&) const;
template void FloatingBody<SE2>::exact_tangents(const BodyState<SE2>&, const Vector&,
                                                const Tangent*, Matrices&, Matrices&,
                                                Matrices&) const;
template void FloatingBody<SE3>::exact_tangents(const BodyState<SE3>&, const Vector&,
                                                const Tangent*, Matrices&, Matrices&,
                                                Matrices&) const;

}  // namespace liesl
