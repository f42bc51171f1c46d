/// @file
/// Responses of a beam as a member of a frame or truss: mean stress, Euler load, wall buckling.
/// Each is a row, that follows from the section, times the section force.

#include <span>

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

/// Whether `now` is worse than `before`, which has no row at first.
template <class Place>
bool more(const ResponseSpec& r, const Place& before, const Place& now) {
  if (r.kind != ResponseKind::AxialStress) return now.value > before.value;
  if (r.side == Side::Both) return std::abs(now.value) > std::abs(before.value);
  if (before.row.isZero(0)) return true;
  return r.side == Side::Up ? now.value > before.value : now.value < before.value;
}

}  // namespace

/// The row at a stress point of the end of an element. @param length of the beam, for its Euler
/// load
template <FrameGroup G>
SE3::Tangent ResponseValues<G>::row_of_member(const ResponseSpec& r, int element, ElementPlace end,
                                              int point, double length) const {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[r.body].kind);
  const auto e = static_cast<std::size_t>(element), i = static_cast<std::size_t>(point);
  const auto& points = points_of(r.body)[e];
  if (r.kind == ResponseKind::AxialStress) return points[i].S(0, 0) * SE3::Tangent::Unit(0);
  const SectionLaw none{Eigen::Matrix<double, 6, 6>::Zero(), Eigen::Matrix<double, 6, 6>::Zero()};
  const Section& section = section_at(beam, e, end);
  const SectionLaw law = section_law(section, beam.material);
  if (r.kind == ResponseKind::Buckling)
    return -1 / euler_load(law, none, r.factor * length).value * SE3::Tangent::Unit(0);
  const std::size_t half = points.size() / 2, first = half * std::size_t(node_of(end));
  const WalledSection walled{section, law, none, std::span(points).subspan(first, half), {}};
  return -points[i].S.row(0).transpose() /
         wall_buckling_stress(walled, i - first, beam.material, r.factor).value;
}

template <FrameGroup G>
auto ResponseValues<G>::largest_of_member(const ResponseSpec& r, const State<G>& s) const
    -> MemberAt {
  const double length = reference_length(std::get<BeamSpec>(mechanism_.bodies[r.body].kind));
  const auto forces = end_force(r.body).all(*model_.bodies[r.body], model_.body_state(s, r.body));
  MemberAt largest;
  for (std::size_t e = 0; e < forces.size(); ++e)
    for (const auto end : {ElementPlace::First, ElementPlace::Last}) {
      const auto element = static_cast<int>(e);
      const SE3::Tangent n = view_.local(forces[e][static_cast<std::size_t>(node_of(end))], r.body,
                                         element + node_of(end));
      const int half = static_cast<int>(points_of(r.body)[e].size()) / 2;
      const int first = node_of(end) * half;
      const int last = r.kind == ResponseKind::LocalBuckling ? first + half : first + 1;
      for (int i = first; i < last; ++i) {
        MemberAt at{element, end, i, row_of_member(r, element, end, i, length), n};
        at.value = at.row.dot(at.n);
        if (more(r, largest, at)) largest = at;
      }
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
  add_section_force_of(r.body, largest.element, largest.end, largest.row, at, out);
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
  const Section& section = section_at(beam, e, at.end);
  const SectionLaw law = section_law(section, beam.material);
  double sum = at.row.dot(section_force_of(*body, s, r.body, at.element, at.end));
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
      const auto& points = points_of(r.body)[e];
      const std::size_t half = points.size() / 2, first = half * std::size_t(node_of(at.end));
      const auto by_points = shape ? std::span(by->stress[e]).subspan(first, half)
                                   : std::span<const Eigen::Matrix<double, 3, 6>>();
      auto wall = wall_buckling_stress(
          {section, law, by_law, std::span(points).subspan(first, half), by_points},
          std::size_t(at.point) - first, beam.material, r.factor);
      if (!shape) wall.derivative = wall.value * by_law.K(0, 0) / law.K(0, 0);
      sum -= wall.derivative / wall.value * at.value;
      if (shape) sum -= by->stress[e][std::size_t(at.point)].row(0).dot(at.n) / wall.value;
    }
  }
  return sum;
}

/// row . n of the neighbour.
template <FrameGroup G>
double ResponseValues<G>::member_of_neighbour(const ResponseSpec& r, const State<G>& s,
                                              const ResponseValues& neighbour,
                                              const State<G>& seen) const {
  const MemberAt at = largest_of_member(r, s);
  if (at.value == 0) return 0;
  const double length =
      reference_length(std::get<BeamSpec>(neighbour.mechanism_.bodies[r.body].kind));
  return neighbour.row_of_member(r, at.element, at.end, at.point, length)
      .dot(neighbour.section_force_of(*neighbour.model_.bodies[r.body], seen, r.body, at.element,
                                      at.end));
}

template class ResponseValues<SE2>;
template class ResponseValues<SE3>;

}  // namespace liesl
