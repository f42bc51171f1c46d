/// @file
/// Responses of a beam as a member of a frame or truss: mean stress, Euler load, wall buckling.
/// Each is a row, that follows from the section, times the section force.

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/buckling.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl {

namespace {

double reference_length(const BeamSpec& beam) {
  double length = 0;
  for (std::size_t e = 0; e + 1 < beam.nodes.size(); ++e)
    length += SE3::log(beam.nodes[e].inverse() * beam.nodes[e + 1]).head<3>().norm();
  return length;
}

}  // namespace

template <FrameGroup G>
auto ResponseValues<G>::largest_of_member(const ResponseSpec& r, const State<G>& s) const
    -> MemberAt {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[r.body].kind);
  const Body<G>& body = *model_.bodies[r.body];
  const SectionLaw none{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
  MemberAt largest;
  const auto offer = [&](const MemberAt& at) {
    const bool first = largest.row.isZero(0);
    const double now = at.value, before = largest.value;
    const bool more = r.kind != ResponseKind::AxialStress ? now > before
                      : r.side == Side::Both              ? std::abs(now) > std::abs(before)
                      : r.side == Side::Up                ? first || now > before
                                                          : first || now < before;
    if (more) largest = at;
  };
  const double length = reference_length(beam);
  for (int e = 0; e < body.elements(); ++e)
    for (const auto end : {ElementPlace::First, ElementPlace::Last}) {
      const auto element = static_cast<std::size_t>(e);
      const SectionLaw law = section_law(section_at(beam, element, end), beam.material);
      const auto& points = points_of(r.body)[element];
      const std::size_t half = points.size() / 2;
      const std::size_t first = static_cast<std::size_t>(node_of(end)) * half;
      if (r.kind == ResponseKind::LocalBuckling) {
        const double sigma =
            wall_buckling_stress(law, none, beam.material.E, beam.material.nu, r.factor).value;
        const SE3::Tangent n = section_force_of(body, s, r.body, e, end);
        for (std::size_t i = first; i < first + half; ++i) {
          const SE3::Tangent row = -points[i].S.row(0).transpose() / sigma;
          offer({e, end, end, static_cast<int>(i), row, row.dot(n), n});
        }
        continue;
      }
      const SE3::Tangent n = section_force_of(body, s, r.body, e, ElementPlace::Middle);
      const double by_force = r.kind == ResponseKind::AxialStress
                                  ? points[first].S(0, 0)
                                  : -1 / euler_load(law, none, r.factor * length).value;
      const SE3::Tangent row = by_force * SE3::Tangent::Unit(0);
      offer({e, ElementPlace::Middle, end, static_cast<int>(first), row, row.dot(n), n});
    }
  return largest;
}

template <FrameGroup G>
Eigen::VectorXd ResponseValues<G>::member(const ResponseSpec& r, const State<G>& s) const {
  return Eigen::VectorXd::Constant(1, largest_of_member(r, s).value);
}

template <FrameGroup G>
void ResponseValues<G>::add_member(const ResponseSpec& r, const At& at, Cotangent& out) const {
  const MemberAt largest = largest_of_member(r, at.s);
  if (largest.value == 0) return;
  add_section_force_of(r.body, largest.element, largest.place, largest.row, at, out);
}

/// row . n' + row' . n, ' the explicit derivative by the law.
template <FrameGroup G>
double ResponseValues<G>::member_by(const ResponseSpec& r, const State<G>& s,
                                    const ParameterResidual<G>& parameter) const {
  const MemberAt at = largest_of_member(r, s);
  const Body<G>* body = parameter.body(r.body);
  if (!body || at.value == 0) return 0;
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[r.body].kind);
  const auto e = static_cast<std::size_t>(at.element);
  const SectionLaw law = section_law(section_at(beam, e, at.end), beam.material);
  double sum = at.row.dot(section_force_of(*body, s, r.body, at.element, at.place));
  for (const auto& part : parameter.parameter().parts) {
    const auto* by = std::get_if<BeamDerivative>(&part);
    if (!by || by->body != r.body) continue;
    const bool shape = !by->stress.empty();  // else by the material
    const SectionLaw& by_law = by->law_at(e, at.end);
    if (r.kind == ResponseKind::AxialStress) {
      if (shape) sum += by->stress[e][std::size_t(at.point)](0, 0) * at.n[0];
    } else if (r.kind == ResponseKind::Buckling) {
      const auto load = euler_load(law, by_law, r.factor * reference_length(beam));
      sum += load.derivative / (load.value * load.value) * at.n[0];
    } else {
      auto wall = wall_buckling_stress(law, by_law, beam.material.E, beam.material.nu, r.factor);
      if (!shape) wall.derivative = wall.value * by_law.K(0, 0) / law.K(0, 0);
      sum -= wall.derivative / wall.value * at.value;
      if (shape) sum -= by->stress[e][std::size_t(at.point)].row(0).dot(at.n) / wall.value;
    }
  }
  return sum;
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;

}  // namespace liesl
