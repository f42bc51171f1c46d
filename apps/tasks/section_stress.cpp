#include "apps/tasks/section_stress.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "mbs/model/beam_ends.hpp"

namespace liesl {

SectionStress::SectionStress(const BodySpec& body) {
  const auto* beam = std::get_if<BeamSpec>(&body.kind);
  if (!beam) return;
  for (std::size_t e = 0; e < beam->sections.size(); ++e) {
    const std::vector<StressPoint> points = element_stress_points(*beam, e);
    if (points.empty()) {
      of_end_.clear();
      return;
    }
    const std::size_t half = points.size() / 2;
    for (const std::size_t first : {std::size_t{0}, half}) {
      std::vector<FourPoints> fours;
      for (std::size_t i = 0; i < half; i += Lanes::size) {
        const auto point = [&](std::size_t lane) {
          return &points[first + std::min(i + lane, half - 1)];
        };
        fours.push_back(gather(
            Four<StressPoint>{point(0), point(1), point(2), point(3)},
            [](const StressPoint& p) -> const auto& { return p.S; }));
      }
      add_end(std::move(fours));
    }
  }
}

void SectionStress::add_end(std::vector<FourPoints> points) {
  const auto same = [&](const std::vector<FourPoints>& others) {
    return others.size() == points.size() &&
           std::memcmp(others.data(), points.data(), points.size() * sizeof(FourPoints)) == 0;
  };
  if (points_.empty() || !same(points_.back())) points_.push_back(std::move(points));
  of_end_.push_back(points_.size() - 1);
}

double SectionStress::operator()(std::size_t element, ElementPlace end,
                                 const SE3::Tangent& force) const {
  double largest = 0;
  const std::size_t at = of_end_[2 * element + static_cast<std::size_t>(node_of(end))];
  for (const FourPoints& four : points_[at]) {
    Eigen::Matrix<Lanes, 3, 1> s = four.col(0) * force[0];
    for (int k = 1; k < 6; ++k)
      if (force[k] != 0) s += four.col(k) * force[k];  // in a plane half of them
    const Lanes square = s[0] * s[0] + 3 * (s[1] * s[1] + s[2] * s[2]);
    for (int lane = 0; lane < Lanes::size; ++lane) largest = std::max(largest, square[lane]);
  }
  return std::sqrt(largest);
}

}  // namespace liesl
