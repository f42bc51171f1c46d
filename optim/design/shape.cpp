#include "optim/design/shape.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "mbs/levelset/wall.hpp"
#include "mbs/solids/mesh_surface.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;
using levelset::LevelSet;

/// "known: a, b, c", cut after some.
std::string known(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 12;
  std::string text = "; known:";
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
    text += (i ? ", " : " ") + names[i];
  return text + (names.size() > kMost ? ", ..." : "");
}

/// Features of the tree: what stands before the last point of a parameter's path.
std::vector<std::string> feature_names(const LevelSet& shape) {
  std::set<std::string> names;
  for (const auto& p : shape.parameters())
    if (const auto point = p.name.rfind('.'); point != std::string::npos)
      names.insert(p.name.substr(0, point));
  return {names.begin(), names.end()};
}

}  // namespace

ShapeDesign::ShapeDesign(ShapeDesignSpec spec, LevelSet& shape, const SolidModel& model)
    : shape_(shape), model_(model), p0_(shape.start()), owner_(shape.size()) {
  std::vector<std::string> errors;
  x0_.resize(static_cast<Eigen::Index>(spec.variables.size()));
  for (const auto& v : spec.variables) add_variable(v, errors);
  jacobian_.resize(shape.size(), size());
  jacobian_.setFromTriplets(entries_.begin(), entries_.end());
  if (errors.empty())
    for (int j = 0; j < size(); ++j) check_bounds(spec.variables[j], j, errors);
  for (const auto& w : spec.walls) add_wall(w, errors);
  refuse_if("shape variables:", errors);
}

int ShapeDesign::parameter_named(const std::string& name, std::vector<std::string>& errors) const {
  const auto& all = shape_.parameters();
  for (int k = 0; k < shape_.size(); ++k)
    if (all[k].name == name) return k;
  std::vector<std::string> names;
  for (const auto& p : all) names.push_back(p.name);
  errors.push_back("the shape has no parameter '" + name + "'" + known(names));
  return -1;
}

void ShapeDesign::add_variable(const ShapeVariableSpec& v, std::vector<std::string>& errors) {
  const int j = size();
  NlpVariable variable{v.name, v.lower, v.upper, 0};
  units_.emplace_back();
  x0_[j] = 0;
  if (v.drives.empty()) errors.push_back("'" + v.name + "' moves no parameter");
  if (!(v.lower < v.upper || (!v.values.empty() && v.lower == v.upper)))
    errors.push_back(fmt::format("'{}': bounds [{:g}, {:g}], expected least < largest", v.name,
                                 v.lower, v.upper));
  for (std::size_t d = 0; d < v.drives.size(); ++d) {
    const int k = parameter_named(v.drives[d].name, errors);
    if (k < 0) continue;
    if (!owner_[k].empty())
      errors.push_back(fmt::format("'{}': parameter '{}' already follows '{}'", v.name,
                                   v.drives[d].name, owner_[k]));
    owner_[k] = v.name;
    entries_.emplace_back(k, j, v.drives[d].factor);
    if (d > 0) continue;
    x0_[j] = p0_[k];
    units_[j] = shape_.parameters()[k].unit;
  }
  variable.start = v.start.value_or(x0_[j]);
  if (variable.start < v.lower || variable.start > v.upper)
    errors.push_back(fmt::format("'{}': the start {:g} is outside the bounds [{:g}, {:g}]", v.name,
                                 variable.start, v.lower, v.upper));
  variables_.push_back(variable);
}

/// Each variable alone, at both bounds: is there still a shape?
void ShapeDesign::check_bounds(const ShapeVariableSpec& v, int j,
                               std::vector<std::string>& errors) {
  for (const double bound : {v.lower, v.upper}) {
    VectorXd x = start();
    x[j] = bound;
    const VectorXd p = parameters(x);
    std::string defect;
    for (const auto& d : v.drives)
      for (int k = 0; k < shape_.size(); ++k)
        if (const auto& q = shape_.parameters()[k]; q.name == d.name && !(p[k] > q.above))
          defect = fmt::format(
              "'{}' becomes {:g}, which turns the feature inside out; it has to be "
              "{} {:g}",
              q.name, p[k], q.above < 0 ? ">=" : ">", std::max(q.above, 0.0));
    shape_.set(p);
    if (defect.empty()) defect = shape_.error();
    shape_.set(p0_);
    if (!defect.empty())
      errors.push_back(fmt::format("'{}' at its bound {:g}: {}", v.name, bound, defect));
  }
}

void ShapeDesign::add_wall(const WallSpec& w, std::vector<std::string>& errors) {
  if (!(w.least > 0))
    errors.push_back(
        fmt::format("wall '{}': least {:g}, expected a thickness > 0", w.name, w.least));
  const auto a = shape_.part(w.feature), b = shape_.part(w.to);
  if (!a)
    errors.push_back("wall '" + w.name + "': the shape has no feature '" + w.feature + "'" +
                     known(feature_names(shape_)));
  if (a && b) {
    walls_.push_back({*a, *b, -1, w.least, sampled(*a), sampled(*b)});
    wall_names_.push_back(w.name);
    return;
  }
  const auto& ports = model_.interfaces();
  const auto port =
      std::find_if(ports.begin(), ports.end(), [&](const Interface& i) { return i.name == w.to; });
  if (port == ports.end()) {
    std::vector<std::string> names = feature_names(shape_);
    for (const auto& i : ports) names.push_back(i.name);
    errors.push_back("wall '" + w.name + "': '" + w.to + "' is neither a feature nor an interface" +
                     known(names));
  } else if (a) {
    for (const int node : port->nodes) {
      walls_.push_back({*a, {}, node, w.least});
      wall_names_.push_back(fmt::format("{} at node {}", w.name, node));
    }
  }
}

/// Index of a feature among those that are sampled for walls.
int ShapeDesign::sampled(const levelset::Part& part) {
  const auto at = std::find_if(sampled_.begin(), sampled_.end(), [&](const levelset::Part& p) {
    return p.shape == part.shape && p.sign == part.sign;
  });
  const auto index = static_cast<int>(at - sampled_.begin());
  if (at == sampled_.end()) sampled_.push_back(part);
  return index;
}

VectorXd ShapeDesign::start() const {
  VectorXd x(size());
  for (int j = 0; j < size(); ++j) x[j] = variables_[j].start;
  return x;
}

VectorXd ShapeDesign::parameters(const VectorXd& x) const { return p0_ + jacobian_ * (x - x0_); }

VectorXd ShapeDesign::step_bounds(const FractionGradient& dv, double cells) const {
  const SolidMesh& mesh = model_.mesh();
  VectorXd speed = VectorXd::Zero(size()), dp(shape_.size());
  for (int e = 0; e < mesh.cell_count(); ++e) {
    if (!FractionGradient::InnerIterator(dv, e)) continue;
    Eigen::Vector3d dx;
    shape_.evaluate(mesh.corners_of(e).rowwise().mean(), dx, dp.data());
    if (dx.norm() > 0) speed = speed.cwiseMax((jacobian_.transpose() * dp).cwiseAbs() / dx.norm());
  }
  const double h = mean_cell_length(mesh);
  VectorXd out(size());
  for (int j = 0; j < size(); ++j)
    out[j] = speed[j] > 0 ? cells * h / speed[j] : std::numeric_limits<double>::infinity();
  return out;
}

VectorXd ShapeDesign::walls(RowMatrix* dg) const {
  std::vector<VectorXd> voids(sampled_.size());
  tbb::parallel_for(std::size_t{0}, voids.size(), [&](std::size_t i) {
    voids[i] = levelset::void_at(sampled_[i], model_.mesh().nodes);
  });
  VectorXd g(static_cast<Eigen::Index>(walls_.size()));
  tbb::parallel_for(std::size_t{0}, walls_.size(), [&](std::size_t i) {
    const WallRow& w = walls_[i];
    double thickness = 0;
    VectorXd slope = VectorXd::Zero(shape_.size());
    if (w.b.shape) {
      const levelset::Wall wall = levelset::wall_between(w.a, w.b, voids[w.void_a], voids[w.void_b],
                                                         model_.mesh().nodes, shape_.size());
      thickness = wall.thickness;
      slope = wall.derivative;
    } else {
      Eigen::Vector3d dx;
      VectorXd dp(w.a.shape->size());
      thickness = w.a.sign * w.a.shape->evaluate(model_.mesh().nodes.col(w.node), dx, dp.data());
      slope.segment(w.a.first, dp.size()) = w.a.sign * dp;
    }
    const auto row = static_cast<Eigen::Index>(i);
    g[row] = 1 - thickness / w.least;
    if (dg) dg->row(row) = -(jacobian_.transpose() * slope).transpose() / w.least;
  });
  return g;
}

}  // namespace liesl
