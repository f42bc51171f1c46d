#pragma once
/// @file
/// Limits over all of a motion as constraints (thesis section 3.3.2; Kreisselmeier & Steinhauser
/// 1979 for KS): which records count, and functions of all of them.

#include <Eigen/Core>
#include <map>
#include <set>
#include <vector>

#include "optim/study/study.hpp"

namespace liesl {

/// A function v of all records: at `record`, dv = sum_n weight_n dv_n.
struct Aggregate {
  int record = 0;
  double value = 0;
  std::map<int, double> weight;  ///< by record
  double by_limit = 1;           ///< -d(value/limit)/d(ln limit) where the limit is met
};

/// Trapezoidal weights of the records over the duration, sum 1.
std::vector<double> time_weights(const std::vector<double>& times);

/// The records of a limit that become rows; of Neighbours the maxima, which `near_maxima` joins.
/// @param v values, not empty
std::set<int> treated_records(Treatment treatment, const std::vector<double>& v);

/// The maxima of each series; of an empty one none.
std::vector<std::set<int>> maxima_of(const std::vector<Eigen::VectorXd>& series);

/// Of these records of each series those at most ten records from one of its maxima.
std::vector<std::set<int>> near_maxima(std::vector<std::set<int>> records,
                                       const std::vector<Eigen::VectorXd>& series);

/// What a limit is compared with: the largest value, or the number that stands for all.
double treated_value(const ConstraintSpec& limit, const std::vector<double>& times,
                     const std::vector<double>& v);

/// The functions of an aggregating treatment, with their derivatives by the values.
std::vector<Aggregate> aggregates_of(const ConstraintSpec& limit, const std::vector<double>& times,
                                     const std::vector<double>& v);

}  // namespace liesl
