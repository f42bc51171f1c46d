/// @file
/// build/bench/bin/bench_sensitivities [FILE.csv [ELEMENTS]]: accuracy and time of the ways to
/// gradients of a motion, over the number of variables: the figures of docs/sensitivities.md.

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>

#include "apps/bench/processor_time.hpp"
#include "mbs/model/curves.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "mbs/sensitivity/semi_analytic.hpp"
#include "mbs/solvers/dynamics.hpp"
#include "mbs/system/plane.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kElements = 400, kSteps = 100;  // unless asked for
constexpr double kPerturbation = 1e-7;        // of a height, semi-analytic form
constexpr std::size_t kTurns = 3;             // of a form and the motion, at least
constexpr double kLong = 3,
                 kEnough = 0.5;  // s: one turn of forms that take long, many of short ones

/// That of data/scenes/pendulum.toml.
Mechanism pendulum(int elements, Formalism formalism = Formalism::SE3) {
  BeamSpec beam;
  beam.nodes = straight({0, 0, 0}, {1, 0, 0}, elements);
  beam.material = {"soft", 5e8, 0.3, 7800};
  Section section{"square", Rectangle{0.01, 0.01}, {5. / 6, 5. / 6}, 0.1406e-8};
  beam.sections.assign(static_cast<std::size_t>(elements), section);
  Mechanism m;
  m.formalism = formalism;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"beam", beam}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  return m;
}

SimulationOptions simulation() {
  SimulationOptions o;
  o.step = 1e-3;
  o.duration = kSteps * o.step;
  o.tolerance = 1e-8;
  return o;
}

/// A pendulum whose heights are the variables, in groups of neighbours.
template <FrameGroup G>
struct Pendulum {
  int elements;
  Space<G> space;
  SimulationOptions options = simulation();
  Mechanism mechanism;
  Model<G> model;
  Tape<G> tape;

  Pendulum(int n, const Space<G>& in, Formalism formalism)
      : elements(n),
        space(in),
        mechanism(pendulum(n, formalism)),
        model(Model<G>::build(mechanism, space)) {
    simulate(model, options, {}, &tape);
  }
  void run_plain() const { simulate(model, options); }
  std::vector<int> group(int i, int groups) const {
    std::vector<int> out;
    for (int e = 0; e < elements; ++e)
      if (e * groups / elements == i) out.push_back(e);
    return out;
  }
  Parameters<G> parameters(int groups) const {
    Parameters<G> all;
    for (int i = 0; i < groups; ++i)
      all.emplace_back(mechanism, model,
                       Parameter{"", {by_dimension(mechanism, 0, group(i, groups), "height")}});
    return all;
  }
  Mechanism changed(int i, int groups, double by) const {
    Mechanism m = mechanism;
    for (const int e : group(i, groups))
      std::get<Rectangle>(std::get<BeamSpec>(m.bodies[0].kind).sections[std::size_t(e)].shape)
          .height += by;
    return m;
  }
};

struct Figure {
  std::string space, method;
  int variables = 0, functionals = 1;
  double seconds = 0, forward_runs = 0, clock_runs = 0, error = 0;  ///< of the processor; clock
  std::string note = {};
};

/// The position of the tip at the end, and at `functionals` - 1 times before.
template <FrameGroup G>
class Tip {
 public:
  Tip(const Pendulum<G>& of) : of_(of), values_(of.mechanism, of.model) {
    tip_.kind = ResponseKind::Position;
    tip_.at = *of.mechanism.port("beam.end");
    tip_.axis = Vec3::UnitY();
  }
  static bool counts(long step, int functional, int functionals) {
    return step == kSteps - kSteps * functional / functionals;
  }
  VectorXd direct(const Parameters<G>& parameters) const {
    return collect(parameters, [&](const SensitivityAt<G>& at) {
      direct_sensitivity<G>(of_.model, of_.tape, parameters, at);
    });
  }
  VectorXd collect(const Parameters<G>& parameters,
                   const std::function<void(const SensitivityAt<G>&)>& run) const {
    const ResponseSensitivity<G> response(of_.model, values_, tip_, parameters);
    VectorXd gradient;
    run([&](long step, const State<G>& s, const StateSensitivity& ds) {
      if (step == kSteps) gradient = response(s, ds).row(0);
    });
    return gradient;
  }
  MatrixXd adjoint(const Parameters<G>& parameters, int functionals) const {
    const ResponseSensitivity<G> response(of_.model, values_, tip_, parameters);
    MatrixXd gradient;
    adjoint_sensitivity<G>(
        of_.model, of_.tape, parameters, functionals,
        [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd& by_p) {
          for (int f = 0; f < functionals; ++f)
            if (counts(step, f, functionals))
              response.add_cotangents(s, MatrixXd::Ones(1, 1), f, bars, by_p);
        },
        gradient);
    return gradient;
  }
  double value(const Mechanism& m) const {
    const auto model = Model<G>::build(m, of_.space);
    const auto run = simulate(model, of_.options);
    State<G> s = model.initial_state();
    run.trajectory.read(run.trajectory.size() - 1, s);
    return ResponseValues<G>(m, model)(tip_, s)[0];
  }

 private:
  const Pendulum<G>& of_;
  const ResponseValues<G> values_;
  ResponseSpec tip_;
};

template <FrameGroup G>
class Bench {
 public:
  Bench(const char* name, int elements, const Space<G>& space, Formalism formalism,
        std::vector<Figure>& rows)
      : name_(name), pendulum_(elements, space, formalism), tip_(pendulum_), rows_(rows) {}

  void run(int groups) {
    const Parameters<G> parameters = pendulum_.parameters(groups);
    VectorXd exact;
    add(
        "direct", groups, 1, [&] { exact = tip_.direct(parameters); }, [] { return 0.; });
    for (const int functionals : {1, 10}) {
      MatrixXd gradient;
      add(
          "adjoint", groups, functionals, [&] { gradient = tip_.adjoint(parameters, functionals); },
          [&] { return error(gradient.col(0), exact); });
    }
    semi_analytic(parameters, groups, exact);
    differences(groups, exact);
  }

 private:
  static double error(const VectorXd& g, const VectorXd& exact) {
    return (g - exact).norm() / exact.norm();
  }
  /// Medians, by turns with plain runs. @param share of a form that is measured
  void add(const std::string& method, int groups, int functionals,
           const std::function<void()>& form, const std::function<double()>& error_of,
           double share = 1, const std::string& note = "") {
    TwoTimes plain, times;
    double all = 0;
    do {
      plain.take([&] { pendulum_.run_plain(); });
      times.take(form);
      all += times.processor.back();
    } while (times.processor.front() < kLong && (times.processor.size() < kTurns || all < kEnough));
    while (plain.processor.size() < kTurns) plain.take([&] { pendulum_.run_plain(); });
    const double time = median(times.processor) / share, clock = median(times.clock) / share;
    rows_.push_back({name_, method, groups, functionals, time, time / median(plain.processor),
                     clock / median(plain.clock), error_of(), note});
    const Figure& r = rows_.back();
    fmt::print(
        "{:<8} {:<34} {:>4} {:>3} {:>9.3f} s {:>8.1f} runs, {:>8.1f} by the clock  {:.1e}  "
        "{}\n",
        r.space, r.method, r.variables, r.functionals, r.seconds, r.forward_runs, r.clock_runs,
        r.error, r.note);
    std::fflush(stdout);
  }
  void semi_analytic(const Parameters<G>& parameters, int groups, const VectorXd& exact) {
    std::vector<Mechanism> mechanisms;
    std::vector<std::unique_ptr<Model<G>>> models;
    std::vector<PerturbedModel<G>> perturbed;
    const double step = kPerturbation * 0.01;
    for (int i = 0; i < groups; ++i) {
      models.push_back(std::make_unique<Model<G>>(
          Model<G>::build(pendulum_.changed(i, groups, step), pendulum_.space)));
      perturbed.push_back({models.back().get(), step});
    }
    for (const int corrections : {0, 1, 2, 4, 8}) {
      VectorXd gradient;
      const auto form = [&] {
        gradient = tip_.collect(parameters, [&](const SensitivityAt<G>& at) {
          semi_analytic_sensitivity<G>(pendulum_.model, pendulum_.tape, perturbed,
                                       {corrections > 0, corrections}, at);
        });
      };
      add(corrections == 0 ? "semi-analytic, exact factor"
                           : fmt::format("semi-analytic, frozen, {} solves", corrections),
          groups, 1, form, [&] { return error(gradient, exact); });
    }
  }
  /// Central differences with steps of 1e-4; of many variables a few, and their time for all.
  void differences(int groups, const VectorXd& exact) {
    const int measured = std::min(groups, 4);
    const double h = 1e-4 * 0.01;
    VectorXd some(measured), of(measured);
    const auto form = [&] {
      for (int k = 0; k < measured; ++k) {
        const int i = k * groups / measured;
        some[k] = (tip_.value(pendulum_.changed(i, groups, h)) -
                   tip_.value(pendulum_.changed(i, groups, -h))) /
                  (2 * h);
        of[k] = exact[i];
      }
    };
    add(
        "central differences", groups, 1, form, [&] { return error(some, of); },
        static_cast<double>(measured) / groups,
        measured < groups ? fmt::format("{} of them measured", measured) : "");
  }

  const char* name_;
  const Pendulum<G> pendulum_;
  const Tip<G> tip_;
  std::vector<Figure>& rows_;
};

template <FrameGroup G>
void run_all(const char* name, int elements, const Space<G>& space, std::vector<Figure>& rows,
             Formalism formalism = Formalism::SE3) {
  Bench<G> bench(name, elements, space, formalism, rows);
  for (const int groups : {4, 40, 400})
    if (groups <= elements) bench.run(groups);
}

}  // namespace
}  // namespace liesl

int main(int argc, char** argv) {
  std::vector<liesl::Figure> rows;
  const int elements = argc > 2 ? std::max(4, std::atoi(argv[2])) : liesl::kElements;
  const auto plane = *liesl::find_plane(liesl::pendulum(elements)).plane;
  liesl::run_all<liesl::SE2>("planar", elements, plane, rows);
  liesl::run_all<liesl::SE2>("segments", elements, plane, rows, liesl::Formalism::Segments);
  liesl::run_all<liesl::SE3>("spatial", elements, {}, rows);
  if (argc < 2) return 0;
  std::ofstream out(argv[1]);
  out << "space,method,variables,functionals,time "
         "[s],forward_runs,clock_runs,relative_error,note\n";
  for (const auto& r : rows)
    out << fmt::format("{},\"{}\",{},{},{},{},{},{},{}\n", r.space, r.method, r.variables,
                       r.functionals, r.seconds, r.forward_runs, r.clock_runs, r.error, r.note);
}
