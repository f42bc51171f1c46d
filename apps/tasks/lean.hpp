#pragma once
/// @file
/// The task of `liesl lean`: from the text of a scene to that of its lean model. No files, no
/// printing.

#include "apps/lean/lean_search.hpp"
#include "apps/output/summary.hpp"

namespace liesl {

struct LeanRequest {
  std::string text;                    ///< of the scene
  std::string file;                    ///< what messages call it
  std::vector<std::string> overrides;  ///< "key.path=value" for all runs
  std::string response;                ///< that has to be right
  double tolerance = 0.01;             ///< of its largest value, in (0, 0.5]
  bool verify = true;                  ///< the lean model: error of its peak by mesh and step
};

struct LeanOutcome {
  LeanResult result;
  output::RunSummary summary;  ///< with that of the lean model, if it was verified
  std::string scene;  ///< the lean scene with its evidence as comments; empty unless it was found
};

/// @param decided  called with each decision as it is taken
/// @throws InputError for a scene without that response, and as find_lean
LeanOutcome lean_task(const LeanRequest& request, const Progress& progress,
                      const std::function<void(const Decision&)>& decided);

}  // namespace liesl
