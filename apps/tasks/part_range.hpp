#pragma once
/// @file
/// How far a meshed part goes beyond what it can describe: its deformation is linear in its frame.

#include <string>
#include <vector>

#include "mbs/bodies/solid_body.hpp"

namespace liesl {

/// Over the records of a simulation.
struct PartRange {
  double bend = 0;   ///< largest turn of an interface against the first, rad
  double euler = 0;  ///< largest compression over the Euler load; parts of two interfaces only
};

/// Compression N = -d . f_1, f = K_e e the force on the second interface, d the direction from the
/// first to it. Euler load between hinges of a bar that is as soft across d as the part held at its
/// first interface, y = F L^3/(3 EI): P_E = pi^2 EI/L^2 = pi^2 L/(3 y/F).
/// @param e coordinates of the part, a column a record
template <FrameGroup G>
PartRange part_range(const SolidBody<G>& body, const Eigen::MatrixXd& e);

/// A sentence for each bound that is passed: a tenth of the Euler load, 0.15 rad.
std::vector<std::string> range_warnings(const std::string& part, const PartRange& range);

extern template PartRange part_range(const SolidBody<SE2>&, const Eigen::MatrixXd&);
extern template PartRange part_range(const SolidBody<SE3>&, const Eigen::MatrixXd&);

}  // namespace liesl
