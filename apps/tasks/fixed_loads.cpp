#ifdef LIESL_OPTIM

#include "apps/tasks/fixed_loads.hpp"

#include <algorithm>

#include "mbs/levelset/shape_spec.hpp"
#include "mbs/solids/solid_statics.hpp"

namespace liesl {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 9;  // of a place, spread along it

Json numbers(const Vec3& x) { return {x[0], x[1], x[2]}; }

/// Places of a part, from its first interface, axes of the mesh.
class Places {
 public:
  explicit Places(const SolidSpec& solid)
      : solid_(solid),
        shape_(solid.outline.features.empty() ? nullptr : levelset::make_shape(solid.outline)) {}

  Json port(int interface) const {
    return Json::array({numbers(solid_.interfaces()[static_cast<std::size_t>(interface)].point -
                                solid_.interfaces()[0].point)});
  }

  /// Of an interface or set of that name.
  Json nodes_of(const std::string& name) const {
    for (const Interface& interface : solid_.interfaces())
      if (interface.name == name) return nodes(interface.nodes);
    const auto set = solid_.mesh().sets.find(name);
    return set == solid_.mesh().sets.end() ? Json::array() : nodes(set->second);
  }

  /// Some nodes, in order along the longest side of the box about them.
  Json nodes(const std::vector<int>& all) const {
    std::vector<Vec3> x;
    for (const int node : all)
      if (const Vec3 at = solid_.mesh().nodes.col(node); is_material(at))
        x.push_back(at - solid_.interfaces()[0].point);
    if (x.empty()) return Json::array();
    Vec3 low = x[0], high = x[0];
    for (const Vec3& at : x) {
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    Eigen::Index longest = 0;
    (high - low).maxCoeff(&longest);
    std::ranges::stable_sort(x, {}, [longest](const Vec3& at) { return at[longest]; });
    Json out = Json::array();
    const std::size_t count = std::min(kMostPoints, x.size());
    for (std::size_t k = 0; k < count; ++k)
      out.push_back(numbers(x[count > 1 ? k * (x.size() - 1) / (count - 1) : x.size() / 2]));
    return out;
  }

 private:
  bool is_material(const Vec3& at) const { return !shape_ || shape_->value(at) >= 0; }

  const SolidSpec& solid_;
  const levelset::LevelSetPtr shape_;
};

/// "x_min:x" -> where, and which directions.
Json support(const std::string& text, const SolidSpec& solid, const Places& places) {
  const auto colon = text.find(':');
  const std::string place = text.substr(0, colon), all = solid.mesh().dim == 2 ? "xy" : "xyz";
  if (place == "inertia_relief") return {{"place", place}, {"held", ""}, {"points", Json::array()}};
  const bool port =
      std::ranges::any_of(solid.interfaces(), [&](const Interface& i) { return i.name == place; });
  return {{"place", place},
          {"held", colon == text.npos ? all + (port ? "r" : "") : text.substr(colon + 1)},
          {"points", places.nodes_of(place)}};
}

Json load_of(const FixedLoad& load, const SolidModel& model, const Places& places) {
  Vec3 force = load.force;
  if (load.interface < 0) {
    const int dim = model.mesh().dim;
    const Eigen::VectorXd f = traction_load(model, load.nodes, load.traction);
    force.setZero();
    force.head(dim) = model.rigid_motions().leftCols(dim).transpose() * f;
  }
  return {{"name", load.name},
          {"load_case", load.load_case},
          {"place", load.place},
          {"force", numbers(force)},
          {"moment", numbers(load.moment)},
          {"points", load.interface < 0 ? places.nodes(load.nodes) : places.port(load.interface)}};
}

}  // namespace

void describe_fixed_loads(output::OptimizeSummary& summary, const StudySpec& study, int part,
                          const BodySpec& body) {
  const auto& solid = std::get<SolidSpec>(body.kind);
  const Places places(solid);
  auto& supports = summary.more["supports"] = Json::array();
  const auto given = study.supports.find(part);
  for (const std::string& text :
       given == study.supports.end() ? Support{solid.interfaces().front().name} : given->second)
    supports.push_back(support(text, solid, places));
  auto& loads = summary.more["fixed_loads"] = Json::array();
  for (const FixedLoad& load : study.loads)
    if (load.body == part) loads.push_back(load_of(load, *solid.model, places));
}

}  // namespace liesl

#endif
