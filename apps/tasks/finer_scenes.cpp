#include "apps/tasks/finer_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/input/problem.hpp"
#include "apps/scene/load_scene.hpp"

namespace liesl {
namespace {

constexpr double kIterated = 1e-8;  // tolerance that leaves nothing of the iterations to see

/// The same place of a response where beams have `n / before` times as many elements.
void move_element(ResponseSpec& r, int n, int before) {
  const int middle = (2 * r.element + 1) * n / before;  // of the element, in halves of the new ones
  if (r.place == ElementPlace::Middle && middle % 2 == 0) {
    r.element = middle / 2 - 1;
    r.place = ElementPlace::Last;
  } else if (r.place == ElementPlace::Middle) {
    r.element = middle / 2;
  } else if (r.place == ElementPlace::Last) {
    r.element = (r.element + 1) * n / before - 1;
  } else {
    r.element = r.element * n / before;
  }
}

/// The same place of a response where beams have other numbers of elements.
ResponseSpec on_mesh(ResponseSpec r, const Mechanism& from, const Mechanism& to) {
  const auto count = [](const Mechanism& m, int body) {
    const auto* beam =
        body >= 0 ? std::get_if<BeamSpec>(&m.bodies[static_cast<size_t>(body)].kind) : nullptr;
    return beam ? static_cast<int>(beam->sections.size()) : 1;
  };
  for (Port* port : {&r.at, &r.to})
    port->node = port->node * count(to, port->body) / count(from, port->body);
  move_element(r, count(to, r.body), count(from, r.body));
  return r;
}

}  // namespace

FinerScenes::FinerScenes(const VerifiedScene& source, const Scene& scene, const std::string& space,
                         std::vector<std::string>& warnings)
    : source_(source),
      overrides_(source.overrides),
      mechanism_(scene.mechanism),
      warnings_(warnings),
      given_(setting_of(scene)) {
  if (!space.empty()) overrides_.push_back(fmt::format("simulation.space=\"{}\"", space));
  if (scene.simulation.tolerance > kIterated)
    iterated_.push_back(fmt::format("simulation.tolerance={}", kIterated));
  if (scene.simulation.type == SimulationType::Dynamic && scene.simulation.adaptive)
    error_tolerance_ = scene.simulation.error_tolerance;
  keep_named_places(scene);
  find_grids(scene);
  find_order(scene);
}

std::optional<Scene> FinerScenes::readable(const Changes& changes) const {
  try {
    return read(changes);
  } catch (const InputError&) {
    return {};
  }
}

bool FinerScenes::keeps_places(const Scene& scene, const BeamSetting& beam) const {
  Setting finer = given_;
  BeamSetting& refined = finer.beams[static_cast<std::size_t>(&beam - given_.beams.data())];
  refined.elements *= 2;
  const std::optional<Scene> twice = readable(changes(finer, given_));
  const int body = scene.mechanism.body(beam.name);
  return twice && places(scene, body) == places(*twice, body);
}

/// A mesh that moves a place of the scene is of another mechanism: places that it names by number
/// stay those of its own mesh.
void FinerScenes::keep_named_places(const Scene& scene) {
  Setting twice = given_;
  for (auto& beam : twice.beams)
    if (2 * beam.elements <= kMostElements) beam.elements *= 2;
  const std::optional<Scene> finer = readable(changes(twice, given_));
  for (auto& beam : given_.beams) {
    const int body = scene.mechanism.body(beam.name);
    if (2 * beam.elements > kMostElements) {
      beam.multiple = 0;
      leave_out("beam " + beam.name, "it has no room for twice its elements");
      continue;
    }
    if (finer && places(scene, body) == places(*finer, body)) continue;
    if (!finer && keeps_places(scene, beam)) continue;
    beam.numbering = beam.elements;
    if (keeps_places(scene, beam)) continue;
    beam.multiple = beam.numbering = 0;
    leave_out("beam " + beam.name,
              "the scene names the middle of an element, or its sections would change elsewhere");
  }
}

void FinerScenes::leave_out(const std::string& what, const std::string& why) {
  left_out_.push_back(what);
  warnings_.push_back(fmt::format("the error of the mesh leaves out {}: {}", what, why));
}

/// Of the meshed parts, those that can have twice their cells in each direction.
void FinerScenes::find_grids(const Scene& scene) {
  for (const PartGrid& grid : part_grids({source_.text, source_.file, overrides_}, scene.mechanism))
    if (grid.cells.empty())
      leave_out("part " + grid.name, "its mesh is not a grid of the scene");
    else if (!grid.has_room())
      leave_out("part " + grid.name, "it has no room for twice its cells");
    else
      grids_.push_back(grid);
}

/// The lowest of beams and parts: that of their elements, 2 for the constant sections of a taper.
void FinerScenes::find_order(const Scene& scene) {
  for (const auto& setting : given_.beams) {
    const auto& body =
        scene.mechanism.bodies[static_cast<size_t>(scene.mechanism.body(setting.name))];
    const auto& beam = std::get<BeamSpec>(body.kind);
    if (setting.multiple > 0)
      mesh_order_ = std::min(mesh_order_, beam.ends.empty() ? beam.order : 2);
  }
  for (const PartGrid& grid : grids_) mesh_order_ = std::min(mesh_order_, grid.order);
}

Setting FinerScenes::beams(double factor) const {
  Setting s = given_.refined(factor);
  s.steps = given_.steps;
  return s;
}

auto FinerScenes::with_mesh(double factor) const -> Changes {
  Changes all = changes(beams(factor), given_);
  const Changes grids = grid_changes(grids_, factor);
  all.insert(all.end(), grids.begin(), grids.end());
  return all;
}

/// A local error, which an adapted step keeps, is of the third order in the step.
auto FinerScenes::with_steps(double factor) const -> Changes {
  Setting s = given_;
  s.steps = std::lround(factor * static_cast<double>(given_.steps));
  Changes all = changes(s, given_);
  if (all.empty()) return all;
  all.insert(all.end(), iterated_.begin(), iterated_.end());
  if (error_tolerance_)
    all.push_back(fmt::format("simulation.error_tolerance={:.12g}",
                              *error_tolerance_ / std::pow(factor, kStepOrder + 1)));
  return all;
}

bool FinerScenes::mesh_halves() const {
  const Setting half = beams(0.5);
  for (std::size_t i = 0; i < half.beams.size(); ++i)
    if (given_.beams[i].multiple > 0 && 2 * half.beams[i].elements != given_.beams[i].elements)
      return false;
  return grids_.empty() || !grid_changes(grids_, 0.5).empty();
}

Scene FinerScenes::read(const Changes& more) const {
  auto all = overrides_;
  all.insert(all.end(), more.begin(), more.end());
  Scene scene = read_scene(source_.text, source_.file, all);
  if (!source_.responses.empty()) scene.responses.clear();
  for (const ResponseSpec& r : source_.responses)
    scene.responses.push_back(on_mesh(r, mechanism_, scene.mechanism));
  return scene;
}

}  // namespace liesl
