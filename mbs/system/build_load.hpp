#pragma once
/// @file
/// Loads at ports and along bodies.

#include "mbs/bodies/body.hpp"
#include "mbs/system/build_port.hpp"

namespace liesl {

template <FrameGroup G>
Load<G> build_load(const LoadSpec& l, const Mechanism& mechanism, const Model<G>& model,
                   const Ports<G>& ports) {
  const Space<G>& space = model.space;
  Load<G> load;
  load.port = ports.of(l.port);
  load.spread = l.spread;
  load.follower = l.follower;
  load.scale = l.scale;
  const SE3::Tangent wrench = (SE3::Tangent() << l.force, l.moment).finished();
  load.wrench = l.follower ? space.reduce_local(wrench, space.alignment(mechanism.frame(l.port)))
                           : space.reduce_wrench(l.force, l.moment);
  if (l.spread) {
    const Body<G>& body = *model.bodies[l.port.body];
    load.distribution = body.load_distribution();
    load.share = body.load_share(l.follower);
  }
  return load;
}

}  // namespace liesl
