#pragma once
/// @file
/// A quantity over time, and how far two of them are apart.

#include <filesystem>
#include <string>
#include <vector>

namespace liesl {

/// Of the difference of two series: at the last instant, largest, root mean square.
enum class Norm { Final, Max, Rms };
const char* name_of(Norm norm);

/// n instants, C components.
struct Series {
  int components = 1;
  std::vector<double> t;       ///< n, s, increasing
  std::vector<double> values;  ///< n x C

  /// Value of component c at time t: as recorded, else by the cubic through four neighbours.
  double at(double time, int c) const;
};

/// Sum of series by weights, at the instants of the first of those with the fewest.
Series combine(const std::vector<double>& weights, const std::vector<Series>& series);

/// Norm of a - b over the instants of a; over components it is Euclid's.
double distance(const Series& a, const Series& b, Norm norm);
/// Norm of a.
double size_of(const Series& a, Norm norm);

/// `time [s]`, then the components of a and of b (at the instants of a). @throws output::IoError
void write_series(const std::filesystem::path& path, const Series& a, const Series& b);
/// What write_series wrote; empty series if the file is none. @throws output::IoError
std::pair<Series, Series> read_series(const std::filesystem::path& path);

}  // namespace liesl
