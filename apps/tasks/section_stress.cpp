#include "apps/tasks/section_stress.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/model/beam_ends.hpp"

namespace liesl {

SectionStress::SectionStress(const BodySpec& body) {
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  if (!beam) return;
  for (std::size_t e = 0; e < beam->sections.size(); ++e) {
    const std::vector<StressPoint> points = element_stress_points(*beam, e);
    if (points.empty()) {
      ends_.clear();
      return;
    }
    const std::size_t half = points.size() / 2;
    for (const std::size_t first : {std::size_t{0}, half}) {
      auto& fours = ends_.emplace_back();
      for (std::size_t i = 0; i < half; i += Lanes::size) {
        const auto point = [&](std::size_t lane) {
          return &points[first + std::min(i + lane, half - 1)];
        };
        fours.push_back(gather(
            Four<StressPoint>{point(0), point(1), point(2), point(3)},
            [](const StressPoint& p) -> const auto& { return p.S; }));
      }
    }
  }
}

double SectionStress::operator()(std::size_t element, ElementPlace end,
                                 const SE3::Tangent& force) const {
  double largest = 0;
  for (const FourPoints& four : ends_[2 * element + static_cast<std::size_t>(node_of(end))]) {
    Eigen::Matrix<Lanes, 3, 1> s = four.col(0) * force[0];
    for (int k = 1; k < 6; ++k) s += four.col(k) * force[k];
    const Lanes square = s[0] * s[0] + 3 * (s[1] * s[1] + s[2] * s[2]);
    for (int lane = 0; lane < Lanes::size; ++lane) largest = std::max(largest, square[lane]);
  }
  return std::sqrt(largest);
}

}  // namespace liesl
