#pragma once
/// @file
/// Which joint rows repeat others, and how many motions the joints leave.

#include <string>
#include <utility>
#include <vector>

#include "mbs/system/equations.hpp"

namespace liesl {

/// Constraint rows that repeat others.
struct RedundantRows {
  std::vector<std::pair<int, int>> rows;  ///< coupling, equation
  /// One a coupling: "joint 'guide' repeats rows of 'wrist': 1 of its 2 rows is left out".
  std::vector<std::string> sentences;
  /// Not empty: which joint's rows depend on others at the state alone; `rows` is empty then.
  std::string dead_point;
};

/// Constraint rows that depend on earlier ones at state `s` (Gram-Schmidt, rotations scaled by the
/// size of the mechanism) and near it.
template <FrameGroup G>
RedundantRows redundant_rows(const Model<G>& model, State<G> s);

/// Empty, or which redundant constraint does not hold at `s` and by how much.
template <FrameGroup G>
std::string contradiction(const Model<G>& model, const State<G>& s);

/// Motions left by joints and drives if every body were rigid, and the rows that are then too
/// many: mobility = G::dim * bodies - rank.
struct Mobility {
  int free = 0;
  int redundant = 0;
};
template <FrameGroup G>
Mobility mobility(const Model<G>& model, const State<G>& s);

extern template RedundantRows redundant_rows(const Model<SE2>&, State<SE2>);
extern template RedundantRows redundant_rows(const Model<SE3>&, State<SE3>);
extern template std::string contradiction(const Model<SE2>&, const State<SE2>&);
extern template std::string contradiction(const Model<SE3>&, const State<SE3>&);
extern template Mobility mobility(const Model<SE2>&, const State<SE2>&);
extern template Mobility mobility(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
