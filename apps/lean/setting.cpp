#include "apps/lean/setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace liesl {

namespace {

/// Smallest number of elements with a node at every place, out of the divisors of `elements`;
/// `elements` if a place is between their nodes.
int common_multiple(const std::vector<double>& places, int elements) {
  int multiple = 1;
  for (const double place : places) {
    const int node = static_cast<int>(std::lround(place * elements));
    if (std::abs(place * elements - node) > 0.25) return elements;
    multiple = std::lcm(multiple, elements / std::gcd(node, elements));
  }
  return multiple;
}

std::string text_of(SpaceChoice space) {
  return space == SpaceChoice::Planar    ? "planar"
         : space == SpaceChoice::Spatial ? "spatial"
                                         : "auto";
}

}  // namespace

std::string text_of(TangentStrategy tangent) {
  switch (tangent) {
    case TangentStrategy::Auto:
      return "auto";
    case TangentStrategy::Constant:
      return "constant";
    case TangentStrategy::Adaptive:
      return "adaptive";
    case TangentStrategy::Exact:
      return "exact";
  }
  return "";
}

std::vector<double> places(const Scene& scene, int body) {
  const Mechanism& m = scene.mechanism;
  const auto& beam = std::get<BeamSpec>(m.bodies[static_cast<std::size_t>(body)].kind);
  const int n = static_cast<int>(beam.sections.size());
  std::vector<double> found;
  const auto add = [&](const Port& port) {
    if (port.body == body) found.push_back(static_cast<double>(port.node) / n);
  };
  for (const auto& joint : m.joints) add(joint.a), add(joint.b);
  for (const auto& force : m.forces) add(force.a), add(force.b);
  for (const auto& load : m.loads)
    if (!load.spread) add(load.port);
  for (const auto& r : scene.responses) {
    add(r.at);
    if (r.body != body) continue;
    if (r.kind == ResponseKind::Deflection && !r.everywhere) found.push_back(r.s);
    if (r.kind == ResponseKind::SectionForce)
      found.push_back((r.element + (r.place == ElementPlace::Middle ? 0.5 : node_of(r.place))) / n);
  }
  for (int e = 1; e < n; ++e)
    if (beam.sections[static_cast<std::size_t>(e)].name !=
        beam.sections[static_cast<std::size_t>(e) - 1].name)
      found.push_back(static_cast<double>(e) / n);
  return found;
}

Setting Setting::refined(double factor) const {
  Setting s = *this;
  for (auto& beam : s.beams) {
    if (beam.multiple == 0 || beam.rigid) continue;
    const int count = static_cast<int>(factor * beam.elements) / beam.multiple;
    beam.elements = beam.multiple * std::max(1, count);
  }
  if (s.steps > 0) s.steps = std::max(1L, static_cast<long>(factor * static_cast<double>(steps)));
  return s;
}

Setting setting_of(const Scene& scene) {
  Setting s;
  const SimulationOptions& o = scene.simulation;
  s.space = text_of(o.space);
  s.tangent = text_of(o.tangent);
  s.duration = o.duration;
  s.record_every = o.output_every;
  if (o.type == SimulationType::Dynamic)
    s.steps = std::lround(std::ceil(o.duration / o.step * (1 - 1e-12)));
  for (std::size_t b = 0; b < scene.mechanism.bodies.size(); ++b) {
    const BodySpec& body = scene.mechanism.bodies[b];
    const auto* beam = std::get_if<BeamSpec>(&body.kind);
    if (!beam || beam->as == BeamModel::Rigid) continue;
    const int n = static_cast<int>(beam->sections.size());
    const int modes = beam->as == BeamModel::Modal ? beam->modes : -1;
    s.beams.push_back({body.name, false, modes, beam->order, n,
                       common_multiple(places(scene, static_cast<int>(b)), n),
                       beam->as == BeamModel::Segments});
  }
  return s;
}

std::vector<std::string> changes(const Setting& wanted, const Setting& given) {
  std::vector<std::string> list;
  if (wanted.space != given.space)
    list.push_back(fmt::format("simulation.space=\"{}\"", wanted.space));
  for (std::size_t i = 0; i < wanted.beams.size(); ++i) {
    const BeamSetting &to = wanted.beams[i], &from = given.beams[i];
    const std::string key = "bodies." + to.name + ".beam.";
    if (to.elements != from.elements)
      list.push_back(fmt::format("{}elements={}", key, to.elements));
    if (to.elements != from.elements && to.numbering > 0)
      list.push_back(fmt::format("{}numbering={}", key, to.numbering));
    if (to.order != from.order) list.push_back(fmt::format("{}order={}", key, to.order));
    if (to.rigid && !from.rigid) list.push_back(key + "as=\"rigid\"");
    if (to.segments && !from.segments) list.push_back(key + "as=\"segments\"");
    if (to.modes != from.modes) {
      list.push_back(key + "as=\"modal\"");
      list.push_back(fmt::format("{}modes={}", key, to.modes));
    }
  }
  // Twelve digits: 7.5e-05 and not 7.500000000000001e-05; the solver rounds to whole steps.
  if (wanted.steps != given.steps)
    list.push_back(
        fmt::format("simulation.step={}", std::stod(fmt::format("{:.12g}", wanted.step()))));
  if (wanted.record_every != given.record_every)
    list.push_back(fmt::format("simulation.output_every={}", wanted.record_every));
  if (wanted.tangent != given.tangent)
    list.push_back(fmt::format("simulation.tangent=\"{}\"", wanted.tangent));
  return list;
}

}  // namespace liesl
