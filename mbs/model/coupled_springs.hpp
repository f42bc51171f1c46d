#pragma once
/// @file
/// Springs of a matrix: the potential q^T K q / 2 of the coordinates q of a joint, as springs on
/// sums of them.

#include <Eigen/Core>
#include <vector>

#include "mbs/model/mechanism.hpp"

namespace liesl {

/// One spring a pivot of K = L D L^T: of stiffness D_ii on q_i + sum_{j > i} L_ji q_j, the sum in
/// the unit of q_i. The same of a matrix of damping.
struct CoupledSpring {
  int coordinate = 0;
  double stiffness = 0;
  std::vector<CoordinateShare> shares;
};

/// @param K n x n, of which the lower triangle is read
/// @returns springs with a stiffness; @throws std::invalid_argument if K has a negative eigenvalue
std::vector<CoupledSpring> coupled_springs(const Eigen::MatrixXd& K);

}  // namespace liesl
