#pragma once
/// @file
/// How much of each cell a shape fills (Norato, Haber, Tortorelli, Bendsoe 2004, "A geometry
/// projection method for shape optimization", Int. J. Numer. Meth. Engng 60; thesis ch. 3.2.2).

#include <Eigen/SparseCore>

#include "mbs/levelset/level_set.hpp"
#include "mbs/solids/mesh.hpp"

namespace liesl {

/// Rows are cells, columns parameters; only cells that the outline crosses have entries.
using FractionGradient = Eigen::SparseMatrix<double, Eigen::RowMajor>;

struct Fractions {
  Eigen::VectorXd value;        ///< by cell, in [0, 1]
  FractionGradient derivative;  ///< d value / d p
};

/// 4-node quadrilaterals and 8-node hexahedra can be cut by an outline.
bool takes_outline(const SolidMesh& mesh);

/// phi is taken as linear on the simplices of `subdivisions` sub-cells a direction; the share of a
/// simplex is a closed form of its corner values (`positive_share`), and so its derivative is exact
/// for the value given. Against the true shape the value's error falls with the square of the
/// sub-cell, the derivative's a little slower (tests/mbs/solids/volume_fraction_test.cpp). A cell
/// is not looked into if |phi| at its centre exceeds its slope there times two half diagonals, and
/// its corners agree in sign. 0: 4 sub-cells in the plane, 3 in space.
/// @throws std::invalid_argument for cells that no outline can cut
Fractions volume_fractions(const SolidMesh& mesh, const levelset::LevelSet& shape,
                           int subdivisions = 0);

}  // namespace liesl
