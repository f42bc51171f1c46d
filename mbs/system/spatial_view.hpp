#pragma once
/// @file
/// A model's states seen in space: frames and local quantities in the axes of the scene, whether
/// the model lives in a plane or not.

#include "mbs/system/model.hpp"

namespace liesl {

template <FrameGroup G>
class SpatialView {
 public:
  SpatialView(const Mechanism& mechanism, const Model<G>& model) : model_(model) {
    for (size_t b = 0; b < model.bodies.size(); ++b)
      for (int k = 0; k < model.bodies[b]->nodes(); ++k)
        align_.push_back(
            model.space.alignment(mechanism.frame({static_cast<int>(b), k, SE3::identity()})));
  }

  /// Frame of a node; `H` points to the frames of the whole model.
  SE3 node(const G* H, int body, int k) const {
    const int i = model_.first_node(body) + k;
    return model_.space.embed(H[i], align_[i]);
  }
  SE3 frame(const G* H, const Port& port) const {
    return port.body < 0 ? port.offset : node(H, port.body, port.node) * port.offset;
  }
  /// Local quantity of a node (velocity, strain, force) in the node's own axes, [6].
  SE3::Tangent local(const typename G::Tangent& h, int body, int k) const {
    return model_.space.embed_local(h, align_[model_.first_node(body) + k]);
  }
  /// Left-invariant velocity of a port; `v` are the velocities of the whole model.
  SE3::Tangent velocity(const double* v, const Port& port) const {
    if (port.body < 0) return SE3::Tangent::Zero();
    const int i = model_.first_node(port.body) + port.node;
    const Eigen::Map<const typename G::Tangent> h(v + G::dim * i);
    return port.offset.AdInv() * local(h, port.body, port.node);
  }

 private:
  const Model<G>& model_;
  Frames<SE3> align_;
};

}  // namespace liesl
