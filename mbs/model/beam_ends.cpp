#include "mbs/model/beam_ends.hpp"

#include <algorithm>

#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {
namespace {

/// What `of` makes of both ends, one after the other.
template <class Of>
auto at_both_ends(const BeamSpec& beam, std::size_t e, Of of) {
  auto out = of(section_at(beam, e, ElementPlace::First));
  const auto last = beam.ends.empty() ? out : of(section_at(beam, e, ElementPlace::Last));
  out.insert(out.end(), last.begin(), last.end());
  return out;
}

}  // namespace

const Section& section_at(const BeamSpec& beam, std::size_t e, ElementPlace place) {
  const bool middle = place == ElementPlace::Middle || beam.ends.empty();
  return middle ? beam.sections[e] : beam.ends[e][std::size_t(node_of(place))];
}

bool tapers(const BeamSpec& beam, std::string_view name) {
  return std::any_of(beam.ends.begin(), beam.ends.end(), [name](const auto& ends) {
    return dimension(ends[0].shape, name) != dimension(ends[1].shape, name);
  });
}

bool tapers(const BeamSpec& beam) {
  if (beam.ends.empty()) return false;
  const auto names = dimensions(beam.sections.front().shape);
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return tapers(beam, name); });
}

std::vector<StressPoint> element_stress_points(const BeamSpec& beam, std::size_t e) {
  return at_both_ends(
      beam, e, [&](const Section& section) { return stress_points(section, beam.material.nu); });
}

std::vector<Eigen::Matrix<double, 3, 6>> element_stress_derivative(const BeamSpec& beam,
                                                                   std::size_t e,
                                                                   std::string_view dimension) {
  return at_both_ends(beam, e, [&](const Section& section) {
    return stress_points_derivative(section, beam.material.nu, dimension);
  });
}

}  // namespace liesl
