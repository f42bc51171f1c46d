// Quadrature of the reference cells.
#include <cmath>

#include "mbs/solids/cell_kind.hpp"

namespace liesl {
namespace {

using Eigen::Vector3d;
using Rule = std::vector<QuadraturePoint>;

Rule cube_rule(int dim, int order) {
  const double g = order == 1 ? 1 / std::sqrt(3.0) : std::sqrt(0.6);
  const std::vector<double> at = order == 1 ? std::vector{-g, g} : std::vector{-g, 0.0, g},
                            weight = order == 1 ? std::vector{1.0, 1.0}
                                                : std::vector{5.0 / 9, 8.0 / 9, 5.0 / 9};
  Rule rule = {{Vector3d::Zero(), 1}};
  for (int a = dim - 1; a >= 0; --a) {  // the first coordinate runs fastest
    Rule finer;
    for (const QuadraturePoint& p : rule)
      for (std::size_t i = 0; i < at.size(); ++i) {
        finer.push_back({p.xi, p.weight * weight[i]});
        finer.back().xi[a] = at[i];
      }
    rule = finer;
  }
  return rule;
}

/// All places of which `equal` barycentric coordinates are a, the others the same as each other.
void add_orbit(Rule& rule, int dim, int equal, double a, double weight) {
  const int corners = dim + 1;
  for (int mask = 0; mask < 1 << corners; ++mask) {
    int count = 0;
    for (int c = 0; c < corners; ++c) count += mask >> c & 1;
    if (count != equal) continue;
    const double other = equal == corners ? a : (1 - equal * a) / (corners - equal);
    Vector3d xi = Vector3d::Zero();
    for (int c = 1; c < corners; ++c) xi[c - 1] = mask >> c & 1 ? a : other;
    rule.push_back({xi, weight});
  }
}

/// Exact for polynomials of a degree: 1, 2, or 4 (in space 5). Weights are shares of the simplex.
Rule simplex_rule(int dim, int degree) {
  Rule rule;
  if (degree == 1) {
    add_orbit(rule, dim, dim + 1, 1.0 / (dim + 1), 1);
  } else if (degree == 2) {
    add_orbit(rule, dim, dim, dim == 2 ? 1.0 / 6 : (1 - std::sqrt(0.2)) / 4, 1.0 / (dim + 1));
  } else if (dim == 2) {
    add_orbit(rule, 2, 2, 0.44594849091596488632, 0.22338158967801146570);
    add_orbit(rule, 2, 2, 0.09157621350977074346, 0.10995174365532186764);
  } else {
    add_orbit(rule, 3, 3, 0.31088591926330060980, 6 * 0.01878132095300264180);
    add_orbit(rule, 3, 3, 0.092735250310891226402, 6 * 0.01224884051939365826);
    add_orbit(rule, 3, 2, 0.045503704125649649492, 6 * 0.0070910034628469110730);
  }
  for (QuadraturePoint& p : rule) p.weight /= dim == 2 ? 2 : 6;
  return rule;
}

Rule rule_of(const CellKind& kind, QuadratureUse use) {
  if (kind.family == CellFamily::Cube) return cube_rule(kind.dim, kind.order);
  const bool mass = use == QuadratureUse::Mass;
  return simplex_rule(kind.dim, kind.order == 1 ? (mass ? 2 : 1) : (mass ? 4 : 2));
}

}  // namespace

const std::vector<QuadraturePoint>& cell_quadrature(const CellKind& kind, QuadratureUse use) {
  static const auto all = [] {
    std::vector<std::array<Rule, 2>> out;
    for (const CellKind& k : cell_kinds())
      out.push_back({rule_of(k, QuadratureUse::Stiffness), rule_of(k, QuadratureUse::Mass)});
    return out;
  }();
  return all[std::size_t(&kind - cell_kinds().data())][std::size_t(use)];
}

}  // namespace liesl
