/// @file
/// build/bench/bin/bench_formalism_costs [ROW] [RUNS]: processor time of the direct sensitivities
/// of the slider-crank by four parameters, in forward runs of the scene, under every formalism: a
/// table of docs/sensitivities.md. Instructions of one row: valgrind --tool=callgrind
/// --toggle-collect='*forward_run*' (or '*direct_form*') bench_formalism_costs ROW 1.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "apps/bench/processor_time.hpp"
#include "apps/input/document.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "mbs/sensitivity/motion_sensitivity.hpp"
#include "mbs/solvers/dynamics.hpp"

namespace liesl {
namespace {

const std::string kScene = LIESL_DATA_DIR "/scenes/slider_crank.toml";
const std::vector<std::string> kBeam = {"materials.steel.E", "materials.steel.rho",
                                        "sections.rod.diameter", "bodies.slider.rigid.mass"};
const std::vector<std::string> kMesh = {"materials.steel.E", "materials.steel.rho",
                                        "bodies.rod.solid.thickness", "bodies.slider.rigid.mass"};
/// The rod as a mesh, in the place of the beam of the scene.
const std::string kBeamLine = "rod    = { beam ";
const std::string kMeshLine =
    "rod = { solid = { mesh = { from = [0, -0.005], to = [0.3, 0.005], cells = [30, 2] }, "
    "at = [0.15, 0, 0], material = \"steel\", thickness = 0.008, ";
const std::string kInterfaces =
    "interfaces = { start = { set = \"x_min\" }, end = { set = \"x_max\" } } } }";

struct Case {
  std::string name;
  std::vector<std::string> changes;
  std::string mesh;  ///< further keys of the meshed rod; empty: it is a beam
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* formalism : {"se3", "r3so3", "classical", "floating", "rigid", "segments"})
    all.push_back({formalism, {std::string("simulation.formalism=") + formalism}, ""});
  for (const char* form : {"penalty", "augmented"})
    all.push_back({form, {std::string("simulation.constraints=") + form}, ""});
  all.push_back({"reduced", {}, "modes = 6,"});
  all.push_back({"continuum", {}, "as = \"continuum\","});
  const std::size_t planar = all.size();
  for (std::size_t i = 0; i < planar; ++i) {
    if (all[i].name == "segments" || !all[i].mesh.empty()) continue;
    all.push_back(all[i]);
    all.back().name += ",space";
    all.back().changes.push_back("simulation.space=spatial");
  }
  return all;
}

SensitivityProblem problem_of(const Case& row) {
  SceneText scene{load_text(kScene, "a scene in TOML"), kScene, row.changes};
  scene.changes.push_back("simulation.duration=0.02");
  if (!row.mesh.empty()) {
    const auto from = scene.text.find(kBeamLine), to = scene.text.find('\n', from);
    scene.text.replace(from, to - from, kMeshLine + row.mesh + kInterfaces);
    const auto bend = scene.text.find("bend     =");
    scene.text.erase(bend, scene.text.find('\n', bend) - bend);
  }
  return scene_problem(scene, row.mesh.empty() ? kBeam : kMesh);
}

template <FrameGroup G>
[[gnu::noinline]] void forward_run(const Model<G>& model, const SimulationOptions& options) {
  simulate(model, options);
}

template <FrameGroup G>
[[gnu::noinline]] double direct_form(const Model<G>& model, const Tape<G>& tape,
                                     const Parameters<G>& parameters) {
  double sum = 0;
  direct_sensitivity<G>(
      model, tape, parameters,
      [&](long, const State<G>&, const StateSensitivity& ds) { sum += ds.eta(0, 0); });
  return sum;
}

/// By turns: the scene as given, the motion converged as sensitivities need it, the direct form.
template <FrameGroup G>
void measure(const Case& row, const SensitivityProblem& problem, const Space<G>& space, int runs) {
  const Mechanism& mechanism = problem.scene.mechanism;
  const auto model = Model<G>::build(mechanism, space);
  SimulationOptions converged = problem.scene.simulation;
  converged.tolerance = std::min(converged.tolerance, kSensitivityTolerance);
  Tape<G> tape;
  simulate(model, converged, {}, &tape);
  Parameters<G> parameters;
  for (const Parameter& p : problem.parameters) parameters.emplace_back(mechanism, model, p);
  std::vector<double> scene, motion, direct;
  for (int i = 0; i < runs; ++i) {
    scene.push_back(seconds([&] { forward_run(model, problem.scene.simulation); }));
    motion.push_back(seconds([&] { simulate(model, converged); }));
    direct.push_back(seconds([&] { direct_form<G>(model, tape, parameters); }));
  }
  fmt::print("| {:<16} | {:8.2f} | {:8.2f} | {:8.2f} | {:5.2f} | {:5.2f} |\n", row.name,
             1e3 * median(scene), 1e3 * median(motion), 1e3 * median(direct),
             median(direct) / median(scene), median(direct) / median(motion));
  std::fflush(stdout);
}

}  // namespace
}  // namespace liesl

int main(int argc, char** argv) {
  using namespace liesl;
  const std::string only = argc > 1 ? argv[1] : "";
  const int runs = argc > 2 ? std::atoi(argv[2]) : 7;
  fmt::print("| {:<16} | scene ms | to 1e-8  | direct   | ratio | to it |\n", "row");
  for (const Case& row : cases()) {
    if (!only.empty() && row.name != only) continue;
    const SensitivityProblem problem = problem_of(row);
    const ChosenSpace chosen = choose_space(problem.scene);
    std::visit([&](const auto& space) { measure(row, problem, space, runs); }, chosen.space);
  }
}
