#pragma once
/// @file
/// Rows of a comparison that are other models of the scene than a formalism makes, such as a meshed
/// part in the place of a beam.
///
///     [models.continuum]
///     set = { "bodies.rod" = { solid = { as = "continuum", ... } } }
///     elements = { key = "bodies.rod.solid.mesh.cells.0", values = [20, 40, 80] }

#include "apps/batch/grid.hpp"
#include "apps/input/document.hpp"

namespace liesl {

/// Appends the rows of each model and numbers all anew: the grid again, with the name of the model
/// as formalism and its own `elements`. A model changes how the scene is computed, not what it is:
/// its rows have the reference of the grid.
void add_models(const toml::table& models, const std::vector<Axis>& axes, CaseList& cases,
                Problems& problems);

}  // namespace liesl
