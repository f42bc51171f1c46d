#pragma once
/// @file
/// Ports of couplings and loads on the nodes of a model.

#include "mbs/system/model.hpp"

namespace liesl {

/// Turns the ports of a mechanism into those of a model whose bodies are built.
template <FrameGroup G>
class Ports {
 public:
  Ports(const Mechanism& mechanism, const Model<G>& model) : m_(mechanism), model_(model) {}

  /// Port with the axes of the plane (or the inertial ones), at a place given in the scene.
  PortOf<G> at(const Port& port, const Vec3& place) const;
  /// Port with its own axes.
  PortOf<G> of(const Port& port) const;

 private:
  PortOf<G> with(const Port& port, const G& frame) const;

  const Mechanism& m_;
  const Model<G>& model_;
};

extern template class Ports<SE2>;
extern template class Ports<SE3>;

}  // namespace liesl
