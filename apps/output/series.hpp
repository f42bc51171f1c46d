#pragma once
/// @file
/// A quantity over time, and how far two of them are apart.

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mbs/model/response.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl::output {

/// Of the difference of two series: at the last instant, largest, root mean square.
enum class Norm { Final, Max, Rms };
const char* name_of(Norm norm);

struct Series {
  std::vector<double> t;   ///< s, or load factors; increasing
  Eigen::MatrixXd values;  ///< a row a component, a column an instant

  int components() const { return static_cast<int>(values.rows()); }
  /// Value at a time: as recorded, else by the cubic through the four neighbours.
  Eigen::VectorXd at(double time) const;
};

/// A response at every record of a run.
template <FrameGroup G>
Series record(const ResponseSpec& response, const Mechanism& mechanism, const Model<G>& model,
              const Trajectory<G>& trajectory);

/// Sum of series by weights, at the instants of the first of those with the fewest.
Series combine(const std::vector<double>& weights, const std::vector<Series>& series);
/// Every k-th instant, and the last.
Series thinned(const Series& series, long k);

/// Norm of a - b over the instants of a; over components it is Euclid's. Components that one of
/// the two lacks are zero (a deflection has one in a plane, two in space).
double distance(const Series& a, const Series& b, Norm norm);
/// Norm of a; 0 if it has no instants.
double size_of(const Series& a, Norm norm);
/// max_t |series - reference| / max_t |reference| over the instants of the reference; infinity if
/// the series does not reach the end of the reference.
double relative_distance(const Series& series, const Series& reference);

/// `time [s]`, then the components of a and of b (at the instants of a). @throws IoError
void write_series(const std::filesystem::path& path, const Series& a, const Series& b);
/// What write_series wrote; empty series if the file is none. @throws IoError
std::pair<Series, Series> read_series(const std::filesystem::path& path);

extern template Series record(const ResponseSpec&, const Mechanism&, const Model<SE2>&,
                              const Trajectory<SE2>&);
extern template Series record(const ResponseSpec&, const Mechanism&, const Model<SE3>&,
                              const Trajectory<SE3>&);

}  // namespace liesl::output
