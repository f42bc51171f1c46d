/// @file
/// Table of the keys of meshed parts. Rows: path, type, unit, preset, range, doc, size, options,
/// when.
#include "apps/input/schema.hpp"

namespace liesl {

namespace {

// clang-format off
std::vector<Key> part_keys() {
  return {
    {"bodies.*.solid", Type::Table, "", kOneOf, kAny, "Meshed part, simulated with the motions of its interfaces and some modes, or with all nodes of its mesh (`as`). Ports: its interfaces."},
    {"bodies.*.solid.mesh", Type::Table, "", kOneOf, kAny, "Cells: planar ones (plane stress, in a planar scene) or cells in space, all of one kind. Lengths and features are in the coordinates of the mesh."},
    {"bodies.*.solid.mesh.from", Type::Point, "m", kOneOf, kAny, "Grid: its first corner, [x, y] or [x, y, z]; needs `to` and `cells`. Its sides are the sets x_min, x_max, y_min, ..."},
    {"bodies.*.solid.mesh.to", Type::Point, "m", kOptional, kAny, "Grid: the opposite corner."},
    {"bodies.*.solid.mesh.cells", Type::Point, "-", kOptional, {1, 100000}, "Grid: number of cells in each direction."},
    {"bodies.*.solid.mesh.file", Type::Text, "", kOneOf, kAny, "A Gmsh file (4.1, ASCII), whose physical groups are sets of nodes, or one of Abaqus or CalculiX (.inp, flat) and its *NSET. Triangles (3 or 6 nodes: CPS3, CPS6) or quadrilaterals (4 or 8: CPS4, CPS8) in z = 0, tetrahedra (4 or 10: C3D4, C3D10) or hexahedra (8 or 20: C3D8, C3D20). m. Relative to the scene."},
    {"bodies.*.solid.matrices", Type::Table, "", kOneOf, kAny, "Instead of a mesh: stiffness and mass of the free part from another program, freedoms node by node (x, y, z of the first, ...; with rotations of nodes behind them where the matrices have such), as of a mesh or after a static condensation to some nodes: three MatrixMarket files, or one HDF5 `file`. Reduced as a mesh is. Relative to the scene; `liesl export --to matrices` writes them."},
    {"bodies.*.solid.matrices.stiffness", Type::Text, "N/m", kOptional, kAny, "`coordinate real symmetric` (or `general`): 3 (planar: 2) rows a node, 6 (planar: 3) with rotations. Rigid motions take no forces."},
    {"bodies.*.solid.matrices.mass", Type::Text, "kg", kOptional, kAny, "Likewise. It may couple components; in rigid motions it is the mass of a rigid body."},
    {"bodies.*.solid.matrices.nodes", Type::Text, "m", kOptional, kAny, "`array real general`: a row [x, y, z] a node; [x, y] of a planar part."},
    {"bodies.*.solid.matrices.file", Type::Text, "", kOptional, kAny, "HDF5, alone: the data sets `nodes`, `stiffness/row`, `column` and `value`, `mass/...` (counted from 0), and sets of nodes in the group `sets`."},
    {"bodies.*.solid.material", Type::Text, "", kOptional, kAny, "Material; a mesh needs it."},
    {"bodies.*.solid.thickness", Type::Number, "m", kOptional, kPositive, "Of a planar mesh, which needs it; half to each side."},
    {"bodies.*.solid.at", Type::Vector, "m", "[0, 0, 0]", kAny, "Position of the origin of the mesh.", 3},
    {"bodies.*.solid.orientation", Type::Vector, "rad", "[0, 0, 0]", kAny, "Rotation vector of the axes of the mesh.", 3},
    {"bodies.*.solid.as", Type::Choice, "", "\"reduced\"", kAny, "Interfaces and modes in a floating frame, linear in it; or all nodes of the mesh, with any displacement and rotation inside the part.", 0, "reduced continuum"},
    {"bodies.*.solid.law", Type::Choice, "", "\"st_venant_kirchhoff\"", kAny, "Of a continuum: St. Venant-Kirchhoff, for small strains in any motion, or compressible neo-Hookean, which resists being pushed flat.", 0, "st_venant_kirchhoff neo_hookean"},
    {"bodies.*.solid.modes", Type::Integer, "", "8", {0, 200}, "Internal modes that are kept, lowest first; not of a continuum."},
    {"bodies.*.solid.damping", Type::Number, "s", "0", kNotNegative, "Stiffness-proportional."},
    {"bodies.*.solid.ersatz", Type::Table, "", kOptional, kAny, "Stiffness of a cell filled to the fraction v: ratio + (1 - ratio) v^exponent; mass: v, of a continuum ratio + (1 - ratio) v."},
    {"bodies.*.solid.ersatz.exponent", Type::Number, "-", "1.4", {1, 10}, "Above 1: partly filled cells are softer than their share."},
    {"bodies.*.solid.ersatz.ratio", Type::Number, "-", "1e-6", {1e-12, 0.1}, "Of an empty cell."},

    {"bodies.*.solid.interfaces", Type::Named, "", kRequired, kAny, "Where the part is held, by name. The first one carries the floating frame."},
    {"bodies.*.solid.interfaces.*", Type::Table, "", kOptional, kAny, "Nodes that are tied to a frame with the axes of the mesh: exactly one of `circle`, `box`, `set` and `nodes`."},
    {"bodies.*.solid.interfaces.*.circle", Type::Table, "", kOneOf, kAny, "Nodes in a circle; in space, in the endless cylinder."},
    {"bodies.*.solid.interfaces.*.circle.centre", Type::Point, "m", kRequired, kAny, "Centre, [x, y] or [x, y, z]."},
    {"bodies.*.solid.interfaces.*.circle.radius", Type::Number, "m", kRequired, kPositive, "Radius."},
    {"bodies.*.solid.interfaces.*.circle.inner", Type::Number, "m", "0", kNotNegative, "Nodes nearer to the centre than this are left out."},
    {"bodies.*.solid.interfaces.*.circle.axis", Type::Vector, "-", "[0, 0, 1]", kAny, "Of the cylinder in space.", 3},
    {"bodies.*.solid.interfaces.*.box", Type::Table, "", kOneOf, kAny, "Nodes in a rectangle or box."},
    {"bodies.*.solid.interfaces.*.box.from", Type::Point, "m", kRequired, kAny, "One corner."},
    {"bodies.*.solid.interfaces.*.box.to", Type::Point, "m", kRequired, kAny, "The opposite corner."},
    {"bodies.*.solid.interfaces.*.set", Type::Text, "", kOneOf, kAny, "Nodes of a side of the grid (x_min, ...) or of a physical group."},
    {"bodies.*.solid.interfaces.*.nodes", Type::NumberOrList, "", kOneOf, {.lower = 1}, "Numbers of nodes: from 1, in the order of the nodes of the matrices (of a mesh, in the order of its cells). One will do where nodes have rotations and the tie is rigid."},
    {"bodies.*.solid.interfaces.*.point", Type::Point, "m", kOptional, kAny, "Origin of the frame. Default: centre of the circle or box, or the mean of the nodes."},
    {"bodies.*.solid.interfaces.*.tie", Type::Choice, "", "\"rigid\"", kAny, "The nodes move as a rigid body, or the frame moves as they do on average.", 0, "rigid averaged"},
  };
}

std::vector<Key> outline_keys() {
  return {
    {"bodies.*.solid.outline", Type::Named, "", kOptional, kAny, "Where the mesh is material, of 4-node quadrilaterals or 8-node hexahedra: features and operations by name. The shape is the one entry that no operation works on. Without it all of the mesh is material."},
    {"bodies.*.solid.outline.*", Type::Table, "", kOptional, kAny, "A feature, or an operation on others. Its numbers are parameters of the part."},
    {"bodies.*.solid.outline.*.type", Type::Choice, "", kRequired, kAny, "Planar shapes (endless along their z in space), shapes in space (sphere to slab), operations. half_space is material where x < 0, slab where |z| < height/2. mirror: a shape and its image about the line through x, y at `angle`, in space about the plane y = 0 of its turned axes.", 0,
     "half_space circle rectangle ellipse super_ellipse superformula polyline spline nurbs sphere box ellipsoid slab union intersection difference mirror"},
    {"bodies.*.solid.outline.*.of", Type::Texts, "", kRequired, kAny, "Operation: the features that it works on; difference takes all others from the first, mirror has one.", 0, "", "type=union intersection difference mirror"},
    {"bodies.*.solid.outline.*.radius", Type::Number, "m", kRequired, kPositive, "Radius.", 0, "", "type=circle sphere"},
    {"bodies.*.solid.outline.*.radius", Type::Number, "m", kOptional, kNotNegative, "Operation: rounds the edges it makes. Default: sharp.", 0, "", "type=union intersection difference"},
    {"bodies.*.solid.outline.*.width", Type::Number, "m", kRequired, kPositive, "Side along x.", 0, "", "type=rectangle box"},
    {"bodies.*.solid.outline.*.height", Type::Number, "m", kRequired, kPositive, "Side along y; of a slab along z.", 0, "", "type=rectangle box slab"},
    {"bodies.*.solid.outline.*.depth", Type::Number, "m", kRequired, kPositive, "Side along z.", 0, "", "type=box"},
    {"bodies.*.solid.outline.*.fillet", Type::Number, "m", "0", kNotNegative, "Radius of the edges.", 0, "", "type=rectangle box"},
    {"bodies.*.solid.outline.*.a", Type::Number, "m", kRequired, kPositive, "Half-axis along x.", 0, "", "type=ellipse super_ellipse ellipsoid"},
    {"bodies.*.solid.outline.*.b", Type::Number, "m", kRequired, kPositive, "Half-axis along y.", 0, "", "type=ellipse super_ellipse ellipsoid"},
    {"bodies.*.solid.outline.*.c", Type::Number, "m", kRequired, kPositive, "Half-axis along z.", 0, "", "type=ellipsoid"},
    {"bodies.*.solid.outline.*.xi", Type::Number, "-", kRequired, {.lower = 1, .open_lower = true}, "Exponent in |x/a|^xi + |y/b|^eta = 1.", 0, "", "type=super_ellipse"},
    {"bodies.*.solid.outline.*.eta", Type::Number, "-", kRequired, {.lower = 1, .open_lower = true}, "Exponent of y.", 0, "", "type=super_ellipse"},
    {"bodies.*.solid.outline.*.size", Type::Number, "m", kRequired, kPositive, "Factor of r = size (|cos(m angle/4)/a|^n2 + |sin(m angle/4)/b|^n3)^(-1/n1).", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.a", Type::Number, "-", "1", kPositive, "Of the superformula.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.b", Type::Number, "-", "1", kPositive, "Of the superformula.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.m", Type::Number, "-", "4", kNotNegative, "Number of arms.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.n1", Type::Number, "-", "2", kPositive, "Exponent.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.n2", Type::Number, "-", "2", kPositive, "Exponent of the cosine.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.n3", Type::Number, "-", "2", kPositive, "Exponent of the sine.", 0, "", "type=superformula"},
    {"bodies.*.solid.outline.*.points", Type::Rows, "m", kRequired, kAny, "Rows [x, y] in order round the outline: its corners, points on the spline, or control points. At least 3 (polyline) or 4.", 2, "", "type=polyline spline nurbs"},
    {"bodies.*.solid.outline.*.weights", Type::NumberOrList, "-", kRequired, kPositive, "One a control point.", 0, "", "type=nurbs"},
  };
}

/// Position and rotation: of every feature and of the mirror, of no other operation.
std::vector<Key> placement_keys() {
  const std::string_view features = "type=half_space circle rectangle ellipse super_ellipse superformula polyline spline nurbs sphere box ellipsoid slab mirror";
  const std::string p = "bodies.*.solid.outline.*.";
  return {
    {p + "x", Type::Number, "m", kOptional, kAny, "Position; 0 if not given, as the other placements.", 0, "", features},
    {p + "y", Type::Number, "m", kOptional, kAny, "Position.", 0, "", features},
    {p + "z", Type::Number, "m", kOptional, kAny, "Position, in space.", 0, "", features},
    {p + "angle", Type::Number, "rad", kOptional, kAny, "Rotation about z, in the plane.", 0, "", features},
    {p + "rx", Type::Number, "rad", kOptional, kAny, "Rotation vector, in space.", 0, "", features},
    {p + "ry", Type::Number, "rad", kOptional, kAny, "Rotation vector, in space.", 0, "", features},
    {p + "rz", Type::Number, "rad", kOptional, kAny, "Rotation vector, in space.", 0, "", features},
  };
}
// clang-format on

}  // namespace

std::vector<Key> solid_keys() {
  std::vector<Key> keys = part_keys();
  for (const auto& more : {outline_keys(), placement_keys()})
    keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

}  // namespace liesl
