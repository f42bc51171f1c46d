#pragma once
/// @file
/// A shape as data: features and Boolean operations by name, as a scene writes them down.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {

enum class FeatureKind {
  HalfSpace,  // planar, in space endless along their z
  Circle,
  Rectangle,
  Ellipse,
  SuperEllipse,
  Superformula,
  Polyline,
  Spline,
  Nurbs,
  Sphere,  // in space only
  Box,
  Ellipsoid,
  Slab,
  Union,  // operations
  Intersection,
  Difference,
  Mirror  // of one shape: its union with its mirror image
};

inline bool is_operation(FeatureKind kind) { return kind >= FeatureKind::Union; }
inline bool is_curve(FeatureKind kind) {
  return kind >= FeatureKind::Polyline && kind <= FeatureKind::Nurbs;
}
inline bool is_spatial(FeatureKind kind) {
  return kind >= FeatureKind::Sphere && kind <= FeatureKind::Slab;
}

/// A feature with its placement, or an operation on others.
struct FeatureSpec {
  std::string name;
  FeatureKind kind = FeatureKind::Circle;
  /// Of a feature: as `feature_parameters` names them; then the points of a curve, x0, y0, x1, ...,
  /// and its weights. Of an operation: nothing (sharp), or its radius; of a mirror: its
  /// placement.
  std::vector<double> values;
  std::vector<std::string> operands;  ///< of an operation, in order
};

/// A tree of features: exactly one is an operand of no other, and is the shape.
struct ShapeSpec {
  int dim = 2;  ///< 2: placed by x, y, angle; 3: by x, y, z and a rotation vector
  std::vector<FeatureSpec> features;
};

/// The parameters of a feature or mirror of this kind but for the points and weights of curves: x,
/// y, angle or x, y, z, rx, ry, rz, then its own.
std::vector<Parameter> feature_parameters(FeatureKind kind, int dim);

/// What is wrong with one feature, in words.
struct ShapeError {
  std::string feature, text;
};
/// Operands that do not exist, are used twice or hold themselves, features that belong to nothing,
/// kinds that do not exist in the plane, values that make no shape, operations nested too deeply.
std::vector<ShapeError> shape_errors(const ShapeSpec& shape);

/// One feature, placed.
/// @throws std::invalid_argument for an operation, or a wrong number of values
LevelSetPtr make_feature(const FeatureSpec& feature, int dim);

/// The whole tree. Parameters are named "feature.parameter", at whatever depth the feature is.
/// @throws std::invalid_argument with the first error
LevelSetPtr make_shape(const ShapeSpec& shape);

/// Takes values p in the order of `make_shape(shape)->parameters()`.
void set_values(ShapeSpec& shape, const Eigen::VectorXd& p);

}  // namespace liesl::levelset
