#pragma once
/// @file
/// The stages of a search for the leanest model, in their order (see lean_search.hpp).

#include "apps/lean/lean_runs.hpp"

namespace liesl {

/// Runs the scene as given; false, with a reason, if it does not reach its end.
/// @throws InputError as find_lean
bool run_as_given(LeanRuns& runs);
/// Planar or spatial.
void choose_space(LeanRuns& runs);
/// Refines mesh and step together until the estimated error is small; false if it stays large.
bool find_reference(LeanRuns& runs);
/// Rigid beams: one run each, then those that hardly matter together.
void make_rigid(LeanRuns& runs);
/// Mesh and step; false if the finest choice is not within the budget.
/// @param of what the decisions are called besides: " of order 4"
bool choose_mesh_and_step(LeanRuns& runs, const std::string& of = "");
/// Elements of order 4, with mesh and step of their own, where measured to be faster.
void choose_order(LeanRuns& runs);
/// Chains of segments, which have no torsion and no shear, with mesh and step of their own, where
/// measured to be faster: only in a plane, and within the tolerance of a reference that has both.
void choose_segments(LeanRuns& runs);
/// Few modes, where measured to be faster.
void choose_modes(LeanRuns& runs);
/// Another tangent, where measured to be faster.
void choose_tangent(LeanRuns& runs);
/// The error against a run twice as fine as the reference. If it is too large, that run is the
/// next reference.
bool check_held_out(LeanRuns& runs);

}  // namespace liesl
