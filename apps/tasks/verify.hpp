#pragma once
/// @file
/// Errors of the peaks of responses by mesh and by step, from runs with half of each.
///
/// With the given mesh and step R, half the elements' length R_m, half the step R_s (Richardson
/// 1911, see mbs/solvers/richardson.hpp), p the order of the elements, 2 of the step:
///
///   error of R by the mesh = |R - R_m| / (1 - 2^-p), by the step = |R - R_s| / (1 - 2^-2).
///
/// R_s and the run of the coarser step are converged to a tolerance of 1e-8, where that of the
/// scene is larger, so that the error by the step has that of its iterations in it.
///
/// A peak between two steps adds what it is higher than both (output::Peak::missed) to the error by
/// the step, if that is more, and one between two nodes to that by the mesh. Both together have the
/// signs of R - R_m and R - R_s (missed: negative), but are a quarter of the larger one at least.
///
/// Runs of twice the elements' length and of twice the step, where they can be, show the orders;
/// where one is lower than expected, it counts.

#include "apps/output/summary.hpp"
#include "apps/tasks/finer_scenes.hpp"
#include "mbs/solvers/simulation.hpp"

namespace liesl {

/// @throws InputError for natural frequencies and scenes that trace a path by arc length
void check_verifiable(const SimulationOptions& options);

/// Adds `error_mesh`, `error_step`, `error_total` to the responses of a summary, the key
/// `verification`, and warnings where orders are not as expected or a part cannot be refined.
/// Simulates the scene at most four times more.
/// @param scene as read, with these responses  @param summary of its run, with its space
/// @throws InputError as check_verifiable
void verify(const VerifiedScene& source, const Scene& scene, output::RunSummary& summary,
            const Progress& progress = {});

}  // namespace liesl
