#include "mbs/system/build_port.hpp"

namespace liesl {

template <FrameGroup G>
PortOf<G> Ports<G>::at(const Port& port, const Vec3& place) const {
  SE3 H = SE3::identity();
  if constexpr (G::space_dim == 2) H.R = model_.space.frame.R;
  H.x = place;
  return with(port, model_.space.reduce(H, SE3::identity()));
}

template <FrameGroup G>
PortOf<G> Ports<G>::of(const Port& port) const {
  const SE3 H = m_.frame(port);
  return with(port, model_.space.reduce(H, model_.space.alignment(H)));
}

template <FrameGroup G>
PortOf<G> Ports<G>::with(const Port& port, const G& frame) const {
  if (port.body < 0) return PortOf<G>::ground(frame);
  Port on = port;  // the node that the port's node follows, if it does
  const NodeKind kind = model_.bodies[port.body]->kind(port.node);
  if (kind != NodeKind::Frame && kind != NodeKind::Position) on.node = 0;
  on.offset = SE3::identity();
  const SE3 H = m_.frame(on);
  const G node = model_.space.reduce(H, model_.space.alignment(H));
  G offset = node.inverse() * frame;
  if (G::log(offset).norm() < 1e-14) offset = G::identity();
  auto made = PortOf<G>::on(port.body, model_.first_node(port.body) + on.node, offset);
  if (kind == NodeKind::Position) made.J.template rightCols<G::rotation_dim>().setZero();
  return made;
}

template class Ports<SE2>;
template class Ports<SE3>;

}  // namespace liesl
