#pragma once
/// @file
/// State of a mechanism at one instant: a value that can be copied.

#include <Eigen/Core>
#include <Eigen/StdVector>
#include <vector>

#include "liegroup/concepts.hpp"

namespace liesl {

template <class G>
using Frames = std::vector<G, Eigen::aligned_allocator<G>>;

template <FrameGroup G>
struct State {
  double t = 0;          ///< s; in statics the load factor
  Frames<G> H;           ///< nodal frames, body after body
  Eigen::VectorXd v;     ///< left-invariant velocities, dim a node
  Eigen::VectorXd vdot;  ///< their rates
  Eigen::VectorXd a;     ///< acceleration-like variable of generalized-alpha, in its coordinates
  Eigen::VectorXd w;     ///< what is integrated as a vector, dim a node: rotation vectors of the
                         ///< classical formalism (last components), modal amplitudes; else zero
  Eigen::VectorXd
      lambda;            ///< multipliers of the constraints; the force on the bodies is -B^T lambda
  Eigen::VectorXd rows;  ///< values of all coupling rows (joint coordinates, distances, residuals)
};

}  // namespace liesl
