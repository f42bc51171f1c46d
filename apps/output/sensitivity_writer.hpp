#pragma once
/// @file
/// Sensitivities of a motion as tables and as one HDF5 file. Layout: docs/outputs.md.

#include <filesystem>
#include <string>
#include <vector>

#include "apps/output/results.hpp"

namespace liesl::output {

/// n records, P parameters.
struct Sensitivities {
  struct Parameter {
    std::string name, unit;
    double value = 0;
  };
  /// One number of the history of a response, J, and dJ/dp.
  struct Gradient {
    std::string response, functional, unit;
    double value = 0;
    double at_time = 0;                ///< s, of a peak or a given time; NaN: of the whole motion
    std::vector<double> by_parameter;  ///< P
  };
  std::vector<Parameter> parameters;
  std::vector<double> times;                     ///< n, s
  std::vector<ResponseResult> responses;         ///< n x C each
  std::vector<std::vector<double>> derivatives;  ///< by response n x C x P; empty: not computed
  std::vector<Gradient> gradients;
};

/// `time [s]`, then a column for each component and parameter, `bend by rod_diameters[0] [m/m]`.
/// @throws IoError (all below)
void write_sensitivities_csv(const std::filesystem::path& path, const Sensitivities& s);

/// A row a functional and parameter: `response, functional, value, unit, at [s], parameter,
/// parameter_value, parameter_unit, gradient, relative`; relative = (p/J) dJ/dp.
void write_gradients_csv(const std::filesystem::path& path, const Sensitivities& s);

///   /time [n], /parameters/{name, unit, value} [P], /responses/<name> [n,C],
///   /sensitivities/<name> [n,C,P], /gradients/{response, functional, value, by_parameter [J,P]}
void write_sensitivities_h5(const std::filesystem::path& path, const Sensitivities& s);

/// (p/J) dJ/dp; 0 where J = 0.
double relative(const Sensitivities& s, const Sensitivities::Gradient& gradient,
                std::size_t parameter);

}  // namespace liesl::output
