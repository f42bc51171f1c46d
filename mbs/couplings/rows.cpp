#include "mbs/couplings/rows.hpp"

#include <cmath>

namespace liesl {

template <FrameGroup G>
typename Row<G>::Cross Row<G>::X(const Vector& v) {
  if constexpr (sd == 2)
    return Vector(-v.y(), v.x());
  else
    return (Cross() << 0, v.z(), -v.y(), -v.z(), 0, v.x(), v.y(), -v.x(), 0).finished();
}

namespace {

/// The one of angle + 2 pi k, k whole, that is closest to `previous`.
double continued(double angle, double previous) {
  return angle + 2 * M_PI * std::round((previous - angle) / (2 * M_PI));
}

}  // namespace

template <FrameGroup G>
double Row<G>::value(const Motion& r, double previous) const {
  return factor_ == 1 ? unscaled_value(r, previous)
                      : factor_ * unscaled_value(r, previous / factor_);
}

template <FrameGroup G>
void Row<G>::gradient(const Motion& r, Gradient& g) const {
  g = unscaled_gradient(r);
  if (factor_ != 1) g *= factor_;
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::hessian(const Motion& r) const {
  return factor_ == 1 ? unscaled_hessian(r) : Hessian(factor_ * unscaled_hessian(r));
}

template <FrameGroup G>
double Row<G>::unscaled_value(const Motion& r, double previous) const {
  switch (kind_) {
    case RowKind::Displacement:
      return m_.dot(r.p);
    case RowKind::Perpendicular:
      return m_.dot(r.R * n_);
    case RowKind::Angle:
      return continued(angle(r), previous);
    case RowKind::Distance:
      return r.p.norm() - rest_;
    case RowKind::Sum: {
      double sum = 0;
      for (const Row& part : parts_) sum += part.value(r, 0);
      return sum;
    }
    case RowKind::Screw:
      break;
  }
  const double displacement = screw_axis_.dot(r.p);
  return displacement - lead_ * continued(angle(r), (displacement - previous) / lead_);
}

template <FrameGroup G>
typename Row<G>::Gradient Row<G>::unscaled_gradient(const Motion& r) const {
  switch (kind_) {
    case RowKind::Displacement:
      return displacement_gradient(r, m_);
    case RowKind::Perpendicular:
      return cosine_gradient(r, m_, n_);
    case RowKind::Angle:
      return angle_gradient(r);
    case RowKind::Distance:
      return distance_gradient(r);
    case RowKind::Sum: {
      Gradient sum = Gradient::Zero(), g;
      for (const Row& part : parts_) {
        part.gradient(r, g);
        sum += g;
      }
      return sum;
    }
    case RowKind::Screw:
      break;
  }
  return displacement_gradient(r, screw_axis_) - lead_ * angle_gradient(r);
}

template <FrameGroup G>
typename Row<G>::Gradient Row<G>::distance_gradient(const Motion& r) {
  const Vector e = r.p / r.p.norm();
  Gradient g;
  g << -e, Angular::Zero(), r.R.transpose() * e, Angular::Zero();
  return g;
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::unscaled_hessian(const Motion& r) const {
  switch (kind_) {
    case RowKind::Displacement:
      return displacement_hessian(r, m_);
    case RowKind::Perpendicular:
      return cosine_hessian(r, m_, n_);
    case RowKind::Angle:
      return angle_hessian(r);
    case RowKind::Distance:
      return distance_hessian(r);
    case RowKind::Sum: {
      Hessian sum = Hessian::Zero();
      for (const Row& part : parts_) sum += part.hessian(r);
      return sum;
    }
    case RowKind::Screw:
      break;
  }
  return displacement_hessian(r, screw_axis_) - lead_ * angle_hessian(r);
}

template <FrameGroup G>
double Row<G>::angle(const Motion& r) const {
  return std::atan2(m_.dot(r.R * n_), m2_.dot(r.R * n2_));
}

template <FrameGroup G>
typename Row<G>::Gradient Row<G>::angle_gradient(const Motion& r) const {
  const double s = m_.dot(r.R * n_), c = m2_.dot(r.R * n2_);
  return (c * cosine_gradient(r, m_, n_) - s * cosine_gradient(r, m2_, n2_)) / (s * s + c * c);
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::angle_hessian(const Motion& r) const {
  const double s = m_.dot(r.R * n_), c = m2_.dot(r.R * n2_), q = s * s + c * c;
  const Gradient gs = cosine_gradient(r, m_, n_), gc = cosine_gradient(r, m2_, n2_);
  const Gradient g = (c * gs - s * gc) / q;
  return (c * cosine_hessian(r, m_, n_) - s * cosine_hessian(r, m2_, n2_) + gs * gc.transpose() -
          gc * gs.transpose() - 2 * g * (s * gs + c * gc).transpose()) /
         q;
}

template <FrameGroup G>
typename Row<G>::Gradient Row<G>::displacement_gradient(const Motion& r, const Vector& m) {
  Gradient g;
  g << -m, X(m).transpose() * r.p, r.R.transpose() * m, Angular::Zero();
  return g;
}

template <FrameGroup G>
typename Row<G>::Gradient Row<G>::cosine_gradient(const Motion& r, const Vector& m,
                                                  const Vector& n) {
  Gradient g;
  g << Vector::Zero(), X(m).transpose() * (r.R * n), Vector::Zero(),
      X(n).transpose() * (r.R.transpose() * m);
  return g;
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::cosine_hessian(const Motion& r, const Vector& m, const Vector& n) {
  const Vector Rn = r.R * n, Rtm = r.R.transpose() * m;
  Hessian h = Hessian::Zero();
  h.template block<rd, rd>(sd, sd) = -X(m).transpose() * X(Rn);
  h.template block<rd, rd>(sd, dim + sd) = X(m).transpose() * r.R * X(n);
  h.template block<rd, rd>(dim + sd, sd) = X(n).transpose() * r.R.transpose() * X(m);
  h.template block<rd, rd>(dim + sd, dim + sd) = -X(n).transpose() * X(Rtm);
  return h;
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::displacement_hessian(const Motion& r, const Vector& m) {
  Hessian h = Hessian::Zero();
  const Cross Xm = X(m);
  h.template block<rd, sd>(sd, 0) = -Xm.transpose();
  h.template block<rd, rd>(sd, sd) = -Xm.transpose() * X(r.p);
  h.template block<rd, sd>(sd, dim) = Xm.transpose() * r.R;
  h.template block<sd, rd>(dim, sd) = r.R.transpose() * Xm;
  h.template block<sd, rd>(dim, dim + sd) = -X(r.R.transpose() * m);
  return h;
}

template <FrameGroup G>
typename Row<G>::Hessian Row<G>::distance_hessian(const Motion& r) const {
  const Gradient g = distance_gradient(r);
  const double l = r.p.norm();
  const Vector pb = r.R.transpose() * r.p;
  Hessian h = Hessian::Zero();
  // -d(p)/l on the rows of u_a, d(R^T p)/l on those of u_b, and the change of 1/l.
  h.template block<sd, sd>(0, 0).setIdentity();
  h.template block<sd, rd>(0, sd) = X(r.p);
  h.template block<sd, sd>(0, dim) = -r.R;
  h.template block<sd, sd>(dim, 0) = -r.R.transpose();
  h.template block<sd, sd>(dim, dim).setIdentity();
  h.template block<sd, rd>(dim, dim + sd) = -X(pb);
  return (h - g * g.transpose()) / l;
}

template class Row<SE2>;
template class Row<SE3>;

}  // namespace liesl
