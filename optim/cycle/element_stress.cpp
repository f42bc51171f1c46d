#include "optim/cycle/element_stress.hpp"

#include <cmath>

#include "mbs/sections/section_law.hpp"
#include "mbs/sections/stress.hpp"

namespace liesl {
namespace {

Vec3 weighted(const Vec3& s) { return {s[0], 3 * s[1], 3 * s[2]}; }

}  // namespace

template <FrameGroup G>
ElementStress<G>::ElementStress(const Section& section, const Material& material,
                                const Space<G>& space, const SE3& align)
    : K_(space.reduce_law(section_law(section, material).K, align)) {
  for (int j = 0; j < G::dim; ++j) embed_.col(j) = space.embed_local(G::Tangent::Unit(j), align);
  for (const auto& point : stress_points(section, material.nu)) {
    S_.push_back(point.S * embed_);
    SK_.push_back(S_.back() * K_);
  }
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
  const Vec3 ds = change.dS[point] * (embed_ * (K_ * strain)) + S_[point] * (change.dK * strain);
  return w.dot(ds) / v;
}

template class ElementStress<SE2>;
template class ElementStress<SE3>;

}  // namespace liesl
