/// @file
/// `liesl run` of modes: frequencies on the terminal, shapes in the files.

#include <cmath>

#include "apps/hdf5_set.hpp"
#include "apps/program.hpp"

namespace liesl::test::modes_test {
namespace {

class Modes : public Program {};

constexpr double kRoots[] = {1.8751041, 1.8751041, 4.6940911, 4.6940911};  // 1 + cos k cosh k = 0

/// Bending of a cantilever of length 1 m, k of its frequency (Euler and Bernoulli).
double bending(double k, double x) {
  const double s = (std::sinh(k) - std::sin(k)) / (std::cosh(k) + std::cos(k));
  return std::cosh(k * x) - std::cos(k * x) - s * (std::sinh(k * x) - std::sin(k * x));
}

/// Its derivative.
double slope(double k, double x) {
  const double s = (std::sinh(k) - std::sin(k)) / (std::cosh(k) + std::cos(k));
  return k * (std::sinh(k * x) + std::sin(k * x) - s * (std::cosh(k * x) - std::cos(k * x)));
}

/// Shapes of a cantilever along x that bends in z and in y by turns, as records over frequency.
/// They are drawn large, and along the rotations of the nodes: within 5 % of the linear ones.
void expect_shapes(const fs::path& folder, const Json& frequencies) {
  const DataSet rest = read_set(folder / "results.h5", "/bodies/b/reference_position");
  const DataSet at = read_set(folder / "results.h5", "/bodies/b/position");
  const DataSet over = read_set(folder / "results.h5", "/time");
  constexpr std::size_t kNodes = 25;
  ASSERT_EQ(rest.shape, (std::vector<hsize_t>{kNodes, 3}));
  ASSERT_EQ(at.shape, (std::vector<hsize_t>{frequencies.size(), kNodes, 3}));
  EXPECT_EQ(over.values, frequencies.get<std::vector<double>>());
  for (std::size_t m = 0; m < frequencies.size(); ++m) {
    const std::size_t along = m % 2 == 0 ? 2 : 1, across = 3 - along;
    const auto moved = [&](std::size_t node, std::size_t axis) {
      return at.values[3 * (m * kNodes + node) + axis] - rest.values[3 * node + axis];
    };
    const double tip = moved(kNodes - 1, along);
    const double turn = std::abs(slope(kRoots[m], 1) / bending(kRoots[m], 1));
    EXPECT_GT(turn, 1);
    EXPECT_NEAR(std::abs(tip), std::min(0.1, 0.25 / turn), 0.005)
        << "mode " << m << ": a tenth of the length, or a largest turn of 0.25 rad";
    for (std::size_t n = 0; n < kNodes; ++n) {
      const double x = static_cast<double>(n) / (kNodes - 1);
      EXPECT_NEAR(moved(n, along) / tip, bending(kRoots[m], x) / bending(kRoots[m], 1), 0.05)
          << "mode " << m << " at " << x;
      EXPECT_NEAR(moved(n, across) / tip, 0, 1e-6) << "mode " << m << " at " << x;
    }
  }
}

const std::string kCantilever = R"toml(
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
)toml";

/// A cantilever's first two bending frequencies are printed; shapes are records over frequency.
TEST_F(Modes, PrintsFrequenciesAndWritesShapes) {
  const fs::path file = write("beam.toml", kCantilever);
  const Outcome o = run({"run", file, "-o", results()});
  ASSERT_EQ(o.code, 0) << o.err;
  const double soft = std::pow(1.8751041, 2) / (2 * M_PI) * std::sqrt(210e9 / 7850 / 12) * 0.01;
  const Json f = summary()["frequencies_hz"];
  ASSERT_EQ(f.size(), 4u);
  EXPECT_NEAR(f[0].get<double>() / soft, 1, 3e-3);
  EXPECT_NEAR(f[1].get<double>() / (2 * soft), 1, 3e-3);
  const double second = std::pow(kRoots[2] / kRoots[0], 2);
  EXPECT_NEAR(f[2].get<double>() / (second * soft), 1, 1e-2);
  EXPECT_NEAR(f[3].get<double>() / (2 * second * soft), 1, 1e-2);
  for (int i = 1; i <= 4; ++i)
    EXPECT_NE(o.out.find("mode " + std::to_string(i)), std::string::npos) << o.out;
  EXPECT_NE(o.out.find(" Hz"), std::string::npos);
  expect_shapes(results(), f);
}

/// A cantilever's modes in z, y and z: the forces of a small vibration, not those of the finite
/// shape that is drawn, which stretches the beam.
TEST_F(Modes, ResponsesAreLinearInTheShape) {
  const fs::path file = write("beam.toml", kCantilever + R"toml(
[responses]
tip = { response = "displacement", at = "b.end" }
N = { response = "section_force", of = "b", component = "N", element = 20 }
M = { response = "section_force", of = "b", component = "My", element = 0 }
stress = { response = "stress", of = "b" }
twice_the_energy = { response = "compliance", of = "b" }
)toml");
  const Outcome o = run({"run", file, "-o", results(), "--set", "bodies.b.beam.elements=48",
                         "--set", "simulation.modes=3"});
  ASSERT_EQ(o.code, 0) << o.err;
  const auto of = [&](const std::string& name) {
    return read_set(results() / "results.h5", "/responses/" + name).values;
  };
  const auto tip = of("tip"), N = of("N"), M = of("M"), stress = of("stress"),
             energy = of("twice_the_energy");
  ASSERT_EQ(tip.size(), 9u);
  const double EA = 210e9 * 2e-4, EI = EA * 1e-4 / 12;
  for (const std::size_t m : {0, 2}) {
    SCOPED_TRACE(m);
    const double k = kRoots[m], z = tip[3 * m + 2];
    const double moment = EI * 2 * k * k * std::abs(z / bending(k, 1));  // at the clamp
    EXPECT_GT(std::abs(z), 0.01);
    EXPECT_NEAR(tip[3 * m] / z, 0, 1e-8);
    EXPECT_NEAR(N[m], 0, 1e-9 * EA);
    EXPECT_NEAR(std::abs(M[m]) / moment, 1, 0.03);
    EXPECT_NEAR(stress[m] / (moment * 0.005 / (EI / 210e9)), 1, 0.03);
    // int w''^2 = k^4 int w^2 = k^4 w(1)^2 / 4
    EXPECT_NEAR(energy[m] / (EI * std::pow(k, 4) * z * z / 4), 1, 0.02);
  }
  EXPECT_NEAR(M[1], 0, 1e-6 * std::abs(M[0])) << "it bends in y";
  EXPECT_GT(stress[1], 0);
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
