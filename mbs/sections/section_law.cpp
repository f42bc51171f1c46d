#include "mbs/sections/section_law.hpp"

#include "mbs/sections/dual_geometry.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

using Diagonal = Eigen::Matrix<double, 6, 1>;

/// The section law with each entry replaced by one `part` of its dual number:
/// &Dual2::v, &Dual2::d or &Dual2::dd.
SectionLaw part_of_law(const DualGeometry& g, const Material& m, double Dual2::*part) {
  const Dual2 kAy = g.ky * g.A, kAz = g.kz * g.A, polar = g.Iy + g.Iz;
  Diagonal K, M;
  K << m.E * g.A.*part, m.G() * kAy.*part, m.G() * kAz.*part, m.G() * g.J.*part, m.E * g.Iy.*part,
      m.E * g.Iz.*part;
  M << g.A.*part, g.A.*part, g.A.*part, polar.*part, g.Iy.*part, g.Iz.*part;
  return {K.asDiagonal(), (m.rho * M).asDiagonal()};
}

SectionLaw derivative(const Section& section, const Material& material, std::string_view name,
                      double Dual2::*part) {
  const int variable = dimension_index(section.shape, name);
  return part_of_law(dual_geometry(section, material.nu, variable), material, part);
}

}  // namespace

SectionGeometry geometry(const Section& section, double nu) {
  const DualGeometry g = dual_geometry(section, nu, -1);
  return {g.A.v, g.Iy.v, g.Iz.v, g.J.v, g.ky.v, g.kz.v};
}

SectionLaw section_law(const Section& section, const Material& material) {
  if (const auto* full = std::get_if<FullSection>(&section.shape))
    return {full->stiffness, full->inertia};
  return part_of_law(dual_geometry(section, material.nu, -1), material, &Dual2::v);
}

SectionLaw section_law_derivative(const Section& section, const Material& material,
                                  std::string_view dimension) {
  return derivative(section, material, dimension, &Dual2::d);
}

SectionLaw section_law_second_derivative(const Section& section, const Material& material,
                                         std::string_view dimension) {
  return derivative(section, material, dimension, &Dual2::dd);
}

}  // namespace liesl
