#include "mbs/levelset/shape_spec.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "mbs/levelset/closed_curve.hpp"
#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"

namespace liesl::levelset {
namespace {

constexpr int kOwn[] = {0, 1, 3, 2, 4, 7, 0, 0, 0, 1, 4, 3, 1};  // parameters, by FeatureKind

int placement(int dim) { return dim == 2 ? 3 : 6; }

int per_point(FeatureKind kind) { return kind == FeatureKind::Nurbs ? 3 : 2; }

LevelSetPtr make_curve(FeatureKind kind, const double* v, int points) {
  std::vector<Eigen::Vector2d> p;
  for (int i = 0; i < points; ++i) p.emplace_back(v[2 * i], v[2 * i + 1]);
  if (kind == FeatureKind::Nurbs)
    return closed_curve(CurveKind::Nurbs, p, {v + 2 * points, v + 3 * points});
  return closed_curve(kind == FeatureKind::Spline ? CurveKind::Spline : CurveKind::Polyline, p);
}

/// A feature at the origin; v: its own values.
LevelSetPtr make_own(FeatureKind kind, const double* v, int points) {
  switch (kind) {
    case FeatureKind::HalfSpace:
      return half_space();
    case FeatureKind::Circle:
      return circle(v[0]);
    case FeatureKind::Rectangle:
      return rectangle(v[0], v[1], v[2]);
    case FeatureKind::Ellipse:
      return ellipse(v[0], v[1]);
    case FeatureKind::SuperEllipse:
      return super_ellipse(v[0], v[1], v[2], v[3]);
    case FeatureKind::Superformula:
      return superformula({v[0], v[1], v[2], v[3], v[4], v[5], v[6]});
    case FeatureKind::Sphere:
      return sphere(v[0]);
    case FeatureKind::Box:
      return box(v[0], v[1], v[2], v[3]);
    case FeatureKind::Ellipsoid:
      return ellipsoid(v[0], v[1], v[2]);
    case FeatureKind::Slab:
      return slab(v[0]);
    default:
      return make_curve(kind, v, points);
  }
}

/// By name; which features are operands of another one.
struct Index {
  explicit Index(const ShapeSpec& shape) {
    for (const FeatureSpec& f : shape.features) {
      by_name.emplace(f.name, &f);
      for (const std::string& operand : f.operands) ++uses[operand];
    }
    for (const FeatureSpec& f : shape.features)
      if (!uses.count(f.name)) roots.push_back(&f);
  }
  std::map<std::string, const FeatureSpec*> by_name;
  std::map<std::string, int> uses;
  std::vector<const FeatureSpec*> roots;
};

constexpr int kDeepest = 200;  ///< operations above a feature; shapes are evaluated by recursion

/// Level by level from the roots: features that no root reaches, and operations nested too deeply.
void depth_errors(const ShapeSpec& shape, const Index& index, std::vector<ShapeError>& found) {
  std::set<std::string> reached;
  std::vector<const FeatureSpec*> level = index.roots;
  for (int above = 0; !level.empty(); ++above) {
    if (above > kDeepest) {
      found.push_back({level[0]->name, "lies under more than " + std::to_string(kDeepest) +
                                           " nested operations: one operation may have many "
                                           "features, of = [\"a\", \"b\", \"c\"]"});
      return;
    }
    std::vector<const FeatureSpec*> below;
    for (const FeatureSpec* f : level) {
      if (!reached.insert(f->name).second) continue;
      for (const std::string& operand : f->operands) below.push_back(index.by_name.at(operand));
    }
    level = std::move(below);
  }
  for (const FeatureSpec& f : shape.features)
    if (!reached.count(f.name)) {
      found.push_back({f.name, "is a part of itself"});
      break;
    }
}

void operand_errors(const Index& index, const FeatureSpec& f, std::vector<ShapeError>& found) {
  if (f.operands.empty()) found.push_back({f.name, "has no features to work on"});
  if (f.kind == FeatureKind::Mirror) {
    if (f.operands.size() > 1)
      found.push_back({f.name, "mirrors more than one feature: unite them first"});
  } else if (!f.values.empty() && !(f.values[0] >= 0)) {
    found.push_back({f.name, "has a negative radius"});
  }
  std::set<std::string> own;
  for (const std::string& operand : f.operands) {
    if (!index.by_name.count(operand))
      found.push_back({f.name, "works on '" + operand + "', which is no feature"});
    else if (!own.insert(operand).second)
      found.push_back({f.name, "works on '" + operand + "' twice"});
    else if (operand == f.name)
      found.push_back({f.name, "works on itself"});
  }
}

void tree_errors(const ShapeSpec& shape, const Index& index, std::vector<ShapeError>& found) {
  for (const FeatureSpec& f : shape.features)
    if (const auto at = index.uses.find(f.name); at != index.uses.end() && at->second > 1)
      found.push_back({f.name, "is used by more than one operation"});
  for (std::size_t i = 1; i < index.roots.size(); ++i)
    found.push_back({index.roots[i]->name, "and '" + index.roots[0]->name +
                                               "' are parts of nothing: one of the features must "
                                               "be an operation on all that is left"});
  depth_errors(shape, index, found);
}

/// Calls visit(feature) in the order of the parameters.
template <class Features, class Visit>
void traverse(const Index& index, Features& features, const std::string& name, const Visit& visit) {
  const auto at = index.by_name.at(name) - features.data();
  for (const std::string& operand : index.by_name.at(name)->operands)
    traverse(index, features, operand, visit);
  visit(features[static_cast<std::size_t>(at)]);
}

LevelSetPtr make_mirror(const FeatureSpec& f, int dim, Operand shape) {
  const double* v = f.values.data();
  if (static_cast<int>(f.values.size()) != placement(dim))
    throw std::invalid_argument("mirror '" + f.name + "' has no placement that fits");
  LevelSetPtr both = dim == 2
                         ? mirrored_in_plane(v[0], v[1], v[2], std::move(shape))
                         : mirrored(Pose{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}, std::move(shape));
  for (int i = both->size() - placement(dim); i < both->size(); ++i)
    both->rename(i, f.name + "." + both->parameters()[i].name);
  return both;
}

LevelSetPtr make_tree(const Index& index, const FeatureSpec& f, int dim) {
  if (!is_operation(f.kind)) {
    LevelSetPtr shape = make_feature(f, dim);
    for (int i = 0; i < shape->size(); ++i)
      shape->rename(i, f.name + "." + shape->parameters()[i].name);
    return shape;
  }
  if (f.kind == FeatureKind::Mirror)
    return make_mirror(
        f, dim, {"", make_tree(index, *index.by_name.at(f.operands.at(0)), dim), f.operands[0]});
  std::vector<Operand> operands;
  for (const std::string& operand : f.operands)
    operands.push_back({"", make_tree(index, *index.by_name.at(operand), dim), operand});
  std::optional<double> radius;
  if (!f.values.empty()) radius = f.values[0];
  LevelSetPtr shape = f.kind == FeatureKind::Union          ? unite(std::move(operands), radius)
                      : f.kind == FeatureKind::Intersection ? intersect(std::move(operands), radius)
                                                            : subtract(std::move(operands), radius);
  if (radius) shape->rename(shape->size() - 1, f.name + ".radius");
  return shape;
}

}  // namespace

std::vector<Parameter> feature_parameters(FeatureKind kind, int dim) {
  if (is_curve(kind) || kind == FeatureKind::Mirror)
    kind = FeatureKind::HalfSpace;  // has a placement only
  const int count = placement(dim) + kOwn[static_cast<int>(kind)];
  return make_feature({"", kind, std::vector<double>(count, 1.0), {}}, dim)->parameters();
}

std::vector<ShapeError> shape_errors(const ShapeSpec& shape) {
  std::vector<ShapeError> found;
  const Index index(shape);
  for (const FeatureSpec& f : shape.features) {
    if (index.by_name.at(f.name) != &f) found.push_back({f.name, "is there twice"});
    if (is_operation(f.kind)) {
      operand_errors(index, f, found);
    } else if (shape.dim == 2 && is_spatial(f.kind)) {
      found.push_back({f.name, "does not exist in the plane"});
    } else {
      try {
        if (const std::string error = make_feature(f, shape.dim)->error(); !error.empty())
          found.push_back({f.name, "makes no shape: " + error});
      } catch (const std::invalid_argument& error) {
        found.push_back({f.name, std::string("makes no shape: ") + error.what()});
      }
    }
  }
  if (found.empty()) tree_errors(shape, index, found);
  return found;
}

LevelSetPtr make_feature(const FeatureSpec& f, int dim) {
  if (is_operation(f.kind)) throw std::invalid_argument("'" + f.name + "' is an operation");
  const int given = static_cast<int>(f.values.size()), own = given - placement(dim);
  const bool curve = is_curve(f.kind);
  if (curve ? own < 0 || own % per_point(f.kind) != 0 : own != kOwn[static_cast<int>(f.kind)])
    throw std::invalid_argument("feature '" + f.name + "' has " + std::to_string(given) +
                                " values, which do not fit its kind");
  const double* v = f.values.data();
  LevelSetPtr shape = make_own(f.kind, v + placement(dim), curve ? own / per_point(f.kind) : 0);
  if (dim == 2) return placed_in_plane(v[0], v[1], v[2], std::move(shape));
  return placed(Pose{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}, std::move(shape));
}

LevelSetPtr make_shape(const ShapeSpec& shape) {
  if (const auto found = shape_errors(shape); !found.empty())
    throw std::invalid_argument("feature '" + found[0].feature + "' " + found[0].text);
  const Index index(shape);
  if (index.roots.empty()) throw std::invalid_argument("the shape has no features");
  return make_tree(index, *index.roots[0], shape.dim);
}

void set_values(ShapeSpec& shape, const Eigen::VectorXd& p) {
  const Index index(shape);
  const double* next = p.data();
  traverse(index, shape.features, index.roots.at(0)->name, [&](FeatureSpec& f) {
    if (next + f.values.size() > p.data() + p.size())
      throw std::invalid_argument("too few values for the parameters of the shape");
    std::copy_n(next, f.values.size(), f.values.begin());
    next += f.values.size();
  });
}

}  // namespace liesl::levelset
