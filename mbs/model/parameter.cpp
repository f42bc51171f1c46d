#include "mbs/model/parameter.hpp"

#include <stdexcept>

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {
namespace {

const BeamSpec& beam_of(const Mechanism& mechanism, int body) {
  const bool known = body >= 0 && body < static_cast<int>(mechanism.bodies.size());
  const auto* beam = known ? std::get_if<BeamSpec>(&mechanism.bodies[body].kind) : nullptr;
  if (!beam)
    throw std::invalid_argument("parameter of body " + std::to_string(body) +
                                ": expected the number of a beam");
  return *beam;
}

BeamDerivative zero(const BeamSpec& beam, int body) {
  const SectionLaw none{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
  return {body,
          std::vector<SectionLaw>(beam.sections.size(), none),
          std::vector<std::array<SectionLaw, 2>>(beam.ends.size(), {none, none}),
          {}};
}

/// By a constant of the material that K or M_s of every section is proportional to.
BeamDerivative by_constant(const Mechanism& mechanism, int body, double Material::*constant,
                           Eigen::Matrix<double, 6, 6> SectionLaw::*part) {
  const BeamSpec& beam = beam_of(mechanism, body);
  BeamDerivative d = zero(beam, body);
  for (size_t e = 0; e < beam.sections.size(); ++e) {
    const Section& section = beam.sections[e];
    if (std::holds_alternative<FullSection>(section.shape))
      throw std::invalid_argument("beam '" + mechanism.bodies[body].name + "': section '" +
                                  section.name +
                                  "' is given by matrices and does not depend on the material");
    d.laws[e].*part = section_law(section, beam.material).*part / (beam.material.*constant);
    for (std::size_t k = 0; k < 2 && !beam.ends.empty(); ++k)
      d.ends[e][k].*part =
          section_law(beam.ends[e][k], beam.material).*part / (beam.material.*constant);
  }
  return d;
}

}  // namespace

const SectionLaw& BeamDerivative::law_at(std::size_t e, ElementPlace place) const {
  const bool middle = place == ElementPlace::Middle || ends.empty();
  return middle ? laws[e] : ends[e][std::size_t(node_of(place))];
}

BeamDerivative& BeamDerivative::operator+=(const BeamDerivative& other) {
  const auto add = [](SectionLaw& to, const SectionLaw& law) {
    to.K += law.K;
    to.M += law.M;
  };
  for (size_t e = 0; e < laws.size(); ++e) add(laws[e], other.laws[e]);
  for (size_t e = 0; e < ends.size(); ++e)
    for (size_t k = 0; k < 2; ++k) add(ends[e][k], other.ends[e][k]);
  if (stress.empty()) {
    stress = other.stress;
    return *this;
  }
  for (size_t e = 0; e < other.stress.size(); ++e)
    for (size_t k = 0; k < other.stress[e].size(); ++k) stress[e][k] += other.stress[e][k];
  return *this;
}

BeamDerivative by_dimension(const Mechanism& mechanism, int body, const std::vector<int>& elements,
                            std::string_view dimension) {
  const BeamSpec& beam = beam_of(mechanism, body);
  BeamDerivative d = zero(beam, body);
  const int n = static_cast<int>(beam.sections.size());
  std::vector<int> chosen = elements;
  for (int e = 0; elements.empty() && e < n; ++e) chosen.push_back(e);
  for (size_t e = 0; e < beam.sections.size(); ++e)
    d.stress.emplace_back(element_stress_points(beam, e).size(),
                          Eigen::Matrix<double, 3, 6>::Zero());
  for (const int e : chosen) {
    if (e < 0 || e >= n)
      throw std::invalid_argument("beam '" + mechanism.bodies[body].name + "' has no element " +
                                  std::to_string(e) + ", expected 0 .. " + std::to_string(n - 1));
    d.laws[e] = section_law_derivative(beam.sections[e], beam.material, dimension);
    d.stress[e] = element_stress_derivative(beam, std::size_t(e), dimension);
    for (std::size_t k = 0; k < 2 && !beam.ends.empty(); ++k)
      d.ends[e][k] = section_law_derivative(beam.ends[e][k], beam.material, dimension);
  }
  return d;
}

BeamDerivative by_youngs_modulus(const Mechanism& mechanism, int body) {
  return by_constant(mechanism, body, &Material::E, &SectionLaw::K);
}

BeamDerivative by_density(const Mechanism& mechanism, int body) {
  return by_constant(mechanism, body, &Material::rho, &SectionLaw::M);
}

SE3::Matrix generalized_inertia(const RigidSpec& r) {
  const Mat3 c = hat(r.centre);
  SE3::Matrix M;
  M << r.mass * Mat3::Identity(), -r.mass * c, r.mass * c, r.inertia - r.mass * c * c;
  return M;
}

SE3::Matrix generalized_inertia_derivative(const RigidSpec& r, const RigidDerivative& by) {
  const Mat3 c = hat(r.centre), dc = hat(by.centre), dS = by.mass * c + r.mass * dc;
  SE3::Matrix M;
  M << by.mass * Mat3::Identity(), -dS, dS,
      by.inertia - by.mass * c * c - r.mass * (dc * c + c * dc);
  return M;
}

}  // namespace liesl
