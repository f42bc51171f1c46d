#pragma once
/// @file
/// The leanest model of a scene that is good enough for one response.
///
/// A run costs time, so the search goes from cheap to costly and measures only what decides:
///   1. the scene as given; planar if a plane holds it;
///   2. a reference: mesh and step, with beams of order 2 whatever the scene has, refined together
///      until Richardson's estimate of its error is a fifth of the tolerance,
///      r = |R_ref - R_exact| <= tol / 5;
///   3. beams made rigid one at a time, then those that hardly matter together;
///   4. mesh and step: Richardson's estimates of each say where to start (`cheapest`); from there
///      every number is made coarser until |R - R_ref| <= tol - r fails;
///   5. elements of order 4, chains of segments, beams linear with few modes, and tangents, where
///      that is measured to be faster;
///   6. a check on a run twice as fine as the reference, which decided nothing. If it fails, it
///      becomes the reference and 4 to 6 are done again.

#include <functional>

#include "apps/lean/lean_result.hpp"
#include "apps/lean/trial.hpp"

namespace liesl {

/// Finds the leanest model. `tolerance` in (0, 0.5]; `on_decision` is called with each decision.
/// Statics: only space and mesh are chosen. @throws InputError for modes, arc-length paths and a
/// response that is zero throughout
LeanResult find_lean(Trials& trials, double tolerance,
                     const std::function<void(const Decision&)>& on_decision);

}  // namespace liesl
