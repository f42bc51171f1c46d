#pragma once
/// @file
/// Where a meshed part is held: sets of nodes tied to a frame.

#include <Eigen/Core>
#include <string>
#include <vector>

namespace liesl {

enum class Tie {
  Rigid,    ///< the nodes move as one rigid body with the port
  Averaged  ///< the port moves as the nodes do on average (least squares, RBE3); a load on the
            ///< port spreads over them and they stay free to deform
};

/// A set of nodes tied to a port: a frame at `point` with the axes of the mesh.
struct Interface {
  std::string name;
  std::vector<int> nodes;  ///< at least 2 (3 in space, not in a line), of no other interface
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< m
  Tie tie = Tie::Rigid;
};

}  // namespace liesl
