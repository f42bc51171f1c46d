#pragma once
/// @file
/// A beam as CalculiX meshes it: quadratic elements that CalculiX expands to solids.

#include <array>
#include <map>

#include "apps/export/beam_deck.hpp"

namespace liesl {

/// Width along y and height along z of the outline of a section, m.
using Outline = std::array<double, 2>;

/// Elements of three nodes (ends, then the middle), one for each element of the beam, cut where
/// outlines jump. CalculiX joins ends with unlike outlines by a rigid knot, which holds the whole
/// elements beside it: it stiffens the beam the more, the longer these are. Outlines of bars (not
/// of tubes and boxes) may be given at nodes, so that a short piece on each side of the jump leads
/// from one to the other, without a knot; beside tubes and boxes the knot stays, between pieces
/// that are shorter the nearer they are to it.
struct BeamMesh {
  struct Node {
    Vec3 x;           ///< at rest, m
    Outline outline;  ///< of the bars that it belongs to, else (0, 0)
  };
  std::map<int, Node> nodes;                   ///< by number: node k of the beam is 2k + 1
  std::map<int, std::array<int, 3>> elements;  ///< by number: the longest piece of e is e + 1
  std::vector<std::vector<int>> pieces;        ///< E: elements that have the section of e
  bool by_node = false;  ///< outlines of bars are those of their nodes: some jump
  bool knots = false;    ///< beside a tube or box one jumps
};

/// A circle or rectangle, whose outline may be given at nodes.
bool is_bar(const Shape& shape);
BeamMesh beam_mesh(const BeamDeck& deck);

}  // namespace liesl
