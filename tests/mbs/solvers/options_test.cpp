/// @file
/// Options of a simulation out of their range are refused by the library itself, all at once.

#include "mbs/solvers/options.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "mbs/run.hpp"
#include "mbs/solvers/modes.hpp"
#include "mbs/solvers/statics.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test::options_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Options, DefaultsAreValid) { EXPECT_TRUE(SimulationOptions{}.errors().empty()); }

/// One value wrong at a time: one error, which names the key and the value.
template <class T>
void expect_refused(T SimulationOptions::*member, const std::string& key, std::vector<T> values) {
  for (const T value : values) {
    SimulationOptions o;
    o.*member = value;
    const auto errors = o.errors();
    ASSERT_EQ(errors.size(), 1u) << key << " = " << value;
    EXPECT_EQ(errors[0].rfind("simulation." + key + ":", 0), 0u) << errors[0];
    EXPECT_NE(errors[0].find("expected"), std::string::npos) << errors[0];
  }
}

TEST(Options, EveryValueHasItsRange) {
  using O = SimulationOptions;
  expect_refused<double>(&O::duration, "duration", {0, -1, kNaN, kInfinity});
  expect_refused<double>(&O::step, "step", {0, -1e-3, kNaN, kInfinity, 2});
  expect_refused<double>(&O::rho_inf, "rho_inf", {-0.1, 1.1, kNaN});
  expect_refused<double>(&O::tolerance, "tolerance", {0, -1e-6, 0.02, kNaN});
  expect_refused<int>(&O::max_iterations, "max_iterations", {2, 101, -5});
  expect_refused<double>(&O::error_tolerance, "error_tolerance", {0, -1, 1.5, kNaN});
  expect_refused<double>(&O::step_min, "step_min", {-1e-9, 1, kNaN});
  expect_refused<int>(&O::output_every, "output_every", {0, -1});
  expect_refused<int>(&O::load_steps, "load_steps", {0, -1});
  expect_refused<double>(&O::max_load, "max_load", {0, -1, kNaN, kInfinity});
  expect_refused<int>(&O::modes, "modes", {0, -1});
}

TEST(Options, EndsOfRangesAreValid) {
  SimulationOptions o;
  for (const double rho : {0., 1.}) {
    o.rho_inf = rho;
    o.step = o.step_min = o.duration;
    o.tolerance = 1e-2;
    o.max_iterations = rho == 0 ? 3 : 100;
    o.error_tolerance = 1;
    o.output_every = o.load_steps = o.modes = 1;
    EXPECT_TRUE(o.errors().empty());
  }
}

/// Two wrong values are both in what is thrown.
TEST(Options, SolversRefuseThem) {
  const auto model = Model<SE2>::build(test::pendulum(2), {});
  SimulationOptions o;
  o.step = 0;
  o.max_iterations = 0;
  const auto expect_both = [](const auto& run) {
    try {
      run();
      FAIL() << "nothing was thrown";
    } catch (const std::invalid_argument& e) {
      const std::string what = e.what();
      EXPECT_NE(what.find("simulation.step:"), std::string::npos) << what;
      EXPECT_NE(what.find("simulation.max_iterations:"), std::string::npos) << what;
    }
  };
  expect_both([&] { simulate(model, o); });
  expect_both([&] { solve_static(model, o); });
  expect_both([&] { solve_modes(model, o); });
}

}  // namespace
}  // namespace liesl::test::options_test
