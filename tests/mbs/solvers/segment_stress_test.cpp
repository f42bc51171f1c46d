/// @file
/// Stress of chains of segments from their N and M: against columns that are bent and pulled, and
/// against the beam on the group in motion.

#include "mbs/chains.hpp"
#include "mbs/run.hpp"
#include "mbs/sections/section_law.hpp"
#include "mbs/sections/stress.hpp"
#include "mbs/static_cases.hpp"
#include "mbs/system/response_value.hpp"

namespace liesl::test::segment_stress_test {
namespace {

ResponseSpec largest_stress(int body) {
  ResponseSpec r;
  r.kind = ResponseKind::Stress;
  r.body = body;
  return r;
}

constexpr double kLength = 1, kThick = 0.003;

/// A section, and its resistance to bending by a force in a direction: the largest stress is M/W.
struct Bent {
  Section section;
  double W;  ///< m^3
  Vec3 across;
};

/// A cantilever with a force at its end that pulls it and one that bends it: M = P tanh(k L)/k with
/// k^2 = N/EI (S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, 1961, art. 1.11),
/// sigma = N/A + M/W, tau = P/(k A); in the plane or in space.
template <class G>
void expect_stress_of_the_tie(const Bent& bent) {
  const Material soft{"soft", 1e9, 0.3, 1000};
  const SectionLaw law = section_law(bent.section, soft);
  const double EI = law.K(5, 5), EA = law.K(0, 0), GA = law.K(1, 1), k = 1 / kLength,
               N = k * k * EI, P = 3e-4 * N;
  const double sigma = N * soft.E / EA + P * std::tanh(k * kLength) / k / bent.W,
               tau = P * soft.G() / GA, exact = std::sqrt(sigma * sigma + 3 * tau * tau);
  const auto stress = [&](int n) {
    Mechanism m = cantilever(straight_beam({0, 0, 0}, {kLength, 0, 0}, n, bent.section, soft));
    m.loads = {tip_load(m, N * Vec3::UnitX() + P * bent.across)};
    m = segments(m);
    const Model<G> model = Model<G>::build(m, space_of<G>(m));
    const auto found = solve_static(model, tight());
    EXPECT_EQ(found.report.status, SolveStatus::Converged) << found.report.reason;
    State<G> s = model.initial_state();
    found.trajectory.read(found.trajectory.size() - 1, s);
    return ResponseValues<G>(m, model)(largest_stress(0), s)[0];
  };
  const double a = stress(8), b = stress(16), c = stress(32);
  EXPECT_NEAR(std::log2((a - exact) / (b - exact)), 2, 0.1);
  EXPECT_NEAR(std::log2((b - exact) / (c - exact)), 2, 0.1);
  EXPECT_NEAR(richardson(b, c) / exact, 1, 2e-6);
}

TEST(SegmentStress, IsThatOfATieThatIsBent) {
  Section flat, tall;
  flat.shape = Rectangle{0.5 * kThick, kThick};
  tall.shape = Rectangle{2 * kThick, kThick};
  const double W = M_PI * std::pow(kThick, 3) / 32;
  expect_stress_of_the_tie<SE2>({round_section(kThick, 0.9), W, Vec3::UnitY()});
  expect_stress_of_the_tie<SE2>({flat, std::pow(kThick, 3) / 24, Vec3::UnitY()});
  expect_stress_of_the_tie<SE2>({tall, std::pow(kThick, 3) / 1.5, Vec3::UnitY()});
}

/// Where both stiffnesses are one: a rod that is bent towards a point of its rim, a square one in
/// any direction, whose corner has the moments about both axes.
TEST(SegmentStress, IsThatOfATieThatIsBentInSpace) {
  Section square;
  square.shape = Rectangle{kThick, kThick};
  expect_stress_of_the_tie<SE3>({round_section(kThick, 0.9), M_PI * std::pow(kThick, 3) / 32,
                                 Vec3(0, std::sqrt(0.5), std::sqrt(0.5))});
  const double c = std::cos(0.3), s = std::sin(0.3);
  expect_stress_of_the_tie<SE3>({square, std::pow(kThick, 3) / 6 / (c + s), Vec3(0, c, s)});
}

/// Largest stress at the middle node of a body over a motion.
double in_motion(const Mechanism& m, int body, int n, const SimulationOptions& o) {
  const auto r = run_planar(m, o);
  EXPECT_EQ(r.report().status, SolveStatus::Converged) << r.report().reason;
  const ResponseValues<SE2> values(m, *r.model);
  ResponseSpec at = largest_stress(body);
  at.element = n / 2;
  const auto& beam = std::get<BeamSpec>(m.bodies[std::size_t(body)].kind);
  const int points = int(stress_points(beam.sections[0], beam.material.nu).size());
  State<SE2> s = r.model->initial_state();
  double largest = 0;
  for (int i = 0; i <= r.last(); ++i) {
    r.trajectory().read(i, s);
    for (at.point = 0; at.point < points; ++at.point) largest = std::max(largest, values(at, s)[0]);
  }
  return largest;
}

/// A pendulum: with order 2 both, to one value but for shear and rotary inertia, which a chain has
/// not, of the order of (1 + E/(k G)) I/(A L^2), 3e-5.
TEST(SegmentStress, OfAPendulumIsThatOfTheBeamOnTheGroup) {
  const auto limit = [](Formalism formalism) {
    const auto stress = [&](int n) {
      Mechanism m = pendulum(n);
      m.formalism = formalism;
      m.gravity_scale = TimeFunction::expression("t < 0.2 ? sin(2.5*pi*t)^2 : 1");
      return in_motion(m, 0, n, options(0.4, 5e-4, 0.8, 1e-9));
    };
    const double a = stress(16), b = stress(32), c = stress(64);
    EXPECT_NEAR(std::log2((a - b) / (b - c)), 2, 0.15) << to_string(formalism);
    return richardson(b, c);
  };
  const double chain = limit(Formalism::Segments);
  EXPECT_GT(chain, 1e6);
  EXPECT_NEAR(limit(Formalism::SE3) / chain, 1, 1e-4);
}

/// The rod of a slider-crank, whose crank is stout: I/(A L^2) = 1e-3.
TEST(SegmentStress, OfASliderCrankIsThatOfTheBeamOnTheGroup) {
  const auto limit = [](Formalism formalism) {
    const auto stress = [&](int n) {
      Mechanism m = slider_crank({.elements = n});
      m.formalism = formalism;
      return in_motion(m, 1, n, options(0.06, 5e-5, 0.8, 1e-7));
    };
    const double b = stress(16), c = stress(32);
    EXPECT_NEAR(b / c, 1, 2e-3) << to_string(formalism);
    return richardson(b, c);
  };
  EXPECT_NEAR(limit(Formalism::Segments) / limit(Formalism::SE3), 1, 2e-3);
}

}  // namespace
}  // namespace liesl::test::segment_stress_test
