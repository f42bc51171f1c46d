#pragma once
/// @file
/// `liesl optimize` of a meshed part under loads that stay.

#include "apps/cli/command.hpp"
#include "apps/cli/run_summary.hpp"
#include "apps/output/atomic_folder.hpp"
#include "apps/scene/study.hpp"
#include "optim/design/shape.hpp"

namespace liesl {

/// The variables of a design, from the start to x (empty: none).
std::vector<output::DesignFigure> design_figures(const std::vector<NlpVariable>& variables,
                                                 const std::vector<std::string>& units,
                                                 const Eigen::VectorXd& x);

/// Optimises, writes the folder and fills in the summary. @returns the exit code
int optimize_part(const Study& study, const CommandOptions& options, output::AtomicFolder& folder,
                  output::OptimizeSummary& summary, const Stopwatch& clock);

/// Step sweeps of the gradients at the start design. @returns the exit code
int check_part_derivatives(const Study& study);

}  // namespace liesl
