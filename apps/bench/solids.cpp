/// @file
/// The figures of docs/performance.md about meshed parts: one evaluation of a design, from the
/// parameters to the gradients of all responses in all load cases.

#include <benchmark/benchmark.h>

#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/features.hpp"
#include "mbs/solids/reduction.hpp"
#include "mbs/solids/stress_norm.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;

/// A rod of 200 mm x 40 mm x 20 mm with five super-ellipse holes along it, with two interfaces.
struct Rod {
  levelset::LevelSetPtr shape;
  SolidModel model;

  Rod(int dim, int nx, int ny, int nz)
      : shape(make_shape(dim)), model(make_model(dim, nx, ny, nz)) {}

  static levelset::LevelSetPtr make_shape(int dim) {
    using namespace levelset;
    std::vector<Operand> operands;
    operands.push_back({"rod", dim == 2 ? rectangle(0.3, 0.05) : box(0.3, 0.05, 0.03)});
    for (int i = 0; i < 5; ++i)
      operands.push_back(
          {"hole" + std::to_string(i),
           placed_in_plane(-0.07 + 0.035 * i, 0.001, 0.1, super_ellipse(0.013, 0.009, 3, 3))});
    return subtract(std::move(operands));
  }
  static SolidModel make_model(int dim, int nx, int ny, int nz) {
    const SolidMesh mesh = dim == 2 ? quad_grid({-0.1, -0.02}, {0.1, 0.02}, nx, ny)
                                    : hex_grid({-0.1, -0.02, -0.01}, {0.1, 0.02, 0.01}, nx, ny, nz);
    SolidModel::Options options;
    options.thickness = 0.02;
    return SolidModel(mesh, {"steel", 210e9, 0.3, 7850},
                      {{"big end", mesh.sets.at("x_min"), {-0.1, 0, 0}, Tie::Rigid},
                       {"small end", mesh.sets.at("x_max"), {0.1, 0, 0}, Tie::Rigid}},
                      options);
  }
};

/// Loads that differ in every coordinate, as the equivalent static loads of a motion do.
MatrixXd many_loads(const SolidModel& model, int cases) {
  MatrixXd f(model.size(), cases);
  for (int n = 0; n < cases; ++n)
    for (int i = 0; i < model.size(); ++i) f(i, n) = std::sin(1 + 0.37 * i + 1.1 * n);
  return f;
}

void evaluate(benchmark::State& state, int dim, int nx, int ny, int nz, int cases, bool stress) {
  Rod rod(dim, nx, ny, nz);
  MatrixXd outputs(rod.model.size(), 2);
  outputs << elongation_output(rod.model, 0, 1), relative_output(rod.model, 0, 1, 1);
  SolidStatics statics(rod.model, SolidSupport::relief(), outputs);
  statics.set_loads(many_loads(rod.model, cases));
  Eigen::VectorXd p = rod.shape->start();
  for (auto _ : state) {
    rod.shape->set(p);
    const Fractions f = volume_fractions(rod.model.mesh(), *rod.shape);
    if (statics.solve(f.value) != SolidStatus::Solved) state.SkipWithError("not solved");
    benchmark::DoNotOptimize(statics.output_gradient(0, f.derivative));
    benchmark::DoNotOptimize(statics.output_gradient(1, f.derivative));
    benchmark::DoNotOptimize(statics.compliance_gradient(f.derivative));
    const Eigen::VectorXd mass = f.derivative.transpose() * rod.model.cell_masses();
    benchmark::DoNotOptimize(mass.data());
    if (stress) benchmark::DoNotOptimize(stress_norm(statics, f.derivative));
  }
  state.counters["coordinates"] = rod.model.size();
  state.counters["parameters"] = rod.shape->size();
}

void reduce_rod(benchmark::State& state, int dim, int nx, int ny, int nz) {
  Rod rod(dim, nx, ny, nz);
  const Fractions f = volume_fractions(rod.model.mesh(), *rod.shape);
  for (auto _ : state)
    if (!reduce(rod.model, f.value, ReductionKind::CraigBampton, 10).converged)
      state.SkipWithError("not converged");
}

BENCHMARK_CAPTURE(evaluate, quads_150x30_400_cases, 2, 150, 30, 0, 400, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, quads_150x30_400_cases_with_stress, 2, 150, 30, 0, 400, true)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(evaluate, hexes_60x16x8_200_cases, 3, 60, 16, 8, 200, false)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reduce_rod, quads_150x30, 2, 150, 30, 0)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(reduce_rod, hexes_60x16x8, 3, 60, 16, 8)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace liesl
