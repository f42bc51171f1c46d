#pragma once
/// @file
/// What pictures draw larger than it is; vectors and axes of blocks of results.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "apps/output/results.hpp"

namespace liesl::output {

inline Eigen::Vector3d vector_at(const std::vector<double>& block, std::size_t i) {
  return Eigen::Vector3d::Map(&block[3 * i]);
}

/// Axes of a node by columns; matrices are stored by rows.
inline Eigen::Matrix3d axes_at(const std::vector<double>& block, std::size_t i) {
  return Eigen::Matrix<double, 3, 3, Eigen::RowMajor>::Map(&block[9 * i]);
}

/// Are displacements from rest drawn larger, of all bodies alike? In statics and of modes; of a
/// motion, what each flexible body is deformed about its chord.
bool from_rest(const Results& results);

/// Of places of a body at a record. Of a motion: those of beams,
///   x - lerp(x_first, x_last) - Q (X - lerp(X_first, X_last)),  Q: mean turn of the nodes,
/// as the page has it (apps/report/page/src/motion.js); nothing of others, a body without places at
/// rest included.
class Enlarged {
 public:
  /// @param row where the series of bodies hold the record
  Enlarged(const Results& results, const BodyResult& body, std::size_t row);
  /// @param place in the axes of the node
  Eigen::Vector3d at(int node, const Eigen::Vector3d& place = Eigen::Vector3d::Zero()) const;

 private:
  Eigen::Vector3d about_chord(std::size_t node) const;

  const BodyResult& body_;
  bool known_, from_rest_;
  std::size_t first_;          ///< frame of the record
  std::vector<double> share_;  ///< of the length of a beam, by nodes
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
};

}  // namespace liesl::output
