#pragma once
/// @file
/// The task of `liesl esl`: the equivalent static loads of every part over a motion. No files, no
/// printing.

#include "apps/tasks/run.hpp"
#include "esl/solid_loads.hpp"

namespace liesl {

/// Loads of a beam.
struct BeamLoads {
  std::string name;
  int nodes = 0;
  LoadSet set;
  std::vector<double>
      values;  ///< load cases x nodes x 6 [N, N m], in the nodes' own axes, in space
  Identity identity;
};

/// Loads of a meshed part as combinations of shapes.
struct SolidLoads {
  std::string name;
  SolidLoadSet set;
  Identity identity;
};

struct EslOutcome {
  RunOutcome run;
  std::vector<BeamLoads> beams;
  std::vector<SolidLoads> solids;
};

/// @param sink takes the series of bodies: see `collect`
EslOutcome esl_task(const Scene& scene, const ChosenSpace& space, const Progress& progress = {},
                    output::BodySink* sink = nullptr);

}  // namespace liesl
