/// @file
/// Limits on natural frequencies, and limits of one side: closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "optim/cycle/motion_cycle.hpp"
#include "optim/problems/frequency_problem.hpp"
#include "reference/studies.hpp"

namespace liesl::test::frequency_limit_test {
namespace {

StudySpec lightest(double least, int count) {
  StudySpec study;
  study.mass_of = {0};
  study.design = {{"height", {0}, {"height"}, 1, 0.004, 0.04, {}},
                  {"width", {0}, {"width"}, 1, 0.03, 0.08, {}}};
  study.frequencies = {{"first", least, count, 0}};
  return study;
}

/// f = 1.8751^2/(2 pi) sqrt(E/rho) h / sqrt(12) of a bar of height h and length 1 m.
double first_frequency(double h) {
  return std::pow(1.8751041, 2) / (2 * M_PI) * std::sqrt(210e9 / 7850 / 12) * h;
}

TEST(FrequencyLimit, FrequenciesAreThoseOfTheBeam) {
  const auto scene = flat_cantilever().scene;
  const LimitedModes f(scene.mechanism, scene.simulation, {{"first", 1, 2, 0}});
  ASSERT_EQ(f.reason, "");
  EXPECT_NEAR(f.frequency(0, 0) / first_frequency(0.02), 1, 0.01);
  EXPECT_NEAR(f.frequency(0, 1) / first_frequency(0.04), 1, 0.01);
}

/// dg/dx against central differences of order 2, of dimensions; of the slider-crank in a pose.
TEST(FrequencyLimit, GradientIsThatOfTheValue) {
  StudyCase study = slider_crank_rod({start(std::vector<double>())});
  study.spec.design.push_back({"crank_diameters", {0}, {"diameter"}, 2, 0.008, 0.030, {}});
  const Mechanism& m = study.scene.mechanism;
  const Design design(study.spec, m);
  const Eigen::VectorXd x = design.start();
  FrequencyProblem problem(m, design, study.scene.simulation, {{"f", 100, 3, 0.05}}, x);
  const auto rows = static_cast<Eigen::Index>(problem.constraints().size());
  ASSERT_EQ(rows, 3);
  double f = 0;
  Eigen::VectorXd df = x, a(rows), b(rows);
  RowMatrix dg(rows, x.size());
  problem.values(x, f, a);
  problem.gradients(x, df, dg);
  EXPECT_GT(dg.norm(), 1);
  std::vector<double> errors;
  for (const double h : {1e-2, 5e-3}) {
    double largest = 0;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      Eigen::VectorXd at = x;
      at[i] = x[i] * (1 + h);
      problem.values(at, f, a);
      at[i] = x[i] * (1 - h);
      problem.values(at, f, b);
      largest = std::max(largest, ((a - b) / (2 * h * x[i]) - dg.col(i)).norm());
    }
    errors.push_back(largest / dg.norm());
  }
  EXPECT_LT(errors[1], 1e-4);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.3) << errors[0] << " " << errors[1];
}

/// Two bars in a row on a slider: the first clamped to the ground and hinged to the second, which
/// is clamped to a heavy block that moves freely. Alone the first is clamped and hinged.
Mechanism row() {
  Section flat;
  flat.shape = Rectangle{0.04, 0.02};
  Mechanism m;
  BeamSpec upright = straight_beam({0, 0, 0}, {1, 0, 0}, 20, flat, steel());
  upright.nodes = straight({0, 0, 0}, {1, 0, 0}, 20, Orientation{Vec3::UnitY()});
  m.bodies = {{"b", upright},
              {"c", straight_beam({1, 0, 0}, {2, 0, 0}, 4, flat, steel())},
              {"block", block({2, 0, 0}, 10, 1)}};
  m.joints = {{"clamp", JointType::Fixed, {}, {0, 0}},
              {"pin", JointType::Revolute, {0, 20}, {1, 0}},
              {"held", JointType::Fixed, {1, 4}, {2, 0}}};
  m.drives = {{1, 0, TimeFunction::rate(1, 0.1)}};
  ForceSpec spring;
  spring.name = "k";
  spring.a = {1, 2};
  spring.b = {-1, 0, SE3(Mat3::Identity(), {1.5, 0, 1})};
  spring.stiffness = 1e3;
  m.forces = {spring};
  return m;
}

constexpr int kB = 0, kC = 1;

/// (beta l)^2/(2 pi) sqrt(E/rho/12) h: clamped at both ends out of the plane and, as the drive
/// holds the pin, in it; without the drive clamped and hinged in it.
TEST(FrequencyLimit, OfOneBeamAsItsPortsHoldIt) {
  Mechanism m = row();
  const auto bar = [](double root, double h) {
    return root * root / (2 * M_PI) * std::sqrt(210e9 / 7850 / 12) * h;
  };
  const auto lowest = [&] {
    FrequencyLimitSpec limit{"own", 1, 2, 0};
    limit.body = kB;
    const LimitedModes f(m, {}, {limit});
    EXPECT_EQ(f.reason, "");
    return std::pair(f.frequency(0, 0), f.frequency(0, 1));
  };
  const double clamped = 4.7300407, hinged = 3.9266023;
  EXPECT_NEAR(lowest().first / bar(clamped, 0.02), 1, 0.02);
  EXPECT_NEAR(lowest().second / bar(clamped, 0.04), 1, 0.02);
  m.drives.clear();
  EXPECT_NEAR(lowest().first / bar(clamped, 0.02), 1, 0.02);
  EXPECT_NEAR(lowest().second / bar(hinged, 0.04), 1, 0.02);
}

/// The gradient of the frequency of one beam, with a spring to another body, against differences.
TEST(FrequencyLimit, GradientOfOneBeamIsThatOfItsValue) {
  const Mechanism m = row();
  StudySpec study;
  study.mass_of = {0};
  study.design = {{"own", {kC}, {"height"}, 1, 0.004, 0.04, {}},
                  {"other", {kB}, {"height"}, 1, 0.004, 0.04, {}}};
  study.constants = {spring_stiffness("k", 1, 1e7)};
  study.cycle.method = CycleMethod::Esl1;
  const Design design(study, m);
  Eigen::VectorXd x = design.start();
  x[2] = 2e5;
  FrequencyLimitSpec limit{"own", 10, 2, 0};
  limit.body = kC;
  FrequencyProblem problem(m, design, {}, {limit}, x);
  double f = 0;
  Eigen::VectorXd df = x, above(2), below(2);
  RowMatrix dg(2, 3);
  problem.values(x, f, above);
  problem.gradients(x, df, dg);
  EXPECT_EQ(dg.col(1).norm(), 0);  // another beam
  EXPECT_GT(std::abs(dg(0, 2)), 0);
  for (const Eigen::Index j : {Eigen::Index{0}, Eigen::Index{2}}) {
    Eigen::VectorXd at = x;
    at[j] = x[j] * (1 + 1e-3);
    problem.values(at, f, above);
    at[j] = x[j] * (1 - 1e-3);
    problem.values(at, f, below);
    EXPECT_LT(((above - below) / (2e-3 * x[j]) - dg.col(j)).norm(), 1e-4 * dg.col(j).norm()) << j;
  }
}

/// The height is what the frequency out of the plane asks for, the width its least.
TEST(FrequencyLimit, LightestBarIsThatOfTheClosedForm) {
  const auto [scene, given] = flat_cantilever();
  const double least = 20;
  for (const CycleMethod method : {CycleMethod::Esl1, CycleMethod::Full}) {
    StudySpec study = lightest(least, 1);
    study.constraints = given.constraints;  // never reached
    study.cycle.method = method;
    const auto r =
        run_cycle<SE2>(scene.mechanism, space_of<SE2>(scene.mechanism), scene.simulation, study);
    EXPECT_TRUE(r.status == CycleStatus::Optimal || r.status == CycleStatus::Converged) << r.reason;
    const double thickness = least / first_frequency(1);
    ASSERT_EQ(r.x.size(), 2);
    EXPECT_NEAR(r.x[0] / thickness, 1, 0.01) << r.x.transpose() << " " << r.reason;
    EXPECT_NEAR(r.x[1], 0.03, 1e-4) << r.x.transpose();
    ASSERT_EQ(r.final[0].frequencies.size(), 1u);
    EXPECT_NEAR(r.final[0].frequencies[0].value / least, 1, 2e-3);
  }
}

/// A limit on more frequencies than there are ends the study with the reason, not with 0 Hz.
TEST(FrequencyLimit, ThatHasNoValueEndsTheStudyWithAReason) {
  auto [scene, given] = flat_cantilever();
  StudySpec study = lightest(20, 61);  // 10 nodes with 6 coordinates move
  study.constraints = given.constraints;
  study.cycle.method = CycleMethod::Esl1;
  const auto r =
      run_cycle<SE2>(scene.mechanism, space_of<SE2>(scene.mechanism), scene.simulation, study);
  EXPECT_EQ(r.status, CycleStatus::SimulationFailed) << r.reason;
  EXPECT_NE(r.reason.find("frequency 'first': the mechanism has only 60"), std::string::npos)
      << r.reason;
}

/// A load up, then a quarter of it down: each side has its limit.
TEST(SideLimit, HoldsItsSideAlone) {
  auto problem = flat_cantilever();
  auto& scene = problem.scene;
  scene.simulation.duration = 0.2;
  scene.simulation.step = 2e-3;
  scene.mechanism.loads[0].force = {0, 200, 0};
  scene.mechanism.loads[0].scale = TimeFunction::table(
      {0, 0.05, 0.1, 0.15, 0.2}, {0, 1, 0, -0.25, 0}, TimeFunction::Interpolation::Cubic);
  const auto height = [&](double up, double down) {
    StudySpec study;
    study.mass_of = {0};
    study.design = {{"height", {0}, {"width"}, 1, 0.004, 0.2, {}}};
    ResponseSpec r = problem.spec.constraints[0].response;
    r.side = Side::Up;
    r.name = "up";
    study.constraints.push_back({r, up, false});
    r.side = Side::Down;
    r.name = "down";
    study.constraints.push_back({r, down, false});
    study.cycle.method = CycleMethod::Esl1;
    const auto result =
        run_cycle<SE2>(scene.mechanism, space_of<SE2>(scene.mechanism), scene.simulation, study);
    EXPECT_TRUE(result.status == CycleStatus::Optimal || result.status == CycleStatus::Converged)
        << result.reason;
    const double largest_up = result.final[0].limits[0].largest,
                 largest_down = result.final[0].limits[1].largest;
    EXPECT_LE(largest_up, up * 1.002);
    EXPECT_LE(largest_down, down * 1.002);
    EXPECT_NEAR(std::max(largest_up / up, largest_down / down), 1, 2e-3);
    return std::pair(largest_up / up, largest_down / down);
  };
  const auto upper = height(2e-3, 2e-3);
  EXPECT_NEAR(upper.first, 1, 2e-3);
  EXPECT_LT(upper.second, 0.9);
  const auto lower = height(2e-2, 5e-4);
  EXPECT_NEAR(lower.second, 1, 2e-3);
  EXPECT_LT(lower.first, 0.9);
}

}  // namespace
}  // namespace liesl::test::frequency_limit_test
