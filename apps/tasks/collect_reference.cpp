#include "apps/tasks/collect_reference.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/model/beam_ends.hpp"
#include "mbs/sections/shape_dimensions.hpp"
#include "mbs/system/spatial_view.hpp"

namespace liesl {
namespace {

std::string shape_name(const Shape& shape) {
  return std::visit(
      [](const auto& s) { return std::string(ShapeDimensions<std::decay_t<decltype(s)>>::shape); },
      shape);
}

void add_sections(const BeamSpec& beam, output::BodyResult& out) {
  for (const Section& section : beam.sections) {
    out.shapes.push_back(shape_name(section.shape));
    const auto names = dimensions(section.shape);
    for (std::size_t i = 0; i < output::kMostDimensions; ++i)
      out.dimensions.push_back(i < names.size() ? dimension(section.shape, names[i]) : 0.0);
  }
}

void add_points(const RigidSpec& rigid, output::BodyResult& out) {
  append(out.points, rigid.centre);
  for (const auto& [name, point] : rigid.points) append(out.points, rigid.frame.inverse() * point);
}

/// Places of both ports, and the axis, in the axes of the nodes they hold on to.
void add_ports(const Mechanism& mechanism, const JointSpec& joint, output::JointResult& out) {
  const std::array<const Port*, 2> ports = {&joint.a, &joint.b};
  for (std::size_t i = 0; i < ports.size(); ++i) {
    const Port& port = *ports[i];
    out.bodies.push_back(port.body < 0 ? "ground" : mechanism.bodies[std::size_t(port.body)].name);
    out.nodes[i] = port.node;
    append(out.places, port.offset.x);
  }
  if (kind_of(joint.type).axes == 0) return;
  const Port& b = joint.b;
  const SE3 node =
      b.body < 0 ? SE3::identity() : mechanism.frame({b.body, b.node, SE3::identity()});
  append(out.axis, node.R.transpose() * joint.axis);
}

}  // namespace

template <FrameGroup G>
void add_reference(const Mechanism& mechanism, const Model<G>& model, const State<G>& rest,
                   output::Results& results) {
  const SpatialView<G> view(mechanism, model);
  for (std::size_t b = 0; b < results.bodies.size(); ++b) {
    output::BodyResult& out = results.bodies[b];
    out.reference_positions.clear();
    out.reference_rotations.clear();
    for (int k = 0; k < out.nodes; ++k) {
      const SE3 H = view.node(rest.H.data(), static_cast<int>(b), k);
      append(out.reference_positions, H.x);
      for (int i = 0; i < 3; ++i) append(out.reference_rotations, H.R.row(i).transpose());
    }
    const BodySpec& spec = mechanism.bodies[b];
    if (!out.points.empty() || !out.shapes.empty()) continue;
    if (const auto* beam = std::get_if<BeamSpec>(&spec.kind)) add_sections(*beam, out);
    if (const auto* rigid = std::get_if<RigidSpec>(&spec.kind)) add_points(*rigid, out);
  }
  for (std::size_t j = 0; j < results.joints.size(); ++j)
    if (results.joints[j].places.empty())
      add_ports(mechanism, mechanism.joints[j], results.joints[j]);
}

template void add_reference(const Mechanism&, const Model<SE2>&, const State<SE2>&,
                            output::Results&);
template void add_reference(const Mechanism&, const Model<SE3>&, const State<SE3>&,
                            output::Results&);

}  // namespace liesl
