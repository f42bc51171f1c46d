#include "optim/design/sizing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <stdexcept>

#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"

namespace liesl {
namespace {

const BeamSpec& beam_of(const Mechanism& mechanism, int body) {
  const auto* beam = std::get_if<BeamSpec>(&mechanism.bodies.at(body).kind);
  if (!beam)
    throw std::invalid_argument(
        fmt::format("design: '{}' is rigid; expected a beam", mechanism.bodies[body].name));
  return *beam;
}

/// Elements [first, last) of group g of `groups`, as even as possible.
std::pair<int, int> group_range(int g, int groups, int elements) {
  return {g * elements / groups, (g + 1) * elements / groups};
}

double start_value(const DesignSpec& spec, const Section& section, int group) {
  if (spec.start.empty()) return dimension(section.shape, spec.properties.front());
  return spec.start.size() == 1 ? spec.start[0] : spec.start.at(group);
}

SectionLaw scaled_sum(const SectionLaw& a, double f, const SectionLaw& b) {
  return {a.K + f * b.K, a.M + f * b.M};
}

}  // namespace

Sizing::Sizing(const std::vector<DesignSpec>& design, const Mechanism& mechanism) {
  for (const auto& spec : design) {
    for (int g = 0; g < spec.groups; ++g) {
      NlpVariable v;
      v.name = spec.groups == 1 ? spec.name : fmt::format("{}[{}]", spec.name, g);
      const bool narrow = !spec.group_bounds.empty();
      v.lower = narrow ? spec.group_bounds.at(g)[0] : spec.lower;
      v.upper = narrow ? spec.group_bounds.at(g)[1] : spec.upper;
      std::vector<SizedElement> at;
      for (const int body : spec.bodies) {
        const auto& beam = beam_of(mechanism, body);
        const int n = static_cast<int>(beam.sections.size());
        if (spec.groups > n)
          throw std::invalid_argument(
              fmt::format("design '{}': {} groups on the {} elements of '{}'", spec.name,
                          spec.groups, n, mechanism.bodies[body].name));
        const auto [first, last] = group_range(g, spec.groups, n);
        for (int e = first; e < last; ++e) at.push_back({body, e});
        if (body == spec.bodies.front()) v.start = start_value(spec, beam.sections[first], g);
      }
      variables_.push_back(v);
      units_.emplace_back("m");
      elements_.push_back(at);
      dimensions_.push_back(spec.properties);
    }
  }
}

void Sizing::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  for (int i = 0; i < size(); ++i)
    for (const auto& at : elements_[i]) {
      BeamSpec& beam = std::get<BeamSpec>(mechanism.bodies[at.body].kind);
      std::vector<Section*> sections = {&beam.sections[at.element]};
      if (!beam.ends.empty())
        for (Section& end : beam.ends[at.element]) sections.push_back(&end);
      for (Section* section : sections)
        for (const auto& name : dimensions_[i])
          section->shape = with_dimension(section->shape, name, x[i]);
    }
}

SectionLaw Sizing::derivative(const Mechanism& mechanism, int i, SizedElement at) const {
  const auto& beam = beam_of(mechanism, at.body);
  SectionLaw sum{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
  for (const auto& name : dimensions_[i])
    sum =
        scaled_sum(sum, 1, section_law_derivative(beam.sections[at.element], beam.material, name));
  return sum;
}

Parameter Sizing::parameter(const Mechanism& mechanism, int i) const {
  std::map<int, std::vector<int>> of_body;
  for (const auto& at : elements_[i]) of_body[at.body].push_back(at.element);
  Parameter p{variables_[i].name, {}};
  for (const auto& [body, elements] : of_body) {
    BeamDerivative sum = by_dimension(mechanism, body, elements, dimensions_[i].front());
    for (std::size_t d = 1; d < dimensions_[i].size(); ++d)
      sum += by_dimension(mechanism, body, elements, dimensions_[i][d]);
    p.parts.emplace_back(std::move(sum));
  }
  return p;
}

std::vector<Parameter> Sizing::parameters(const Mechanism& designed, const Eigen::VectorXd&) const {
  std::vector<Parameter> all;
  for (int i = 0; i < size(); ++i) all.push_back(parameter(designed, i));
  return all;
}

SectionLaw Sizing::second_derivative(const Mechanism& mechanism, int i, int j,
                                     SizedElement at) const {
  const auto& beam = beam_of(mechanism, at.body);
  const double h = 1e-5 * dimension(beam.sections[at.element].shape, dimensions_[j].front());
  const auto at_step = [&](double step) {
    Section section = beam.sections[at.element];
    for (const auto& name : dimensions_[j])
      section.shape = with_dimension(section.shape, name, dimension(section.shape, name) + step);
    SectionLaw sum{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
    for (const auto& name : dimensions_[i])
      sum = scaled_sum(sum, 1, section_law_derivative(section, beam.material, name));
    return sum;
  };
  const SectionLaw plus = at_step(h), minus = at_step(-h);
  return {(plus.K - minus.K) / (2 * h), (plus.M - minus.M) / (2 * h)};
}

double element_length(const BeamSpec& beam, int e) {
  return SE3::log(beam.nodes[e].inverse() * beam.nodes[e + 1]).head<3>().norm();
}

double mass_of(const Mechanism& mechanism, const std::vector<int>& bodies) {
  double mass = 0;
  for (const int b : bodies) {
    if (const auto* rigid = std::get_if<RigidSpec>(&mechanism.bodies[b].kind)) {
      mass += rigid->mass;
      continue;
    }
    if (const auto* solid = std::get_if<SolidSpec>(&mechanism.bodies[b].kind)) {
      mass += solid->model->total_mass(solid_fractions(*solid).value);
      continue;
    }
    const auto& beam = std::get<BeamSpec>(mechanism.bodies[b].kind);
    for (size_t e = 0; e < beam.sections.size(); ++e)
      mass += section_law(beam.sections[e], beam.material).M(0, 0) *
              element_length(beam, static_cast<int>(e));
  }
  return mass;
}

}  // namespace liesl
