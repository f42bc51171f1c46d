#pragma once
/// @file
/// The task of `liesl compare`: rows measured and set against references. No files, no printing.

#include <functional>

#include "apps/compare/comparison.hpp"
#include "apps/compare/row_table.hpp"
#include "apps/scene/scene.hpp"

namespace liesl {

struct Study;

/// Reads the scene that is compared with changes "key.path=value". @throws InputError
using ReadScene = std::function<Scene(const std::vector<std::string>& changes)>;

/// Unit of the response that is compared.
std::string response_unit(const Comparison& comparison, const ReadScene& read);

/// Runs the scene of one row. Non-convergence is an ending.
Measured measure_row(const Comparison& comparison, const Scene& scene);

/// Optimises the study of one row; stops after the cycle that reaches the time limit.
/// @throws output::Interrupted when the program is asked to end
MeasuredMethod measure_method(const Comparison& comparison, const Study& study);

/// What rows are compared with: the mean of two independent sides.
struct Reference {
  output::Series mean;
  double floor = 0;  ///< distance of the two sides: what a comparison can resolve
};

/// One side (0 or 1) of the reference of a row, extrapolated from its runs.
/// @pre the comparison has a reference
/// @throws InputError if a run stops before its end
output::Series reference_side(const Comparison& comparison, std::size_t row, int side,
                              const ReadScene& read);
Reference reference_of(const output::Series& a, const output::Series& b, output::Norm norm);

}  // namespace liesl
