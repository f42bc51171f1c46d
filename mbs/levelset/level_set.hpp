#pragma once
/// @file
/// Shapes as level-set functions (thesis eq. 3.1-3.3): phi(x; p) > 0 in the material, < 0 outside,
/// = 0 on the outline.
///
/// Every shape, placement and Boolean operation is one concept, a node that gives phi and its
/// gradients with respect to the point and to its parameters. Points are always in space; a planar
/// shape does not depend on z, which makes it an endless prism there. phi has the unit m and, next
/// to the outline, about the slope one: it is a distance, or a distance to first order, except for
/// the superformula, whose phi is measured along rays.

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace liesl::levelset {

struct Parameter {
  std::string name;  ///< path in the tree, "hole2.radius"
  double value = 0;  ///< at construction
  std::string unit = "m";
  double above = -std::numeric_limits<double>::infinity();  ///< the shape needs value > above
};

class LevelSet;

/// A feature inside a tree of Boolean operations.
struct Part {
  const LevelSet* shape = nullptr;
  int first = 0;  ///< index of its first parameter in the tree
  int sign = 1;   ///< 1: the tree is material where it is (the outer contour), -1: void (a hole)
};

class LevelSet {
 public:
  virtual ~LevelSet() = default;

  /// Parameters of this node and everything below, in the order of `p`. Constant.
  const std::vector<Parameter>& parameters() const { return parameters_; }
  int size() const { return static_cast<int>(parameters_.size()); }
  /// The values at construction.
  Eigen::VectorXd start() const;
  /// Calls parameter i by another name.
  void rename(int i, std::string name) { parameters_[i].name = std::move(name); }

  /// Takes parameters p [size()]. Not to be called while another thread evaluates.
  void set(const Eigen::VectorXd& p) { set(p.data()); }
  virtual void set(const double* p) = 0;

  /// phi(x) [m].
  virtual double value(const Eigen::Vector3d& x) const = 0;
  /// phi(x), dx = d phi/dx [-], and dp[size()] = d phi/dp unless dp is null. At kinks of phi (the
  /// middle of a shape, equal operands of a sharp operation) the gradients of one side.
  virtual double evaluate(const Eigen::Vector3d& x, Eigen::Vector3d& dx, double* dp) const = 0;

  /// Why the parameters set do not make a shape ("hole2.radius is not above 0", an outline that
  /// crosses itself); empty if they do.
  virtual std::string error() const = 0;

  /// The operand of this name at any depth, "hole2", or with its path, "frame.boss"; nothing if
  /// there is none. Below a placement there is none: features there live in its axes.
  virtual std::optional<Part> part(const std::string& /*path*/) const { return std::nullopt; }

 protected:
  LevelSet() = default;
  LevelSet(const LevelSet&) = default;
  LevelSet& operator=(const LevelSet&) = default;

  std::vector<Parameter> parameters_;
};

using LevelSetPtr = std::unique_ptr<LevelSet>;

/// Where a shape is put: x = position + exp(rotation~) X.
/// Write `Pose{{x, y, z}}` for no rotation: `{}` in its place would be a vector without values.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< rotation vector, rad
};

/// The shape moved in the plane: parameters x, y, angle (about z), then its own.
LevelSetPtr placed_in_plane(double x, double y, double angle, LevelSetPtr shape);
/// The shape moved in space: parameters x, y, z, rx, ry, rz (rotation vector), then its own.
LevelSetPtr placed(const Pose& pose, LevelSetPtr shape);

}  // namespace liesl::levelset
