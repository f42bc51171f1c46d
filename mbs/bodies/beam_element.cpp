#include "mbs/bodies/beam_element.hpp"

#include <cmath>

#include "mbs/bodies/body.hpp"

namespace liesl {

template <FrameGroup G>
BeamElement<G>::BeamElement(const G& A, const G& B, const Matrix& K, const Matrix& M_s)
    : d0_(G::log(A.inverse() * B)), L_(d0_.template head<G::space_dim>().norm()), K_(K), M_s_(M_s) {
  for (int i = 0; i < 2; ++i) {
    const double s = 0.5 + (i - 0.5) / std::sqrt(3.0), weight = 0.5 * L_;
    const Gradient q = Q(d0_, s);
    Q_.template middleRows<dim>(dim * i) = q;
    weighted_Qt_.template middleCols<dim>(dim * i) = weight * q.transpose();
    spread_bubble_ += 0.5 * s * (1 - s) * weight * q.transpose().template leftCols<G::space_dim>();
    bubble_ += 0.5 * s * (1 - s) * weight * q.transpose() * M_s_.template leftCols<G::space_dim>();
  }
  mass_ = integral(M_s_);
  const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
  W0_squared_ = W * W;
}

template <FrameGroup G>
auto BeamElement<G>::strain(const G& A, const G& B) const -> Tangent {
  return (G::log(A.inverse() * B) - d0_) / L_;
}

template <FrameGroup G>
auto BeamElement<G>::P(const Tangent& d) -> Gradient {
  Gradient p;
  p << -G::Tinv(-d), G::Tinv(d);
  return p;
}

template <FrameGroup G>
auto BeamElement<G>::internal_force(const G& A, const G& B, const double* v, double damping,
                                    Pair& g, const double* /*about*/) const -> Tangent {
  Tangent n;
  transmit(
      A, B,
      [&](const Tangent& d, const Matrix& Ti) {
        Tangent strain = (d - d0_) / L_;
        if (damping > 0) strain += (damping / L_) * relative_rate(d, Ti, v);
        return n = K_.lazyProduct(strain);
      },
      g);
  return n;
}

template <FrameGroup G>
auto BeamElement<G>::dP(const Tangent& d, const Scalar* v) -> Matrix {
  using Map = Eigen::Map<const Tangent>;
  return G::dTinv(-d, Map(v)) + G::dTinv(d, Map(v + dim));
}

template <FrameGroup G>
auto BeamElement<G>::material_tangent(const G& A, const G& B) const -> PairMatrix {
  const Gradient p = P(G::log(A.inverse() * B));
  return p.transpose() * K_ * p / L_;
}

template <FrameGroup G>
auto BeamElement<G>::constant_tangent() const -> PairMatrix {
  const Gradient p = P(d0_);
  return p.transpose() * K_ * p / L_;
}

template <FrameGroup G>
auto BeamElement<G>::tangent(const G& A, const G& B, const Tangent& n) const -> PairMatrix {
  const Tangent d = G::log(A.inverse() * B);
  const Gradient p = P(d);
  Gradient geometric_A = G::dTinvT(-d, n) * p;  // -T^-T(-d) n: the two signs cancel
  Gradient geometric_B = G::dTinvT(d, n) * p;
  PairMatrix k = p.transpose() * K_ * p / L_;
  k.template topRows<dim>() += geometric_A;
  k.template bottomRows<dim>() += geometric_B;
  return k;
}

template <FrameGroup G>
auto BeamElement<G>::Q(const Tangent& d, double s) -> Gradient {
  const Matrix sT = s * G::T(s * d);
  Gradient q;
  q << G::exp(s * d).AdInv() - sT * G::Tinv(-d), sT * G::Tinv(d);
  return q;
}

template <FrameGroup G>
auto BeamElement<G>::integral(const Matrix& M) const -> PairMatrix {
  PairMatrix m = PairMatrix::Zero();
  const double a = std::sqrt(0.15);
  const double points[] = {0.5 - a, 0.5, 0.5 + a}, weights[] = {5. / 18, 8. / 18, 5. / 18};
  for (int i = 0; i < 3; ++i) {
    const Gradient q = Q(d0_, points[i]);
    m += L_ * weights[i] * q.transpose() * M * q;
  }
  return m;
}

template <FrameGroup G>
void BeamElement<G>::add_weight_curvature(const G& A, const G& B, const Vector& a, Pair& g) const {
  g += curvature(bubble_, A, B, a);
}
template <FrameGroup G>
auto BeamElement<G>::weight_tangent(const G& A, const G& B, const Vector& a) const -> PairMatrix {
  PairMatrix D = PairMatrix::Zero();
  D.template topLeftCorner<dim, dim>() = liesl::weight_tangent<G>(A, a);
  D.template bottomRightCorner<dim, dim>() = liesl::weight_tangent<G>(B, a);
  return mass_ * D + curvature_tangent(bubble_, A, B, a);
}
template <FrameGroup G>
double BeamElement<G>::weight_potential(const G& A, const G& B, const Vector& a) const {
  const Tangent d = G::log(A.inverse() * B);
  double energy = 0;
  for (double s : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
    energy -= 0.5 * L_ * M_s_(0, 0) * a.dot((A * G::exp(s * d)).x);
  return energy;
}
template <FrameGroup G>
auto BeamElement<G>::weight_gradient(const G& A, const G& B, const Vector& a) const -> Pair {
  const Tangent d = G::log(A.inverse() * B);
  Pair g = Pair::Zero();
  for (double s : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
    const G H = A * G::exp(s * d);
    g -= 0.5 * L_ * M_s_(0, 0) * Q(d, s).template topRows<G::space_dim>().transpose() *
         (H.R.transpose() * a);
  }
  return g;
}
template <FrameGroup G>
auto BeamElement<G>::spread_curvature(const G& A, const G& B, const SpreadLoad<G>& load) const
    -> Pair {
  if (load.follower) return Pair::Zero();
  return curvature(spread_bubble_, A, B, load.wrench.template head<G::space_dim>());
}
template <FrameGroup G>
auto BeamElement<G>::spread_curvature_tangent(const G& A, const G& B,
                                              const SpreadLoad<G>& load) const -> PairMatrix {
  if (load.follower) return PairMatrix::Zero();
  return curvature_tangent(spread_bubble_, A, B, load.wrench.template head<G::space_dim>());
}

template <FrameGroup G>
void BeamElement<G>::inertia_force(const G&, const G&, const double* v, const Pair& a,
                                   Pair& g) const {
  const Pair vs = Q_.lazyProduct(Eigen::Map<const Pair>(v));
  Pair f;
  for (int i = 0; i < 2; ++i) {
    const auto vi = vs.template segment<dim>(dim * i);
    f.template segment<dim>(dim * i) = minus_ad_transpose(vi, M_s_.lazyProduct(vi));
  }
  g = mass_.lazyProduct(a);
  g += weighted_Qt_.lazyProduct(f);
}

template <FrameGroup G>
auto BeamElement<G>::gyroscopic_tangent(const G&, const G&, const double* v) const -> PairMatrix {
  const Eigen::Map<const Pair> V(v);
  PairMatrix c = PairMatrix::Zero();
  for (int i = 0; i < 2; ++i) {
    const auto q = Q_.template middleRows<dim>(dim * i);
    c += weighted_Qt_.template middleCols<dim>(dim * i) *
         minus_ad_transpose_derivative(Tangent(q * V), M_s_) * q;
  }
  return c;
}

template <FrameGroup G>
auto BeamElement<G>::minus_ad_transpose(const Tangent& v, const Tangent& p) -> Tangent {
  if constexpr (G::space_dim == 2) {
    return {-v[2] * p[1], v[2] * p[0], v[0] * p[1] - v[1] * p[0]};
  } else {
    Tangent f;
    f << v[4] * p[2] - v[5] * p[1], v[5] * p[0] - v[3] * p[2], v[3] * p[1] - v[4] * p[0],
        v[1] * p[2] - v[2] * p[1] + v[4] * p[5] - v[5] * p[4],
        v[2] * p[0] - v[0] * p[2] + v[5] * p[3] - v[3] * p[5],
        v[0] * p[1] - v[1] * p[0] + v[3] * p[4] - v[4] * p[3];
    return f;
  }
}

template <FrameGroup G>
auto BeamElement<G>::minus_ad_transpose_derivative(const Tangent& v, const Matrix& M) -> Matrix {
  Matrix c = -G::ad(v).transpose() * M;
  const Tangent p = M * v;
  for (int j = 0; j < dim; ++j) c.col(j) -= G::ad(Tangent::Unit(j)).transpose() * p;
  return c;
}

/// bubble (w x (w x m) - its value at reference), m the mean of R^T a at the nodes.
template <FrameGroup G>
auto BeamElement<G>::curvature(const Bubble& bubble, const G& A, const G& B, const Vector& a) const
    -> Pair {
  const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
  const Vector mean = 0.5 * (A.R.transpose() * a + B.R.transpose() * a);
  return bubble * Vector(W * (W * mean) - W0_squared_ * mean);
}

/// D_[h_A; h_B] curvature, column by column: dR = -e~ R or R e~.
template <FrameGroup G>
auto BeamElement<G>::curvature_tangent(const Bubble& bubble, const G& A, const G& B,
                                       const Vector& a) const -> PairMatrix {
  const Rotation R = A.R.transpose() * B.R, W = 0.5 * (R - R.transpose());
  const Vector at_A = A.R.transpose() * a, at_B = B.R.transpose() * a, mean = 0.5 * (at_A + at_B);
  PairMatrix k = PairMatrix::Zero();
  for (int i = G::space_dim; i < dim; ++i) {
    const Rotation e = G::ad(Tangent::Unit(i)).template topLeftCorner<G::space_dim, G::space_dim>();
    const auto column = [&](const Rotation& dR, const Vector& dmean) -> Pair {
      const Rotation dW = 0.5 * (dR - dR.transpose());
      return bubble *
             Vector(dW * (W * mean) + W * (dW * mean) + W * (W * dmean) - W0_squared_ * dmean);
    };
    k.col(i) = column(-e * R, -0.5 * e * at_A);
    k.col(dim + i) = column(R * e, -0.5 * e * at_B);
  }
  return k;
}

template class BeamElement<SE2>;
template class BeamElement<SE3>;
template auto BeamElement<SE2Of<Lanes>>::dP(const Tangent&, const Lanes*) -> Matrix;
template auto BeamElement<SE3Of<Lanes>>::dP(const Tangent&, const Lanes*) -> Matrix;
template auto BeamElement<SE2Of<Lanes>>::minus_ad_transpose(const Tangent&, const Tangent&)
    -> Tangent;
template auto BeamElement<SE3Of<Lanes>>::minus_ad_transpose(const Tangent&, const Tangent&)
    -> Tangent;

}  // namespace liesl
