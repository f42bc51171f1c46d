#pragma once
/// @file
/// A beam body: a chain of geometrically exact two-node elements.

#include "mbs/bodies/beam_element.hpp"
#include "mbs/bodies/body.hpp"

namespace liesl {

/// Section data of one element in the local axes of G: SE(3) [eps_x, gamma_y, gamma_z, kappa_x,
/// kappa_y, kappa_z], SE(2) [eps_x, gamma_y, kappa_z].
template <FrameGroup G>
struct ElementSection {
  typename G::Matrix K, M;
};

template <FrameGroup G>
class Beam final : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;
  using Element = BeamElement<G>;
  using Pair = typename Element::Pair;
  using PairMatrix = typename Element::PairMatrix;

  /// @param nodes reference frames, n + 1  @param sections one an element
  /// @param damping stiffness-proportional, s
  Beam(std::string body_name, std::vector<G> nodes_at_rest,
       const std::vector<ElementSection<G>>& sections, double damping)
      : Body<G>(std::move(body_name), std::move(nodes_at_rest)), damping_(damping) {
    this->M_.resize(this->nodes());
    this->K_.resize(this->nodes());
    for (int e = 0; e + 1 < this->nodes(); ++e) {
      elements_.emplace_back(this->reference[e], this->reference[e + 1], sections[e].K,
                             sections[e].M);
      this->M_.add_element(e, elements_[e].mass());
      this->K_.add_element(e, elements_[e].constant_tangent());
    }
  }

  const Element& element(int e) const { return elements_[e]; }
  int elements() const override { return static_cast<int>(elements_.size()); }
  double damping() const override { return damping_; }

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override {
    Pair acceleration, g;
    const bool heavy = gravity.squaredNorm() > 0;
    acceleration.template tail<dim>() = apparent_acceleration<G>(s, 0, gravity);
    for (int e = 0; e < elements(); ++e) {
      acceleration.template head<dim>() = Tangent(acceleration.template tail<dim>());
      acceleration.template tail<dim>() = apparent_acceleration<G>(s, e + 1, gravity);
      elements_[e].inertia_force(s.v + dim * e, acceleration, g);
      if (heavy) elements_[e].add_weight_curvature(s.H[e], s.H[e + 1], gravity, g);
      Eigen::Map<Pair>(r + dim * e) += g;
      scale.add<G>(g.template head<dim>());
      scale.add<G>(g.template tail<dim>());
    }
  }

  void add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const override {
    Pair g;
    for (int e = 0; e < elements(); ++e) {
      elements_[e].internal_force(s.H[e], s.H[e + 1], s.v + dim * e, damping_, g);
      Eigen::Map<Pair>(r + dim * e) += g;
      scale.add<G>(g.template head<dim>());
    }
  }

  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override {
    A.set_sum(w.mass, this->M_, damping_ * w.damping, this->K_);
    for (int e = 0; e < elements(); ++e) {
      const Tangent n = stress ? stress[e] : section_force(s, e);
      A.add_element(e, elements_[e].tangent(s.H[e], s.H[e + 1], n));
      if (w.damping > 0)
        A.add_element(e, w.damping * elements_[e].gyroscopic_tangent(s.v + dim * e));
    }
    if (gravity.squaredNorm() > 0) add_weight_tangent(s, gravity, A);
  }

  Matrices load_distribution() const override {
    Matrices W(this->nodes());
    for (int e = 0; e < elements(); ++e)
      W.add_element(e, elements_[e].integral(G::Matrix::Identity()));
    return W;
  }

  Tangent strain(const BodyState<G>& s, int e) const override {
    return elements_[e].strain(s.H[e], s.H[e + 1]);
  }
  Tangent section_force(const BodyState<G>& s, int e) const override {
    return elements_[e].section_stiffness() * strain(s, e);
  }

  void extrapolate_stress(const BodyState<G>& s, const double* delta,
                          Tangent* stress) const override {
    for (int e = 0; e < elements(); ++e) {
      const Element& element = elements_[e];
      const Tangent d = G::log(s.H[e].inverse() * s.H[e + 1]);
      const Tangent change = Element::P(d) * Eigen::Map<const Pair>(delta + dim * e);
      stress[e] = element.section_stiffness() * (d - element.d0() + change) / element.length();
    }
  }

  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override {
    BodyEnergy energy;
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(this->size());
    this->M_.multiply_add(s.v, momentum.data());
    energy.kinetic = 0.5 * momentum.dot(Eigen::Map<const Eigen::VectorXd>(s.v, this->size()));
    for (int e = 0; e < elements(); ++e) {
      const Tangent eps = strain(s, e);
      const double L = elements_[e].length(), m = L * elements_[e].section_inertia()(0, 0);
      energy.elastic += 0.5 * L * eps.dot(elements_[e].section_stiffness() * eps);
      const Tangent d = G::log(s.H[e].inverse() * s.H[e + 1]);
      for (double point : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
        energy.potential -= 0.5 * m * gravity.dot((s.H[e] * G::exp(point * d)).x);
    }
    return energy;
  }

  double total_mass() const override {
    double m = 0;
    for (const auto& e : elements_) m += e.length() * e.section_inertia()(0, 0);
    return m;
  }
  double axial_stiffness() const override {
    double k = 0;
    for (const auto& e : elements_) k = std::max(k, e.section_stiffness()(0, 0) / e.length());
    return k;
  }

 private:
  /// A += M D_h(-[R^T g; 0]), block column by block column, and the tangent of the curvature part.
  void add_weight_tangent(const BodyState<G>& s, const Vector& gravity, Matrices& A) const {
    for (int e = 0; e < elements(); ++e)
      A.add_element(e, elements_[e].weight_curvature_tangent(s.H[e], s.H[e + 1], gravity));
    for (int k = 0; k < this->nodes(); ++k) {
      const typename G::Matrix D = weight_tangent<G>(s.H[k], gravity);
      A.D[k] += this->M_.D[k] * D;
      if (k > 0) A.U[k - 1] += this->M_.U[k - 1] * D;
      if (k + 1 < this->nodes()) A.L[k] += this->M_.L[k] * D;
    }
  }

  std::vector<Element, Eigen::aligned_allocator<Element>> elements_;
  double damping_;
};

}  // namespace liesl
