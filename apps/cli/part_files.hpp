#pragma once
/// @file
/// What a study leaves behind of a meshed part whose outline it changed.

#include <filesystem>
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

/// NAME.vtu, the outline as NAME.svg and NAME.dxf or NAME.stl, and for pictures of planar parts
/// NAME_outlines.csv (of the designs `history`) and NAME_cells.csv (fraction, the stress in the
/// load case of the largest, and what a hole would gain). @throws output::IoError
void write_part(const std::filesystem::path& folder, const std::string& name, PartShape& part,
                const std::vector<Eigen::VectorXd>& history, const PartFields& fields);

/// NAME_outline.toml: the tree of features, for a scene. @throws output::IoError
void write_outline(const std::filesystem::path& folder, const std::string& name,
                   const levelset::ShapeSpec& outline);

/// The part at the design x under up to eight of the loads of a motion, the largest among them.
template <FrameGroup G>
PartFields fields_of_motion(const StudySpec& study, PartShape& part, const Eigen::VectorXd& x,
                            const Model<G>& model, const Trajectory<G>& trajectory);

extern template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                            const Model<SE2>&, const Trajectory<SE2>&);
extern template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                            const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl
