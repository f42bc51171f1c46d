#pragma once
/// @file
/// Which load cases a static problem keeps: those near the largest value of each limit, then those
/// that turn out to violate one.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "optim/nlp/problem.hpp"
#include "optim/study/study.hpp"

namespace liesl {

struct ScreenedLimit {
  int constraint = 0;  ///< of the study; screening is relative to its largest value
  int part = 0;        ///< whose load cases count
  bool many = false;   ///< one of hundreds of points of one constraint: at most `min_cases` each
  double limit = 0;    ///< value <= limit
};

using CasesByLimit = std::vector<std::vector<int>>;
using ValuesByLimit = std::vector<std::vector<double>>;  ///< [limit][case]

/// For each limit the cases within `screening` of its constraint's largest value, and at least
/// `min_cases`; largest first.
CasesByLimit near_largest(const ValuesByLimit& value, const std::vector<ScreenedLimit>& limits,
                          const CycleOptions& options);
/// Adds the cases above limit (1 + tolerance) behind those that are there, whose order stays: rows
/// of a problem that takes none are the same as before. @returns how many
int add_violated(const ValuesByLimit& value, const std::vector<ScreenedLimit>& limits,
                 double tolerance, CasesByLimit& cases);

/// Rows of a static problem.
struct RetainedCases {
  struct Row {
    int limit = 0, kept = 0;  ///< which limit in which retained case of its part
  };
  std::vector<Row> rows;
  std::vector<std::vector<int>> kept;      ///< by part: numbers of the retained cases
  std::vector<NlpConstraint> constraints;  ///< one a row

  /// The cases of every limit, as they went in.
  CasesByLimit cases(const std::vector<ScreenedLimit>& limits) const;
};

/// @param names of the limits  @param labels of the cases by part, "t = 0.1 s"
RetainedCases retain(const CasesByLimit& cases, const std::vector<ScreenedLimit>& limits,
                     const std::vector<std::string>& names,
                     const std::vector<std::vector<std::string>>& labels);

/// The columns of f that are kept.
Eigen::MatrixXd kept_columns(const Eigen::MatrixXd& f, const std::vector<int>& kept);

}  // namespace liesl
