#include "mbs/system/joint_graph.hpp"

#include <numeric>
#include <set>
#include <utility>

namespace liesl {
namespace {

/// Sets of joints that are one loop.
class Sets {
 public:
  explicit Sets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t j) { parent_[of(i)] = of(j); }

 private:
  std::vector<std::size_t> parent_;
};

/// Where a vertex is in the spanning trees.
struct Place {
  int depth = -1;                 ///< of a root 0
  std::size_t up = 0, joint = 0;  ///< the vertex above and the joint with it, but of a root
};

/// Breadth first from every vertex that is not reached before.
std::vector<Place> spanning_trees(const std::vector<std::vector<std::size_t>>& at,
                                  const std::vector<std::array<std::size_t, 2>>& joints) {
  std::vector<Place> places(at.size());
  for (std::size_t root = 0; root < at.size(); ++root) {
    if (places[root].depth >= 0) continue;
    places[root].depth = 0;
    std::vector<std::size_t> queue{root};
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const std::size_t from = queue[next];
      for (const std::size_t j : at[from])
        for (const std::size_t end : joints[j]) {
          if (places[end].depth >= 0) continue;
          places[end] = {places[from].depth + 1, from, j};
          queue.push_back(end);
        }
    }
  }
  return places;
}

}  // namespace

JointGraph::JointGraph(int bodies, const std::vector<Ends>& joints)
    : ground_(std::size_t(bodies)), at_(ground_ + 1) {
  for (const Ends& ends : joints) {
    for (const std::size_t end : vertices(ends)) at_[end].push_back(joints_.size());
    joints_.push_back(vertices(ends));
  }
  find_loops();
}

auto JointGraph::vertices(const Ends& ends) const -> Vertices {
  const auto of = [this](int body) { return body < 0 ? ground_ : std::size_t(body); };
  return {of(ends[0]), of(ends[1])};
}

/// A joint that is in no spanning tree closes a loop with the way in the tree between its ends.
/// These with those that have joints in common with them are the biconnected components, whatever
/// the tree: components of the cycle matroid are those of the fundamental circuits of any basis.
void JointGraph::find_loops() {
  const std::vector<Place> places = spanning_trees(at_, joints_);
  Sets sets(joints_.size());
  std::vector<bool> closed(joints_.size(), false);
  const auto above = [&](std::size_t v, std::size_t j) {
    return places[v].depth > 0 && places[v].joint == j;
  };
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    auto [a, b] = joints_[j];
    if (above(a, j) || above(b, j)) continue;
    closed[j] = true;
    while (a != b) {
      std::size_t& lower = places[a].depth > places[b].depth ? a : b;
      closed[places[lower].joint] = true;
      sets.unite(places[lower].joint, j);
      lower = places[lower].up;
    }
  }
  loops_.assign(joints_.size(), -1);
  for (std::size_t j = 0; j < joints_.size(); ++j)
    if (closed[j]) loops_[j] = int(sets.of(j));
}

std::vector<int> JointGraph::beside(const Ends& ends, const std::vector<bool>& flexible) const {
  const Vertices at = vertices(ends), turned{at[1], at[0]};
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    if (joints_[j] != at && joints_[j] != turned) continue;
    std::vector<int> found = of_loop(loops_[j], flexible);
    if (!found.empty()) return found;
    break;
  }
  return nearest(at, flexible);
}

std::vector<int> JointGraph::of_loop(int loop, const std::vector<bool>& flexible) const {
  std::set<int> found;
  for (std::size_t j = 0; j < joints_.size() && loop >= 0; ++j)
    for (const std::size_t end : joints_[j])
      if (loops_[j] == loop && end != ground_ && flexible[end]) found.insert(int(end));
  return {found.begin(), found.end()};
}

std::vector<int> JointGraph::nearest(const Vertices& ends,
                                     const std::vector<bool>& flexible) const {
  std::vector<bool> reached(at_.size(), false);
  reached[ground_] = true;
  std::vector<std::size_t> level;
  std::set<int> found;
  const auto reach = [&](std::size_t body, std::vector<std::size_t>& into) {
    if (reached[body]) return;
    reached[body] = true;
    into.push_back(body);
    if (flexible[body]) found.insert(int(body));
  };
  for (const std::size_t end : ends) reach(end, level);
  while (found.empty() && !level.empty()) {
    std::vector<std::size_t> next;
    for (const std::size_t body : level)
      for (const std::size_t j : at_[body])
        for (const std::size_t end : joints_[j]) reach(end, next);
    level = std::move(next);
  }
  return {found.begin(), found.end()};
}

}  // namespace liesl
