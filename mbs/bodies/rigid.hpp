#pragma once
/// @file
/// Rigid body: M vdot - ad(v)^T M v = g, in the frame of its origin.

#include "mbs/bodies/beam_element.hpp"
#include "mbs/bodies/body.hpp"

namespace liesl {

template <FrameGroup G>
class Rigid final : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;

  /// @param inertia generalized inertia about the origin of the frame, conjugate to [u; w]
  /// @param centre of mass in the body frame
  Rigid(std::string body_name, const G& frame, const typename G::Matrix& inertia,
        const Vector& centre)
      : Body<G>(std::move(body_name), {frame}), centre_(centre) {
    this->M_.resize(1);
    this->K_.resize(1);
    this->M_.D[0] = inertia;
  }

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override {
    const Tangent v = Eigen::Map<const Tangent>(s.v);
    const auto& M = this->M_.D[0];
    const Tangent f =
        M * apparent_acceleration<G>(s, 0, gravity) + BeamElement<G>::minus_ad_transpose(v, M * v);
    Eigen::Map<Tangent>{r} += f;
    scale.add<G>(f);
  }

  void add_internal(const BodyState<G>&, double*, ForceScale&) const override {}

  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w, const Tangent*,
                     Matrices& A) const override {
    const auto& M = this->M_.D[0];
    A.D[0] = w.mass * M;
    if (w.damping > 0)
      A.D[0] += w.damping *
                BeamElement<G>::minus_ad_transpose_derivative(Eigen::Map<const Tangent>(s.v), M);
    A.D[0] += M * weight_tangent<G>(s.H[0], gravity);
  }

  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override {
    const Eigen::Map<const Tangent> v(s.v);
    const auto& M = this->M_.D[0];
    return {0.5 * v.dot(M * v), 0, -total_mass() * gravity.dot(s.H[0].x + s.H[0].R * centre_)};
  }

  double total_mass() const override { return this->M_.D[0](0, 0); }

 private:
  Vector centre_;
};

}  // namespace liesl
