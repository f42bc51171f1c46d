#include "optim/problems/element_stress.hpp"

#include <cmath>

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl {
namespace {

Vec3 weighted(const Vec3& s) { return {s[0], 3 * s[1], 3 * s[2]}; }

}  // namespace

template <FrameGroup G>
auto ElementStress<G>::to_end(const BeamChain<G>& beam, int e, ElementPlace end) -> Matrix {
  const auto P = BeamElement<G>::P(beam.d0(e));
  if (end == ElementPlace::First) return -P.template leftCols<G::dim>().transpose();
  return P.template rightCols<G::dim>().transpose();
}

template <FrameGroup G>
auto ElementStress<G>::strain_of(const BeamChain<G>& beam, int e, ElementPlace end, const Strain& n)
    -> Strain {
  const Strain middle = to_end(beam, e, end).partialPivLu().solve(n);
  return beam.rest_stiffness(e).partialPivLu().solve(middle);
}

template <FrameGroup G>
ElementStress<G>::ElementStress(const BeamChain<G>& beam, int e, const BeamSpec& spec,
                                const Space<G>& space, const SE3& align)
    : K_(beam.rest_stiffness_of(
          e, space.reduce_law(section_law(spec.sections[std::size_t(e)], spec.material).K, align))),
      B_{to_end(beam, e, ElementPlace::First), to_end(beam, e, ElementPlace::Last)} {
  for (int j = 0; j < G::dim; ++j) embed_.col(j) = space.embed_local(G::Tangent::Unit(j), align);
  for (const auto& point : element_stress_points(spec, std::size_t(e)))
    S_.push_back(point.S * embed_);
  for (int i = 0; i < static_cast<int>(S_.size()); ++i)
    SK_.push_back(S_[std::size_t(i)] * B(i) * K_);
}

template <FrameGroup G>
double ElementStress<G>::value(int point, const Strain& strain, Strain* slope) const {
  const Vec3 s = SK_[point] * strain, w = weighted(s);
  const double v = std::sqrt(s.dot(w));
  if (slope) *slope = v > 0 ? Strain(SK_[point].transpose() * w / v) : Strain(Strain::Zero());
  return v;
}

template <FrameGroup G>
double ElementStress<G>::explicit_slope(int point, const Strain& strain,
                                        const Change& change) const {
  const Vec3 s = SK_[point] * strain, w = weighted(s);
  const double v = std::sqrt(s.dot(w));
  if (v == 0) return 0;
  const Strain n = B(point) * (K_ * strain), dn = B(point) * (change.dK * strain);
  const Vec3 ds = change.dS[point] * (embed_ * n) + S_[point] * dn;
  return w.dot(ds) / v;
}

template class ElementStress<SE2>;
template class ElementStress<SE3>;

}  // namespace liesl
