#include "optim/cycle/nucleation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "mbs/levelset/shape_spec.hpp"
#include "mbs/solids/mesh_surface.hpp"
#include "optim/nlp/kkt.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/mesh_statics.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;
using levelset::FeatureKind;
using levelset::FeatureSpec;
using levelset::ShapeSpec;

constexpr double kOptimal = 0.05;    // largest residual of the optimality conditions
constexpr double kFull = 1 - 1e-12;  // fraction of a full cell

/// Nodes that a hole keeps away from.
std::vector<char> kept_nodes(const SolidTask& task, const VectorXd& fractions) {
  const SolidModel& model = *task.model;
  const SolidMesh& mesh = model.mesh();
  std::vector<char> kept(static_cast<std::size_t>(mesh.node_count()), 0);
  const auto keep = [&](int node) { kept[static_cast<std::size_t>(node)] = 1; };
  for (const auto& side : outer_sides(mesh))
    for (const int node : side)
      if (node >= 0) keep(node);
  for (const Interface& interface : model.interfaces())
    for (const int node : interface.nodes) keep(node);
  const std::set<int> fixed(task.support.fixed.begin(), task.support.fixed.end());
  for (int node = 0; node < mesh.node_count(); ++node)
    for (int k = 0; k < mesh.dim; ++k)
      if (const auto at = model.coordinate(node, k); at && fixed.count(*at)) keep(node);
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (int c = 0; c < mesh.nodes_per_cell() && fractions[e] < kFull; ++c) keep(mesh.cells(c, e));
  return kept;
}

bool is_clear(const SolidMesh& mesh, const std::vector<char>& kept, const Eigen::Vector3d& x,
              double distance) {
  for (int node = 0; node < mesh.node_count(); ++node)
    if (kept[static_cast<std::size_t>(node)] &&
        (mesh.nodes.col(node) - x).squaredNorm() < distance * distance)
      return false;
  return true;
}

/// The clear place with the largest gain above zero.
std::optional<Nucleus> best_place(const SolidMesh& mesh, const std::vector<char>& kept,
                                  const VectorXd& gain, double wall) {
  const double h = mean_cell_length(mesh), radius = kHoleCells * h;
  std::vector<int> order(static_cast<std::size_t>(gain.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return gain[a] > gain[b]; });
  for (const int e : order) {
    if (!(gain[e] > 0)) break;
    const Eigen::Vector3d x = mesh.corners_of(e).rowwise().mean();
    if (is_clear(mesh, kept, x, radius + std::max(kClearCells * h, wall)))
      return Nucleus{x, radius, gain[e]};
  }
  return std::nullopt;
}

/// By feature or interface: the thinnest of its walls.
std::map<std::string, double> thinnest_walls(const std::vector<WallSpec>& walls) {
  std::map<std::string, double> thinnest;
  for (const WallSpec& w : walls)
    for (const std::string& name : {w.feature, w.to}) {
      const auto at = thinnest.emplace(name, w.least).first;
      at->second = std::min(at->second, w.least);
    }
  return thinnest;
}

std::string free_name(const ShapeSpec& outline, const std::string& stem) {
  for (int i = 1;; ++i) {
    const std::string name = stem + std::to_string(i);
    if (std::none_of(outline.features.begin(), outline.features.end(),
                     [&](const FeatureSpec& f) { return f.name == name; }))
      return name;
  }
}

/// The shape less a feature: one more operand of the difference that it is, or a new difference.
void take_off(FeatureSpec feature, ShapeSpec& outline) {
  std::set<std::string> used;
  for (const FeatureSpec& f : outline.features) used.insert(f.operands.begin(), f.operands.end());
  const auto root = std::find_if(outline.features.begin(), outline.features.end(),
                                 [&](const FeatureSpec& f) { return !used.count(f.name); });
  if (root->kind == FeatureKind::Difference) {
    root->operands.push_back(feature.name);
  } else {
    const std::string whole = root->name;
    outline.features.push_back(
        {free_name(outline, "with_holes"), FeatureKind::Difference, {}, {whole, feature.name}});
  }
  outline.features.push_back(std::move(feature));
}

}  // namespace

HoleProposal propose_hole(const SolidTask& task, const std::vector<WallSpec>& walls,
                          const VectorXd& x) {
  HoleProposal out;
  if (task.weighted()) {
    out.reason = "there is no topological derivative of a weighted objective";
    return out;
  }
  auto owned = std::make_unique<MeshStatics>(task, 1);
  const MeshStatics& part = *owned;
  EslProblem problem(std::move(owned), task.cycle, x);
  if (!problem.undefined_reason().empty()) {
    out.reason = problem.undefined_reason();
    return out;
  }
  const KktResidual kkt = kkt_residual(problem, x);
  if (kkt.stationarity > kOptimal) {
    out.reason = "the design is no optimum: " + kkt.brief();
    return out;
  }
  VectorXd lambda = VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints().size()));
  for (Eigen::Index i = 0; i < lambda.size(); ++i)
    if (const auto at = kkt.multipliers.find(problem.constraints()[i].id);
        at != kkt.multipliers.end())
      lambda[i] = at->second;
  const auto own = static_cast<Eigen::Index>(part.own_rows().size());
  const HoleDerivative lagrangian =
      part.hole_derivative(problem.output_weights(0, lambda), lambda.tail(own));
  if (!lagrangian.missing.empty()) {
    out.reason = "there is no topological derivative of " + lagrangian.missing;
    return out;
  }
  const VectorXd& v = part.statics().fractions();
  out.gain = (v.array() >= kFull).select(-lagrangian.value, 0.0);
  double wall = 0;
  for (const auto& [name, least] : thinnest_walls(walls)) wall = std::max(wall, least);
  out.nucleus = best_place(task.model->mesh(), kept_nodes(task, v), out.gain, wall);
  if (!out.nucleus)
    out.reason =
        out.gain.maxCoeff() > 0
            ? "no place where a hole would reduce the objective is far enough from all edges"
            : "a hole would reduce the objective nowhere";
  return out;
}

std::string insert_hole(const Nucleus& nucleus, const SolidMesh& mesh, ShapeSpec& outline,
                        ShapeDesignSpec& design) {
  const std::string name = free_name(outline, "new_hole");
  FeatureSpec hole{name, mesh.dim == 2 ? FeatureKind::Ellipse : FeatureKind::Ellipsoid, {}, {}};
  const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff(),
                        high = mesh.nodes.rowwise().maxCoeff();
  const double h = mean_cell_length(mesh), longest = (high - low).maxCoeff() / 2;
  for (const auto& p : levelset::feature_parameters(hole.kind, outline.dim)) {
    const bool position = p.name == "x" || p.name == "y" || p.name == "z";
    const bool axis = p.name == "a" || p.name == "b" || p.name == "c";
    const int k = p.name[0] - 'x';
    hole.values.push_back(position ? nucleus.place[k] : axis ? nucleus.radius : 0);
    if (!position && !axis) continue;
    const std::string path = name + "." + p.name;
    design.variables.push_back(
        {path, {{path, 1}}, position ? low[k] : h, position ? high[k] : longest, {}});
  }
  for (const auto& [other, least] : thinnest_walls(design.walls))  // earlier new holes among them
    design.walls.push_back({name + "_" + other, name, other, least});
  take_off(std::move(hole), outline);
  return name;
}

}  // namespace liesl
