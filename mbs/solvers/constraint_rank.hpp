#pragma once
/// @file
/// Which joint rows repeat others, and how many motions the joints leave.

#include <string>
#include <vector>

#include "mbs/system/equations.hpp"

namespace liesl {

/// Finds constraint rows that depend on earlier ones at state `s` (Gram-Schmidt, rotations scaled
/// by the size of the mechanism) and beside it, makes them Role::Redundant and writes one sentence
/// a coupling: "joint 'guide' repeats rows of 'wrist': 1 of its 2 rows is left out".
/// @returns empty, or which joint's rows depend on others at `s` alone: a dead point, nothing is
/// taken out then
template <FrameGroup G>
std::string remove_redundant_constraints(Model<G>& model, const State<G>& s,
                                         std::vector<std::string>& out);

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

extern template std::string remove_redundant_constraints(Model<SE2>&, const State<SE2>&,
                                                         std::vector<std::string>&);
extern template std::string remove_redundant_constraints(Model<SE3>&, const State<SE3>&,
                                                         std::vector<std::string>&);
extern template std::string contradiction(const Model<SE2>&, const State<SE2>&);
extern template std::string contradiction(const Model<SE3>&, const State<SE3>&);
extern template Mobility mobility(const Model<SE2>&, const State<SE2>&);
extern template Mobility mobility(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
