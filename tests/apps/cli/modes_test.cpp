/// @file
/// `liesl run` of modes: frequencies on the terminal, shapes in the files.

#include <cmath>

#include "apps/program.hpp"

namespace liesl::test::modes_test {
namespace {

class Modes : public Program {};

/// A cantilever's first two bending frequencies are printed; shapes are records over frequency.
TEST_F(Modes, PrintsFrequenciesAndWritesShapes) {
  const fs::path file = write("beam.toml", R"toml(
[materials]
steel = { E = 210e9, nu = 0.3, rho = 7850 }
[sections]
flat = { type = "rectangle", width = 0.02, height = 0.01 }
[bodies]
b = { beam = { from = [0, 0, 0], to = [1, 0, 0], section = "flat", material = "steel", elements = 24 } }
[joints]
clamp = { fixed = ["ground", "b.start"] }
[simulation]
type = "modes"
modes = 4
)toml");
  const Outcome o = run({"run", file, "-o", results()});
  ASSERT_EQ(o.code, 0) << o.err;
  const double soft = std::pow(1.8751041, 2) / (2 * M_PI) * std::sqrt(210e9 / 7850 / 12) * 0.01;
  const Json f = summary()["frequencies_hz"];
  ASSERT_EQ(f.size(), 4u);
  EXPECT_NEAR(f[0].get<double>() / soft, 1, 3e-3);
  EXPECT_NEAR(f[1].get<double>() / (2 * soft), 1, 3e-3);
  for (int i = 1; i <= 4; ++i)
    EXPECT_NE(o.out.find("mode " + std::to_string(i)), std::string::npos) << o.out;
  EXPECT_NE(o.out.find(" Hz"), std::string::npos);
  for (const char* name : {"results.h5", "results.xdmf"})
    EXPECT_TRUE(fs::exists(results() / name)) << name;
}

/// An inverted pendulum on a weak spring: omega^2 < 0 is said where the frequency stands.
TEST_F(Modes, SaysWhatIsUnstable) {
  const fs::path file = write("inverted.toml", R"toml(
gravity = [0, -9.81, 0]
[bodies]
top = { rigid = { at = [0, 1, 0], mass = 2, inertia = [1e-3, 1e-3, 1e-3], points = { foot = [0, 0, 0] } } }
[joints]
hinge = { revolute = ["ground", "top.foot"] }
[forces]
spring = { on = "hinge", stiffness = 5 }
[simulation]
type = "modes"
)toml");
  const Outcome o = run({"run", file, "-o", results()});
  EXPECT_EQ(o.code, 0) << o.err;
  EXPECT_NE(o.out.find("unstable: grows by e in"), std::string::npos) << o.out;
  const double omega2 = (5 - 2 * 9.81) / (2 + 1e-3);
  EXPECT_NEAR(summary()["eigenvalues"][0].get<double>() / omega2, 1, 1e-9);
}

}  // namespace
}  // namespace liesl::test::modes_test
