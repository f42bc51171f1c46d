#pragma once
/// @file
/// The final design of a study as a scene that runs.

#include <map>
#include <set>
#include <string>

#include "apps/study/study.hpp"
#include "mbs/levelset/shape_spec.hpp"

namespace liesl {

/// The study's scene (that of a scenario, by its number) with the sections, outlines and constants
/// of a design. Each different section of a beam has an entry of its own, `rod_1`, `rod_2`, ...; a
/// key of a section that the study does not change stays.
/// @param final the mechanism at the design
/// @param outlines of the meshed parts whose outline changes, by body
/// @param values of the design variables, by name
std::string design_scene(const Study& study, const Mechanism& final,
                         const std::map<std::string, levelset::ShapeSpec>& outlines,
                         const std::map<std::string, double>& values, std::size_t scenario = 0);

}  // namespace liesl
