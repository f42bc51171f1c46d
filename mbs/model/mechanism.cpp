/// @file
/// Lookup of bodies and ports by text.

#include "mbs/model/mechanism.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <stdexcept>

namespace liesl {

namespace {

/// Number of elements; -1 for a beam without nodes, which has no ports.
int elements(const BeamSpec& beam) { return int(beam.nodes.size()) - 1; }

std::optional<Port> port_of(int body, const BeamSpec& beam, std::string_view name) {
  const int n = elements(beam);
  if (n < 0) return {};
  if (name == "start") return Port{body, 0};
  if (name == "end") return Port{body, n};
  if (name == "mid" && n % 2 == 0) return Port{body, n / 2};
  for (int k = 0; k <= n; ++k)
    if (name == fmt::format("node{}", k)) return Port{body, k};
  for (const auto& [point, place] : beam.points)
    if (name == point && place.node >= 0 && place.node <= n) {
      const SE3& H = beam.nodes[std::size_t(place.node)];
      return Port{body, place.node, SE3(Mat3::Identity(), H.R.transpose() * (place.at - H.x))};
    }
  return {};
}

/// The offset of a named point: R^T (p - x), with the orientation of the body.
std::optional<Port> port_of(int body, const RigidSpec& rigid, std::string_view name) {
  if (name == "origin") return Port{body, 0};
  for (const auto& [point, p] : rigid.points)
    if (name == point)
      return Port{body, 0, SE3(Mat3::Identity(), rigid.frame.R.transpose() * (p - rigid.frame.x))};
  return {};
}

std::optional<Port> port_of(int body, const SolidSpec& solid, std::string_view name) {
  for (std::size_t k = 0; k < solid.interfaces().size(); ++k)
    if (solid.interfaces()[k].name == name) return Port{body, int(k)};
  return {};
}

std::vector<std::string> names_of(const BeamSpec& beam) {
  const int n = elements(beam);
  if (n < 0) return {};
  std::vector<std::string> names = {"start", "end"};
  if (n % 2 == 0) names.push_back("mid");
  for (int k = 0; k <= n; ++k) names.push_back(fmt::format("node{}", k));
  for (const auto& [point, place] : beam.points) names.push_back(point);
  return names;
}

std::vector<std::string> names_of(const RigidSpec& rigid) {
  std::vector<std::string> names = {"origin"};
  for (const auto& [point, p] : rigid.points)
    if (point != "origin") names.push_back(point);
  return names;
}

std::vector<std::string> names_of(const SolidSpec& solid) {
  std::vector<std::string> names;
  for (const Interface& interface : solid.interfaces()) names.push_back(interface.name);
  return names;
}

[[noreturn]] void no_such(std::string_view what, int got, std::size_t count) {
  throw std::invalid_argument(
      fmt::format("mechanism: expected a {} from 0 to {}, got {}", what, int(count) - 1, got));
}

}  // namespace

BeamModel model_of(const BeamSpec& beam, Formalism formalism) {
  if (beam.as != BeamModel::AsFormalism) return beam.as;
  if (formalism == Formalism::Rigid) return BeamModel::Rigid;
  if (formalism == Formalism::Floating) return BeamModel::Modal;
  return formalism == Formalism::Segments ? BeamModel::Segments : BeamModel::AsFormalism;
}

bool moves_rigidly(const BodySpec& body, Formalism formalism) {
  if (const auto* beam = std::get_if<BeamSpec>(&body.kind))
    return model_of(*beam, formalism) == BeamModel::Rigid;
  const auto* part = std::get_if<SolidSpec>(&body.kind);
  if (!part || formalism == Formalism::Rigid) return true;
  return part->as == SolidMotion::Reduced && part->modes == 0 && part->interfaces().size() == 1;
}

NodeUpdate update_of(NodeUpdate chosen, Formalism formalism) {
  if (chosen != NodeUpdate::AsFormalism) return chosen;
  if (formalism == Formalism::R3SO3) return NodeUpdate::R3SO3;
  return formalism == Formalism::Classical ? NodeUpdate::RotationVector : NodeUpdate::Screw;
}

const char* to_string(Formalism formalism) {
  switch (formalism) {
    case Formalism::SE3:
      return "se3";
    case Formalism::R3SO3:
      return "r3so3";
    case Formalism::Classical:
      return "classical";
    case Formalism::Floating:
      return "floating";
    case Formalism::Rigid:
      return "rigid";
    case Formalism::Segments:
      return "segments";
  }
  return "";
}

const char* to_string(ConstraintForm form) {
  switch (form) {
    case ConstraintForm::Multipliers:
      return "multipliers";
    case ConstraintForm::Penalty:
      return "penalty";
    case ConstraintForm::Augmented:
      return "augmented";
  }
  return "";
}

int Mechanism::body(std::string_view text) const {
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].name == text) return int(i);
  return -1;
}

std::optional<Port> Mechanism::port(std::string_view text) const {
  if (text == "ground") return Port{};
  const auto dot = text.rfind('.');  // port names have no dot, body names may
  if (dot == std::string_view::npos) return {};
  if (text.substr(0, dot) == "ground") {
    const auto point = ground_points.find(std::string(text.substr(dot + 1)));
    if (point == ground_points.end()) return {};
    return Port{-1, 0, SE3(Mat3::Identity(), point->second)};
  }
  const int i = body(text.substr(0, dot));
  if (i < 0) return {};
  return std::visit([&](const auto& kind) { return port_of(i, kind, text.substr(dot + 1)); },
                    bodies[std::size_t(i)].kind);
}

std::vector<std::string> Mechanism::port_names(int body) const {
  if (body == -1) {
    std::vector<std::string> names{"ground"};
    for (const auto& [point, place] : ground_points) names.push_back("ground." + point);
    return names;
  }
  if (body < 0 || std::size_t(body) >= bodies.size()) no_such("body", body, bodies.size());
  const auto& spec = bodies[std::size_t(body)];
  auto names = std::visit([](const auto& kind) { return names_of(kind); }, spec.kind);
  for (auto& port : names) port = fmt::format("{}.{}", spec.name, port);
  return names;
}

SE3 Mechanism::frame(const Port& port) const {
  if (port.body == -1) return port.offset;
  if (port.body < 0 || std::size_t(port.body) >= bodies.size())
    no_such("body", port.body, bodies.size());
  const auto& kind = bodies[std::size_t(port.body)].kind;
  if (const auto* rigid = std::get_if<RigidSpec>(&kind)) return rigid->frame * port.offset;
  if (const auto* solid = std::get_if<SolidSpec>(&kind)) {
    const bool interface = port.node >= 0 && std::size_t(port.node) < solid->interfaces().size();
    return solid->port(interface ? port.node : 0) * port.offset;
  }
  const auto& nodes = std::get<BeamSpec>(kind).nodes;
  if (port.node < 0 || std::size_t(port.node) >= nodes.size())
    no_such("node", port.node, nodes.size());
  return nodes[std::size_t(port.node)] * port.offset;
}

double Mechanism::size() const {
  Eigen::AlignedBox3d box;
  for (const BodySpec& body : bodies) {
    if (const auto* beam = std::get_if<BeamSpec>(&body.kind))
      for (const SE3& H : beam->nodes) box.extend(H.x);
    if (const auto* rigid = std::get_if<RigidSpec>(&body.kind)) {
      box.extend(rigid->frame.x);
      for (const auto& [label, point] : rigid->points) box.extend(point);
    }
    if (const auto* solid = std::get_if<SolidSpec>(&body.kind))
      for (int i = 0; i < solid->mesh().node_count(); ++i)
        box.extend((solid->frame * SE3(Mat3::Identity(), solid->mesh().nodes.col(i))).x);
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

}  // namespace liesl
