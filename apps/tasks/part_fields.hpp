#pragma once
/// @file
/// A meshed part whose outline a study changed, at its final design.

#include <memory>
#include <string>
#include <vector>

#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"
#include "optim/design/part_shape.hpp"

namespace liesl {

/// A part at its final design.
struct PartFields {
  Eigen::VectorXd fractions;      ///< by cell
  Eigen::MatrixXd displacements;  ///< node freedoms x load cases, m
  Eigen::MatrixXd von_mises;      ///< cells x load cases, Pa, relaxed
  /// HoleProposal::gain, and its unit; empty if it is not known.
  Eigen::VectorXd hole_gain = {};
  std::string gain_unit = {};
};

/// What a study leaves of one part.
struct PartOutcome {
  std::string name;
  std::shared_ptr<PartShape> shape;
  std::vector<Eigen::VectorXd> history;  ///< its designs, the final one last
  PartFields fields;
  levelset::ShapeSpec outline;  ///< the tree of features at the final design
};

/// The part at the design x under up to eight of the loads of a motion, the largest among them.
template <FrameGroup G>
PartFields fields_of_motion(const StudySpec& study, PartShape& part, const Eigen::VectorXd& x,
                            const Model<G>& model, const Trajectory<G>& trajectory);

extern template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                            const Model<SE2>&, const Trajectory<SE2>&);
extern template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                            const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
