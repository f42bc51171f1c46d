/// @file
/// build/bench/bin/bench_adjoint_memory [STEPS [NODES]]: memory and time of the adjoint form of a
/// long motion in space, its states kept at checkpoints only: the figures of docs/sensitivities.md.

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>

#include "mbs/model/curves.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "mbs/solvers/dynamics.hpp"

namespace liesl {
namespace {

constexpr double kStep = 1e-3;  // s
constexpr double kTolerance =
    1e-6;                   // of the states: round-off of 1000 short elements allows no more
constexpr int kGroups = 4;  // of elements whose heights are the variables

/// Largest resident set of this process so far, MB.
double peak_memory() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

void report(const char* what, const std::function<void()>& work) {
  const std::clock_t begin = std::clock();
  work();
  fmt::print("{:<22} {:>9.1f} s {:>9.1f} MB at most so far\n", what,
             static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, peak_memory());
  std::fflush(stdout);
}

/// A pendulum of soft square bar, 1 m long.
Mechanism pendulum(int nodes) {
  BeamSpec beam;
  beam.nodes = straight({0, 0, 0}, {1, 0, 0}, nodes - 1);
  beam.material = {"soft", 5e8, 0.3, 7800};
  beam.sections.assign(static_cast<std::size_t>(nodes - 1),
                       {"square", Rectangle{0.01, 0.01}, {5. / 6, 5. / 6}, 0.1406e-8});
  Mechanism m;
  m.gravity = {0, -9.81, 0};
  m.bodies = {{"beam", beam}};
  m.joints = {{"hinge", JointType::Revolute, {}, {0, 0}}};
  return m;
}

Parameters<SE3> heights(const Mechanism& mechanism, const Model<SE3>& model, int elements) {
  Parameters<SE3> all;
  for (int g = 0; g < kGroups; ++g) {
    std::vector<int> group;
    for (int e = 0; e < elements; ++e)
      if (e * kGroups / elements == g) group.push_back(e);
    all.emplace_back(mechanism, model,
                     Parameter{"", {by_dimension(mechanism, 0, group, "height")}});
  }
  return all;
}

void run(int steps, int nodes) {
  const Mechanism mechanism = pendulum(nodes);
  const auto model = Model<SE3>::build(mechanism, {});
  SimulationOptions options;
  options.step = kStep;
  options.duration = steps * kStep;
  options.tolerance = kTolerance;
  options.output_every = steps;
  Tape<SE3> tape;
  fmt::print("{} nodes, {} steps of {} s\n", nodes, steps, kStep);
  report("model", [] {});
  report("motion", [&] { simulate(model, options, {}, &tape); });
  fmt::print("  {} checkpoints, a state each\n", tape.checkpoints.size());
  const Parameters<SE3> parameters = heights(mechanism, model, nodes - 1);
  const ResponseValues<SE3> values(mechanism, model);
  ResponseSpec tip;
  tip.kind = ResponseKind::Position;
  tip.at = *mechanism.port("beam.end");
  tip.axis = Vec3::UnitY();
  const ResponseSensitivity<SE3> response(model, values, tip, parameters);
  Eigen::MatrixXd gradient;
  report("adjoint, 1 functional", [&] {
    adjoint_sensitivity<SE3>(
        model, tape, parameters, 1,
        [&](long step, const State<SE3>& s, StateSensitivity& bars, Eigen::MatrixXd& by_p) {
          if (step == steps) response.add_cotangents(s, Eigen::MatrixXd::Ones(1, 1), 0, bars, by_p);
        },
        gradient);
  });
  for (int g = 0; g < kGroups; ++g)
    fmt::print("  d(tip)/d(height {}) = {:.9g}\n", g, gradient(g, 0));
}

}  // namespace
}  // namespace liesl

int main(int argc, char** argv) {
  liesl::run(argc > 1 ? std::atoi(argv[1]) : 100000, argc > 2 ? std::atoi(argv[2]) : 1000);
}
