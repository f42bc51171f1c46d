#pragma once
/// @file
/// The task of `liesl map`: the objective and the limits of a study on a grid of two design
/// variables (thesis Fig. 3.8), the model of one step beside them. No files, no printing.

#include <functional>
#include <map>

#include "apps/output/map_writer.hpp"
#include "apps/scene/space.hpp"
#include "apps/study/study.hpp"

namespace liesl {

/// An axis as a user writes it: "NAME", over the bounds of the variable, or "NAME=FROM:TO".
struct MapAxis {
  std::string name;
  std::optional<std::array<double, 2>> range;
};

/// The designs that an optimisation has analysed, by cycle, and its last one.
struct DesignPath {
  std::string file;                ///< for messages
  std::vector<std::string> names;  ///< of the variables
  std::vector<std::pair<int, std::vector<double>>> cycles;
  std::vector<double> last;
};

struct MapRequest {
  std::vector<MapAxis> over;    ///< two
  std::vector<std::string> of;  ///< limits, or the objective; empty: all of them
  std::vector<int> points;      ///< along both axes, or along each
  std::optional<DesignPath> path;
  std::optional<int> cycle;  ///< of the path, where the local model is made; none: its last design
};

struct MapHooks {
  std::function<bool()> keep_going;
  std::function<void(int done, int all)> on_point;
};

struct MapOutcome {
  output::DesignMap map;
  output::MapSummary summary;  ///< status "done" or "interrupted"
};

/// Every point is simulated, several at once. What is not on the axes is as at the start of the
/// study, or as at the design of the path where the local model is made.
/// @throws InputError for axes, names, points and paths that do not fit the study, all at once
MapOutcome map_task(const Study& study, const ChosenSpace& space, const MapRequest& request,
                    const MapHooks& hooks = {});

}  // namespace liesl
