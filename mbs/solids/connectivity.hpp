#pragma once
/// @file
/// Does material join the interfaces of a part? Asked before anything is solved.

#include <optional>
#include <string>

#include "mbs/solids/solid_model.hpp"

namespace liesl {

/// Least fraction of a cell that counts as material; cells with less are void.
inline constexpr double kLeastFraction = 0.05;

struct ConnectivityProblem {
  std::string interface;  ///< the one that is cut off, or bare
  std::string text;       ///< one sentence for the user
};

/// Pieces of a mesh whose cells are joined by their sides.
int pieces_by_sides(const SolidMesh& mesh);

/// Cells with a fraction of at least `threshold` that share a side are joined. Nothing is wrong if
/// every interface has such a cell at its nodes and all are reached from the first.
std::optional<ConnectivityProblem> cut_interface(const SolidModel& model, const Eigen::VectorXd& v,
                                                 double threshold = kLeastFraction);

}  // namespace liesl
