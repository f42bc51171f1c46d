#pragma once
/// @file
/// The graph of bodies and joints: its closed loops, and what is next to a joint.

#include <array>
#include <cstddef>
#include <vector>

namespace liesl {

/// Bodies by number, and joints between two of them or one and the ground, which is one vertex.
class JointGraph {
 public:
  /// Bodies that a joint holds on to, -1 = the ground.
  using Ends = std::array<int, 2>;

  JointGraph(int bodies, const std::vector<Ends>& joints);

  /// By joint: the closed loop that it is part of, -1 = none. Loops that have a joint in common are
  /// one, those with no more than a body (or the ground) in common are not: biconnected components.
  const std::vector<int>& loops() const { return loops_; }

  /// The flexible bodies that stand for what deforms beside joints between these ends: those of
  /// their loop; where there is none, the nearest: of the first level, breadth first from the ends
  /// and not by way of the ground, that has one. Empty if no flexible body hangs together with
  /// them.
  std::vector<int> beside(const Ends& ends, const std::vector<bool>& flexible) const;

 private:
  using Vertices = std::array<std::size_t, 2>;
  Vertices vertices(const Ends& ends) const;
  void find_loops();
  std::vector<int> of_loop(int loop, const std::vector<bool>& flexible) const;
  std::vector<int> nearest(const Vertices& ends, const std::vector<bool>& flexible) const;

  std::size_t ground_;  ///< the vertex after those of the bodies
  std::vector<Vertices> joints_;
  std::vector<std::vector<std::size_t>> at_;  ///< joints by vertex
  std::vector<int> loops_;
};

}  // namespace liesl
