#ifdef LIESL_OPTIM

#include "apps/export/beam_mesh.hpp"

#include <algorithm>

namespace liesl {
namespace {

constexpr double kTaper = 0.1;        // length of a piece between outlines, of the smaller outline
constexpr double kBesideKnot = 0.2;   // length of the first piece beside a knot, likewise
constexpr double kLongestCut = 0.25;  // of an element, for both
constexpr double kCutUpTo = 0.4;      // of an element, from a knot

struct ToOutline {
  Outline operator()(const Circle& s) const { return {s.diameter, s.diameter}; }
  Outline operator()(const Tube& s) const { return {s.diameter, s.diameter}; }
  Outline operator()(const FullSection&) const { return {0, 0}; }
  template <class Other>
  Outline operator()(const Other& s) const {
    return {s.width, s.height};
  }
};

Outline mean(const Outline& a, const Outline& b) {
  return {0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
}

/// Cuts the elements of a beam into pieces, from the first to the last.
class Mesher {
 public:
  explicit Mesher(const BeamDeck& deck) : deck_(deck) {
    for (const Section& section : deck.sections)
      outlines_.push_back(std::visit(ToOutline(), section.shape));
    next_node_ = 2 * static_cast<int>(deck.nodes.size());
    next_element_ = static_cast<int>(deck.sections.size()) + 1;
  }

  BeamMesh mesh() {
    for (std::size_t k = 0; k < deck_.nodes.size(); ++k)
      mesh_.nodes[node_number(k)] = {deck_.nodes[k].x, outline_at(k)};
    for (std::size_t e = 0; e < outlines_.size(); ++e) add_pieces(e);
    return std::move(mesh_);
  }

 private:
  static int node_number(std::size_t k) { return static_cast<int>(2 * k + 1); }
  bool bar(std::size_t e) const { return is_bar(deck_.sections[e].shape); }
  /// Between elements e - 1 and e: another outline, or another kind of section.
  bool jumps_at(std::size_t e) const {
    const auto kind = [&](std::size_t of) { return deck_.sections[of].shape.index(); };
    return e > 0 && e < outlines_.size() &&
           (outlines_[e - 1] != outlines_[e] || kind(e - 1) != kind(e));
  }

  Outline outline_at(std::size_t k) const {
    const bool before = k > 0 && bar(k - 1), after = k < outlines_.size() && bar(k);
    if (before && after) return mean(outlines_[k - 1], outlines_[k]);
    return before ? outlines_[k - 1] : after ? outlines_[k] : Outline{0, 0};
  }

  /// Shares of element e, from one of its ends, at which it is cut: towards node k, that end.
  std::vector<double> cuts_towards(std::size_t k, double length) {
    if (!jumps_at(k)) return {};
    const auto least = [&](std::size_t e) { return std::min(outlines_[e][0], outlines_[e][1]); };
    const double size = std::min(least(k - 1), least(k)) / length;
    if (bar(k - 1) && bar(k)) {
      mesh_.by_node = true;
      return {std::min(kTaper * size, kLongestCut)};
    }
    mesh_.knots = true;
    std::vector<double> cuts;
    for (double piece = std::min(kBesideKnot * size, kLongestCut), at = piece; at < kCutUpTo;
         piece *= 2, at += piece)
      cuts.push_back(at);
    return cuts;
  }

  /// Where pieces of element e begin and end, as shares of it.
  std::vector<double> shares(std::size_t e) {
    const double length = (deck_.nodes[e + 1].x - deck_.nodes[e].x).norm();
    std::vector<double> out = {0};
    for (const double share : cuts_towards(e, length)) out.push_back(share);
    const auto from_end = cuts_towards(e + 1, length);
    for (auto share = from_end.rbegin(); share != from_end.rend(); ++share)
      out.push_back(1 - *share);
    out.push_back(1);
    return out;
  }

  void add_pieces(std::size_t e) {
    const std::vector<double> at = shares(e);
    const SE3& from = deck_.nodes[e];
    const SE3::Tangent along = SE3::log(from.inverse() * deck_.nodes[e + 1]);
    const auto place = [&](double share) { return (from * SE3::exp(share * along)).x; };
    const Outline own = bar(e) ? outlines_[e] : Outline{0, 0};
    std::size_t longest = 1;
    for (std::size_t i = 2; i < at.size(); ++i)
      if (at[i] - at[i - 1] > at[longest] - at[longest - 1]) longest = i;
    mesh_.pieces.emplace_back();
    int first = node_number(e);
    for (std::size_t i = 1; i < at.size(); ++i) {
      const bool last = i + 1 == at.size(), main = i == longest;
      const int end = last ? node_number(e + 1) : next_node_++,
                middle = main ? node_number(e) + 1 : next_node_++,
                number = main ? static_cast<int>(e) + 1 : next_element_++;
      if (!last) mesh_.nodes[end] = {place(at[i]), own};
      mesh_.nodes[middle] = {place(0.5 * (at[i - 1] + at[i])),
                             mean(mesh_.nodes[first].outline, mesh_.nodes[end].outline)};
      mesh_.elements[number] = {first, middle, end};
      mesh_.pieces.back().push_back(number);
      first = end;
    }
  }

  const BeamDeck& deck_;
  std::vector<Outline> outlines_;  // E
  int next_node_ = 0, next_element_ = 0;
  BeamMesh mesh_;
};

}  // namespace

bool is_bar(const Shape& shape) {
  return std::holds_alternative<Circle>(shape) || std::holds_alternative<Rectangle>(shape);
}

BeamMesh beam_mesh(const BeamDeck& deck) { return Mesher(deck).mesh(); }

}  // namespace liesl

#endif
