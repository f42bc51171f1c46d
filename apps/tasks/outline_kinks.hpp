#pragma once
/// @file
/// Designs of outlines that no gradient describes: edges that lie on lines of the grid.

#include <map>
#include <string>
#include <vector>

#include "apps/tasks/sensitivity_problem.hpp"

#ifdef LIESL_OPTIM
#include "optim/design/design.hpp"
#include "optim/design/part_shape.hpp"
#endif

namespace liesl {

/// Numbers of the outlines of meshed parts, by body, where a parameter is `by` larger: of a
/// mechanism that its derivative was made of.
struct NearbyOutlines {
  double by = 0;
  std::map<int, Eigen::VectorXd> values;
};
NearbyOutlines nearby_outlines(const Mechanism& mechanism, double by);

/// A sentence for each meshed part of which parameters move edges that lie on grid lines.
/// @param nearby of each parameter of `problem`; between them and the scene numbers are linear
std::vector<std::string> kink_warnings(const SensitivityProblem& problem,
                                       const std::vector<NearbyOutlines>& nearby);

#ifdef LIESL_OPTIM

/// Variables whose fractions of cells have another derivative on one side of x than on the other.
/// An edge on a grid line fills the cells of one side as it moves that way, those of the other side
/// as it moves back.
/// @param x of the part
/// @param within share of the ranges of the variables that x may be beside the kink
std::vector<std::string> outline_kinks(const PartShape& part, const Eigen::VectorXd& x,
                                       double within);

/// A sentence that names those of the start; none if there are none.
std::vector<std::string> start_warnings(const std::string& name, const PartShape& part);
/// Of all parts of a design.
std::vector<std::string> start_warnings(const Design& start, const Mechanism& mechanism);

/// Of a design that is no optimum by its gradients: one that names those that it lies within 1e-3
/// of, for which that may be the reason.
std::vector<std::string> end_warnings(const std::string& name, const PartShape& part,
                                      const Eigen::VectorXd& x);

#endif

}  // namespace liesl
