#pragma once
/// @file
/// Section forces at the ends of beam elements, of second order also where loads are spread.

#include <algorithm>
#include <array>
#include <vector>

#include "mbs/system/model.hpp"

namespace liesl {

/// Normal and shear forces of an element are constant, those of its middle. Where elements meet
/// they jump by the load of the node, that of weight, inertia and loads spread over both elements,
///
///     J_k = n_k(first node of element k) - n_{k-1}(last node of element k-1),  in the axes of node
///     k,
///
/// of which an element has half between its middle and either end:
///
///     n(first) = n_e - s/2,   n(last) = n_e + s/2,   s = (J_e + J_{e+1})/2
///
/// of the force; of an element at an end of the beam s is the mean of the two jumps next to it.
/// On elements of one length and load per length that is the element's own load; next to a step in
/// either it is of first order. What flips from element to element cancels. Jumps at nodes that
/// couplings or loads hold on to are left out: the other one counts, or none. Moments are linear in
/// an element and stay (Body::section_force).
template <FrameGroup G>
class EndForce {
 public:
  using Tangent = typename G::Tangent;

  explicit EndForce(const Model<G>& model, int body)
      : elements_(model.bodies[body]->elements()),
        loaded_(static_cast<std::size_t>(model.bodies[body]->nodes()), false) {
    const auto mark = [&](const PortOf<G>& port) {
      if (port.body == body)
        loaded_[static_cast<std::size_t>(port.node - model.first_node(body))] = true;
    };
    for (const Coupling<G>& c : model.couplings) mark(c.a), mark(c.b);
    for (const Load<G>& load : model.loads)
      if (!load.spread) mark(load.port);
  }

  /// The section force [N, N m] in the axes of the node at a completed state; in the middle that of
  /// the body. @param body the same, or its derivative (Body::derivative): then that of the force
  Tangent operator()(const Body<G>& body, const BodyState<G>& s, int e, ElementPlace place) const {
    Tangent n = body.section_force(s, e, place);
    for (const auto& [node, share] : shares(e, place))
      if (node > 0)
        add_jump(body.section_force(s, node, ElementPlace::First),
                 body.section_force(s, node - 1, ElementPlace::Last), share, n);
    return n;
  }

  /// Of both ends of all elements, each evaluated once. @param n takes them, one an element
  void all(const Body<G>& body, const BodyState<G>& s, std::array<Tangent, 2>* n) const {
    body.all_end_forces(s, n);
    std::vector<Tangent> jumps(static_cast<std::size_t>(elements_), Tangent::Zero());
    for (int k = 1; k < elements_; ++k)
      add_jump(n[k][0], n[k - 1][1], 1, jumps[static_cast<std::size_t>(k)]);
    for (int e = 0; e < elements_; ++e)
      for (const ElementPlace place : {ElementPlace::First, ElementPlace::Last})
        for (const auto& [node, share] : shares(e, place))
          if (node > 0) n[e][node_of(place)] += share * jumps[static_cast<std::size_t>(node)];
  }
  std::vector<std::array<Tangent, 2>> all(const Body<G>& body, const BodyState<G>& s) const {
    std::vector<std::array<Tangent, 2>> n(static_cast<std::size_t>(elements_));
    all(body, s, n.data());
    return n;
  }

  /// h += (dn/dh)^T f, as Body::add_section_force_gradient.
  void add_gradient(const Body<G>& body, const BodyState<G>& s, int e, ElementPlace place,
                    const Tangent& f, double* h) const {
    body.add_section_force_gradient(s, e, place, f, h);
    Tangent force = f;
    force.template tail<G::rotation_dim>().setZero();
    if (force.isZero(0)) return;
    for (const auto& [node, share] : shares(e, place)) {
      if (node == 0) continue;
      body.add_section_force_gradient(s, node, ElementPlace::First, share * force, h);
      body.add_section_force_gradient(s, node - 1, ElementPlace::Last, -share * force, h);
    }
  }

 private:
  static void add_jump(const Tangent& first, const Tangent& last, double share, Tangent& n) {
    n.template head<G::space_dim>() += share * (first - last).template head<G::space_dim>();
  }

  struct Share {
    int node;  ///< whose jump; 0: none
    double of_jump;
  };

  /// What is added at an end: +-s/2 by the jumps that it is made of.
  std::array<Share, 2> shares(int e, ElementPlace place) const {
    std::array<Share, 2> out{};
    if (place == ElementPlace::Middle || elements_ < 2) return out;
    const int first = std::max(1, std::min(e, elements_ - 2));
    const auto spread = [&](int node) {
      return node < elements_ && !loaded_[static_cast<std::size_t>(node)];
    };
    const int count = int(spread(first)) + int(spread(first + 1));
    const double half = place == ElementPlace::First ? -0.5 : 0.5;
    for (int i = 0; i < 2; ++i)
      if (spread(first + i)) out[static_cast<std::size_t>(i)] = {first + i, half / count};
    return out;
  }

  int elements_;
  std::vector<bool> loaded_;
};

}  // namespace liesl
