#pragma once
/// @file
/// A beam body: a chain of geometrically exact two-node elements.

#include "mbs/bodies/beam_element.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/bodies/four_elements.hpp"
#include "mbs/bodies/fourth_order_element.hpp"
#include "mbs/bodies/reissner_element.hpp"

namespace liesl {

/// What the linear problem of a beam at rest needs of its elements, whatever their order: strains
/// P(d0) [u_A; u_B] / L, and section forces by a stiffness that follows from that of the section.
template <FrameGroup G>
class BeamChain : public Body<G> {
 public:
  using Body<G>::Body;
  using typename Body<G>::Tangent;
  using Matrix = typename G::Matrix;
  using PairMatrix = Eigen::Matrix<double, 2 * G::dim, 2 * G::dim>;

  /// The body as a chain of beam elements, null if it is none.
  static const BeamChain* of(const Body<G>& body) { return dynamic_cast<const BeamChain*>(&body); }
  std::pair<int, int> nodes_of(int e) const final { return {e, 2}; }
  virtual const Tangent& d0(int e) const = 0;
  virtual double length(int e) const = 0;  ///< m
  /// Stiffness at rest, over [u_A; u_B].
  virtual PairMatrix constant_tangent(int e) const = 0;
  /// n = C (P(d0) u / L): C, C for a section stiffness K in its place, and dC/dx for dK/dx.
  virtual const Matrix& rest_stiffness(int e) const = 0;
  virtual Matrix rest_stiffness_of(int e, const Matrix& K) const = 0;
  virtual Matrix rest_stiffness_by(int e, const Matrix& K, const Matrix& dK) const = 0;
  /// d2C/dx dy for K, its derivatives by x and y, and by both.
  virtual Matrix rest_stiffness_second(int e, const Matrix& K, const Matrix& K_x, const Matrix& K_y,
                                       const Matrix& K_xy) const = 0;
};

/// @tparam E the element: BeamElement, FourthOrderElement or ReissnerElement
template <FrameGroup G, class E>
class ChainBeam final : public BeamChain<G> {
 public:
  using Body<G>::dim;
  using typename BeamChain<G>::Matrix;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;
  using Element = E;
  using Pair = typename Element::Pair;
  using typename BeamChain<G>::PairMatrix;

  /// @param nodes reference frames, n + 1  @param sections one an element
  /// @param damping stiffness-proportional, s
  ChainBeam(std::string body_name, std::vector<G> nodes_at_rest,
            const std::vector<ElementSection<G>>& sections, double damping);

  const Element& element(int e) const { return elements_[slot_[e]]; }
  int elements() const override { return static_cast<int>(slot_.size()); }
  const Tangent& d0(int e) const override { return element(e).d0(); }
  double length(int e) const override { return element(e).length(); }
  PairMatrix constant_tangent(int e) const override { return element(e).constant_tangent(); }
  const Matrix& rest_stiffness(int e) const override { return element(e).stiffness_at_rest(); }
  Matrix rest_stiffness_of(int e, const Matrix& K) const override;
  Matrix rest_stiffness_by(int e, const Matrix& K, const Matrix& dK) const override;
  Matrix rest_stiffness_second(int e, const Matrix& K, const Matrix& K_x, const Matrix& K_y,
                               const Matrix& K_xy) const override;
  double damping() const override { return damping_; }

  // What each element runs through in a step: with all calls inlined 5 % fewer instructions.
  [[gnu::flatten]] void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                                    ForceScale& scale) const override;
  [[gnu::flatten]] void add_internal(const BodyState<G>& s, double* r,
                                     ForceScale& scale) const override;
  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  void exact_tangents(const BodyState<G>& s, const Vector& gravity, const Tangent* stress,
                      Matrices& K, Matrices& C, Matrices& M) const override;
  Matrices load_distribution() const override;
  typename Body<G>::Strains strains_at_rest(const Eigen::VectorXd& u) const override;
  void add_spread_curvature(const BodyState<G>& s, const SpreadLoad<G>& load,
                            double* r) const override;
  void add_spread_curvature_tangent(const BodyState<G>& s, const SpreadLoad<G>& load,
                                    Matrices& A) const override;
  void add_spread_derivative(const BodyState<G>& s, const SpreadLoad<G>& load,
                             double* r) const override;
  Tangent strain(const BodyState<G>& s, int e) const override;
  Tangent section_force(const BodyState<G>& s, int e, ElementPlace at) const override;
  std::array<Tangent, 2> end_forces(const BodyState<G>& s, int e) const override;
  void all_strains(const BodyState<G>& s, Tangent* eps) const override;
  void all_end_forces(const BodyState<G>& s, std::array<Tangent, 2>* n) const override;
  void extrapolate_stress(const BodyState<G>& s, const double* delta,
                          Tangent* stress) const override;
  BodyEnergy energy(const BodyState<G>& s, const Vector& gravity) const override;
  /// sum of c L (d eps/dt)^T K (d eps/dt), of fourth order of c L (dn/dt)^T F (dn/dt)
  double dissipation(const BodyState<G>& s) const override;
  double total_mass() const override;
  double axial_stiffness() const override;
  std::unique_ptr<Body<G>> derivative(const LawDerivative<G>& law) const override;
  void add_section_force_gradient(const BodyState<G>& s, int e, ElementPlace at, const Tangent& f,
                                  double* h) const override;
  void add_energy_gradient(const BodyState<G>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;

 private:
  /// The body whose elements are the derivatives of those of `of`.
  ChainBeam(const ChainBeam& of, const std::vector<ElementSection<G>>& derivative);
  void assemble_constant_matrices();
  void group_elements();

  /// Those without a law, of which a derivative by a section has many, share one.
  std::vector<Element, Eigen::aligned_allocator<Element>> elements_;
  std::vector<int> slot_;    ///< by element of the chain: in elements_
  std::vector<int> acting_;  ///< elements with a law: in a derivative by a section, those it is of
  std::vector<FourElements<G>> groups_;  ///< of all elements, or none
  double damping_;
};

/// The beams of the Lie group formalism, of second and fourth order, and that of the classical
/// ones.
template <FrameGroup G>
using Beam = ChainBeam<G, BeamElement<G>>;
template <FrameGroup G>
using FourthOrderBeam = ChainBeam<G, FourthOrderElement<G>>;
template <FrameGroup G>
using ReissnerBeam = ChainBeam<G, ReissnerElement<G>>;

extern template class ChainBeam<SE2, BeamElement<SE2>>;
extern template class ChainBeam<SE3, BeamElement<SE3>>;
extern template class ChainBeam<SE2, FourthOrderElement<SE2>>;
extern template class ChainBeam<SE3, FourthOrderElement<SE3>>;
extern template class ChainBeam<SE2, ReissnerElement<SE2>>;
extern template class ChainBeam<SE3, ReissnerElement<SE3>>;

}  // namespace liesl
