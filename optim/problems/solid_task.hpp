#pragma once
/// @file
/// What a meshed part has to carry and to meet, as data and as a study states it.

#include <algorithm>
#include <optional>

#include "mbs/solids/solid_statics.hpp"
#include "mbs/solids/stress_norm.hpp"
#include "optim/design/part_shape.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {

struct SolidLimit {
  std::string name;
  SolidResponse response = SolidResponse::Output;
  int first = 0, count = 1;  ///< Output: columns of C; Frequency: `count`
  double limit = 0;          ///< > 0
  std::optional<LimitedResponse> motion =
      {};  ///< of a motion: what it is the image of; none: fixed loads, mass, frequency
  /// Above 0: no limit, but this times the largest value of its cases (of a frequency minus the
  /// lowest) in the objective; `limit` is then its size at the analysed design.
  double weight = 0;
  int part_limit = -1;  ///< number among those of the study; -1: it is none
};

/// Nothing is copied but data: what is referred to must outlive the task.
struct SolidTask {
  const ShapeDesign* design = nullptr;
  levelset::LevelSet* shape = nullptr;
  const SolidModel* model = nullptr;
  SolidSupport support;
  Eigen::MatrixXd outputs;         ///< C, q x m
  std::vector<std::string> cases;  ///< what the load cases are called
  Eigen::MatrixXd loads;           ///< q x cases, or q x k, combined by `combination`
  /// k x cases: the loads of the cases are loads * combination, so that outputs take k solutions,
  /// however many cases there are. Empty: `loads` are the cases.
  Eigen::MatrixXd combination;
  /// q x k: the displacements of the motion are basis * combination (SolidLoadSet); empty: none.
  Eigen::MatrixXd basis;
  /// What the motion says of the outputs at the analysed design, m x cases. Empty: fixed loads.
  Eigen::MatrixXd measured;
  std::vector<SolidLimit> limits;
  SolidResponse objective = SolidResponse::Mass;  ///< Mass; Compliance, the mean of the cases; or
                                                  ///< Stress, their p-mean
  double mass_weight = 1;  ///< of the mass that is the objective; limits with a weight are added
  bool weighted() const {
    return std::any_of(limits.begin(), limits.end(),
                       [](const SolidLimit& l) { return l.weight > 0; });
  }
  StressOptions stress;
  CycleOptions cycle;  ///< for the screening of cases
};

/// Support, outputs, limits, objective and fixed loads of a part; no loads of a motion yet.
/// `part` and its parts must outlive it. Default support: all directions of the first interface.
/// @throws std::invalid_argument: a support that is no interface, set or "inertia_relief", loads
/// that fit no side, an elongation of two bodies
SolidTask solid_task(const StudySpec& study, PartShape& part);

}  // namespace liesl
