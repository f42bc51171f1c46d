#pragma once
/// @file
/// Forces and energies of a chain of elements of fourth order, four elements at once: the laws and
/// the inertia of the elements over frames of Lanes.

#include <array>
#include <vector>

#include "liegroup/lanes.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/bodies/fourth_order_element.hpp"

namespace liesl {

template <FrameGroup G>
class FourElements {
 public:
  using Element = FourthOrderElement<G>;
  using Vector = typename Body<G>::Vector;
  using Matrices = typename Body<G>::Matrices;

  /// Elements e, ..., e + 3 of a chain, the last one again where there are fewer.
  /// @pre `takes` each
  template <class Elements>
  FourElements(const Elements& elements, int e)
      : FourElements(e, std::min(Lanes::size, static_cast<int>(elements.size()) - e),
                     four(elements, e)) {}
  /// Its law does not couple translation and rotation, and it is no derivative.
  static bool takes(const Element& element) {
    return element.law().uncoupled() && !element.is_derivative();
  }

  /// As `Body` has them, for these elements.
  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const;
  /// @pre no `s.stress`
  void add_internal(const BodyState<G>& s, double damping, double* r, ForceScale& scale) const;
  /// A += w.mass M + w.damping C + w.stiffness K. @param stress by element, or null
  void add_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w, double damping,
                   const typename G::Tangent* stress, Matrices& A) const;
  void add_tangents(const BodyState<G>& s, const Vector& gravity, double damping,
                    const typename G::Tangent* stress, Matrices& K, Matrices& C, Matrices& M) const;
  void add_energy(const BodyState<G>& s, const Vector& gravity, BodyEnergy& energy) const;
  /// @param eps, n of the chain
  void strains(const BodyState<G>& s, typename G::Tangent* eps) const;
  void end_forces(const BodyState<G>& s, std::array<typename G::Tangent, 2>* n) const;

 private:
  static constexpr int dim = G::dim;
  using Frame = typename G::template Over<Lanes>;
  using Elements4 = Four<Element>;
  using Tangent = typename Frame::Tangent;
  using Pair = typename BeamElement<Frame>::Pair;
  using PairMatrix = typename BeamElement<Frame>::PairMatrix;
  using Space = typename Frame::Vector;

  template <class Elements>
  static Elements4 four(const Elements& elements, int e) {
    Elements4 out;
    for (int lane = 0; lane < Lanes::size; ++lane)
      out[lane] = &elements[std::min<std::size_t>(e + lane, elements.size() - 1)];
    return out;
  }
  FourElements(int first, int count, const Elements4& elements);

  /// Element of a lane.
  int at(int lane) const { return first_ + std::min(lane, count_ - 1); }
  /// Frames of the nodes of the elements, `shift` 0 or 1.
  Frame frames(const BodyState<G>& s, int shift) const;
  Pair pairs(const double* x) const;
  Pair apparent(const BodyState<G>& s, const Frame& A, const Frame& B, const Space& gravity) const;
  struct Motion {
    Frame A, B;
    Pair v;
  };
  Motion motion(const BodyState<G>& s) const { return {frames(s, 0), frames(s, 1), pairs(s.v)}; }
  PairMatrix stiffness(const Motion& m, const BodyState<G>& s, const Vector& gravity,
                       double damping, const typename G::Tangent* stress,
                       const PairMatrix& M) const;
  PairMatrix damping_matrix(const Motion& m, double damping) const;
  void add(const PairMatrix& k, Matrices& A) const;
  void add(const Pair& g, double* r) const;
  /// Of all elements of the chain those of these.
  Tangent section_forces(const typename G::Tangent* of_chain) const;
  Tangent strain(const Tangent& d) const { return (d - law_.d0()) / law_.length(); }
  /// Sum over the elements.
  double sum(const Lanes& each) const;

  int first_, count_;
  CondensedLaw<Frame> law_;
  HermiteInertia<Frame> inertia_;
};

extern template class FourElements<SE2>;
extern template class FourElements<SE3>;

}  // namespace liesl
