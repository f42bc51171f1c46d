/// @file
/// build/bench/bin/bench_formalism_costs [ROW] [RUNS] [clock]: processor time (or time by the
/// clock) of the sensitivities of the slider-crank by four parameters, analytic (direct),
/// semi-analytic and by central differences, in forward runs of the scene, under every formalism,
/// and how far the other two are from the first: a table of docs/sensitivities.md. Instructions of
/// one row: valgrind --tool=callgrind
/// --toggle-collect='*forward_run*' (or '*direct_form*') bench_formalism_costs ROW 1.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "apps/bench/processor_time.hpp"
#include "apps/input/document.hpp"
#include "apps/scene/space.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "mbs/sensitivity/semi_analytic.hpp"
#include "mbs/solvers/dynamics.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kPerturbation = 1e-7, kDifference = 1e-4;  // of a parameter
const std::string kScene = LIESL_DATA_DIR "/scenes/slider_crank.toml";
const std::vector<std::string> kBeam = {"materials.steel.E", "materials.steel.rho",
                                        "sections.rod.diameter", "bodies.slider.rigid.mass"};
const std::vector<std::string> kMesh = {"materials.steel.E", "materials.steel.rho",
                                        "bodies.rod.solid.thickness", "bodies.slider.rigid.mass"};
const std::vector<std::string> kMeshInSpace = {"materials.steel.E", "materials.steel.rho",
                                               "sections.crank.diameter",
                                               "bodies.slider.rigid.mass"};
/// The rod as a mesh, in the place of the beam of the scene.
const std::string kBeamLine = "rod    = { beam ";
const std::string kMeshLine =
    "rod = { solid = { mesh = { from = [0, -0.005], to = [0.3, 0.005], cells = [30, 2] }, "
    "at = [0.15, 0, 0], material = \"steel\", thickness = 0.008, ";
const std::string kMeshInSpaceLine =
    "rod = { solid = { mesh = { from = [0, -0.005, -0.004], to = [0.3, 0.005, 0.004], cells = "
    "[30, 2, 2] }, at = [0.15, 0, 0], material = \"steel\", ";
const std::string kInterfaces = "interfaces = { start = { set = \"x_min\" }, mid = { nodes = [";
const std::string kEnds = "] }, end = { set = \"x_max\" } } } }";

struct Case {
  std::string name;
  std::vector<std::string> changes;
  std::string mesh;  ///< further keys of the meshed rod; empty: it is a beam
  bool in_space() const { return name.ends_with(",space"); }
  /// Amplitudes of modes mean something else at another value of a parameter.
  bool has_modes() const { return name.starts_with("floating") || name.starts_with("reduced"); }
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
    all.push_back(all[i]);
    all.back().name += ",space";
    all.back().changes.push_back("simulation.space=spatial");
  }
  return all;
}

SensitivityProblem problem_of(const Case& row) {
  SceneText scene{load_text(kScene, "a scene in TOML"), kScene, row.changes};
  scene.changes.push_back("simulation.duration=0.02");
  if (row.mesh.empty()) return scene_problem(scene, kBeam);
  const auto from = scene.text.find(kBeamLine), to = scene.text.find('\n', from);
  std::string middle;
  for (int i = 16; i <= (row.in_space() ? 264 : 78); i += 31) middle += fmt::format("{}, ", i);
  scene.text.replace(
      from, to - from,
      (row.in_space() ? kMeshInSpaceLine : kMeshLine) + row.mesh + kInterfaces + middle + kEnds);
  return scene_problem(scene, row.in_space() ? kMeshInSpace : kMesh);
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

/// Adds rows at the end.
void append(MatrixXd& all, const MatrixXd& rows) {
  MatrixXd out(all.rows() + rows.rows(), rows.cols());
  if (all.size() > 0) out.topRows(all.rows()) = all;
  out.bottomRows(rows.rows()) = rows;
  all = out;
}

/// The motion of a row, converged as sensitivities need it, and the ways to its gradients.
template <FrameGroup G>
class Forms {
 public:
  Forms(const SensitivityProblem& problem, const Space<G>& space)
      : problem_(problem),
        space_(space),
        model_(Model<G>::build(problem.scene.mechanism, space)),
        values_(problem.scene.mechanism, model_),
        converged_(problem.scene.simulation) {
    converged_.tolerance = std::min(converged_.tolerance, kSensitivityTolerance);
    simulate(model_, converged_, {}, &tape_);
    for (const Parameter& p : problem.parameters)
      parameters_.emplace_back(problem.scene.mechanism, model_, p);
    const VectorXd p = problem.values();
    for (Eigen::Index i = 0; i < p.size(); ++i) {
      near_.push_back(changed(i, kPerturbation));
      perturbed_.push_back({near_.back().model.get(), kPerturbation * p[i]});
      for (const double share : {kDifference, -kDifference}) apart_.push_back(changed(i, share));
    }
  }
  void scene() const { forward_run(model_, problem_.scene.simulation); }
  void motion() const { simulate(model_, converged_); }
  void direct() const { direct_form<G>(model_, tape_, parameters_); }
  void semi_analytic() const {
    semi_analytic_sensitivity<G>(model_, tape_, perturbed_, {},
                                 [](long, const State<G>&, const StateSensitivity&) {});
  }

  /// p dy/dp of all responses at the end, a column a parameter.
  MatrixXd by_direct() const {
    return at_end([&](const SensitivityAt<G>& at) {
      return direct_sensitivity<G>(model_, tape_, parameters_, at);
    });
  }
  MatrixXd by_semi_analytic() const {
    return at_end([&](const SensitivityAt<G>& at) {
      return semi_analytic_sensitivity<G>(model_, tape_, perturbed_, {}, at);
    });
  }
  MatrixXd by_differences() const {
    MatrixXd out;
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const VectorXd slope =
          (outputs(apart_[2 * i]) - outputs(apart_[2 * i + 1])) / (2 * kDifference);
      append(out, slope.transpose());
    }
    return out.transpose();
  }

 private:
  /// The scene with a parameter changed.
  struct Changed {
    std::unique_ptr<const Mechanism> mechanism;
    std::unique_ptr<const Model<G>> model;
  };
  Changed changed(Eigen::Index i, double share) const {
    VectorXd p = problem_.values();
    p[i] *= 1 + share;
    auto mechanism = std::make_unique<const Mechanism>(problem_.mechanism_at(p));
    auto model = std::make_unique<const Model<G>>(Model<G>::build(*mechanism, space_));
    return {std::move(mechanism), std::move(model)};
  }
  template <class Form>
  MatrixXd at_end(const Form& form) const {
    MatrixXd out;
    const long last = tape_.steps();
    form([&](long step, const State<G>& s, const StateSensitivity& ds) {
      for (const ResponseSpec& response : problem_.scene.responses)
        if (step == last)
          append(out, ResponseSensitivity<G>(model_, values_, response, parameters_)(s, ds));
    });
    return out * problem_.values().asDiagonal();
  }
  VectorXd outputs(const Changed& at) const {
    const auto run = simulate(*at.model, converged_);
    State<G> s = at.model->initial_state();
    run.trajectory.read(run.trajectory.size() - 1, s);
    const ResponseValues<G> values(*at.mechanism, *at.model);
    MatrixXd y;
    for (const ResponseSpec& response : problem_.scene.responses) append(y, values(response, s));
    return y;
  }

  const SensitivityProblem& problem_;
  const Space<G> space_;
  const Model<G> model_;
  const ResponseValues<G> values_;
  SimulationOptions converged_;
  Tape<G> tape_;
  Parameters<G> parameters_;
  std::vector<Changed> near_, apart_;
  std::vector<PerturbedModel<G>> perturbed_;
};

/// By turns: the scene as given, the motion converged as sensitivities need it, the three forms.
template <FrameGroup G>
void measure(const Case& row, const SensitivityProblem& problem, const Space<G>& space, int runs,
             Clock clock) {
  const Forms<G> forms(problem, space);
  std::vector<double> scene, motion, direct, semi, differences;
  for (int i = 0; i < runs; ++i) {
    scene.push_back(clock([&] { forms.scene(); }));
    motion.push_back(clock([&] { forms.motion(); }));
    direct.push_back(clock([&] { forms.direct(); }));
    if (!row.has_modes()) semi.push_back(clock([&] { forms.semi_analytic(); }));
    differences.push_back(clock([&] { forms.by_differences(); }));
  }
  const double run = median(scene);
  const MatrixXd exact = forms.by_direct();
  const double size = exact.colwise().norm().maxCoeff();
  const auto off = [&](const MatrixXd& found) {
    if (size == 0) return std::string("none");  // the motion does not depend on the parameters
    return fmt::format("{:.0e}", (found - exact).colwise().norm().maxCoeff() / size);
  };
  fmt::print(
      "| {:<16} | {:7.2f} | {:7.2f} | {:5.2f} | {:5.2f} | {:>5} | {:5.2f} | {:>6} | {:>6} |\n",
      row.name, 1e3 * run, 1e3 * median(motion), median(direct) / run,
      median(direct) / median(motion),
      semi.empty() ? "" : fmt::format("{:.2f}", median(semi) / run), median(differences) / run,
      semi.empty() ? "" : off(forms.by_semi_analytic()), off(forms.by_differences()));
  std::fflush(stdout);
}

}  // namespace
}  // namespace liesl

int main(int argc, char** argv) {
  using namespace liesl;
  const std::string only = argc > 1 ? argv[1] : "";
  const int runs = argc > 2 ? std::atoi(argv[2]) : 7;
  const Clock clock = argc > 3 && std::string_view(argv[3]) == "clock" ? clock_seconds : seconds;
  fmt::print("| {:<16} | run ms  | to 1e-8 | direct | of it | semi  | diff. | semi   | diff.  |\n",
             "row");
  for (const Case& row : cases()) {
    if (!only.empty() && row.name != only) continue;
    const SensitivityProblem problem = problem_of(row);
    const ChosenSpace chosen = choose_space(problem.scene);
    std::visit([&](const auto& space) { measure(row, problem, space, runs, clock); }, chosen.space);
  }
}
