#pragma once
/// @file
/// The loads that a cycle sized a part for, at the few instants that tell most of them.

#include <Eigen/Core>
#include <vector>

namespace liesl {

/// Of one part in one motion, in space. Of a beam the loads on its nodes, in the axes of those; of
/// a meshed part those on its interfaces, then on its patches (LoadPatches), axes of its mesh.
struct CycleLoads {
  using Load = Eigen::Matrix<double, 6, Eigen::Dynamic>;  ///< [force; moment] a point; N, N m

  int body = 0, scenario = 0;
  std::vector<double> times;  ///< s; load factors of equilibria
  std::vector<Load> loads;    ///< one a time
};

}  // namespace liesl
