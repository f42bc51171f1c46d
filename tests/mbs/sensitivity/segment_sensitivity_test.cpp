/// @file
/// Sensitivities of motions of chains of segments: direct against adjoint, against differences, and
/// against those of the beam on the group.

#include "mbs/sensitivity/forms.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl::test::segment_sensitivity_test {
namespace {

constexpr double kSoft = 7e8, kSlow = 50;  // E, and rad/s of the crank
const SegmentSpec kSpecs[] = {
    {}, {AxialPotential::Linear, true}, {AxialPotential::NeoHookean, false}};

/// Without the disc, which is bolted to an inner node.
Mechanism segmented(Mechanism m, SegmentSpec spec = {}) {
  m.formalism = Formalism::Segments;
  m.bodies.pop_back();
  m.joints.pop_back();
  for (auto& body : m.bodies)
    if (auto* beam = std::get_if<BeamSpec>(&body.kind)) beam->segment = spec;
  return m;
}

ResponseSpec response(ResponseKind kind) {
  ResponseSpec r;
  r.kind = kind;
  r.name = name_of(kind);
  r.body = 1;
  r.at = {1, 2};
  r.component = 5;
  r.place = ElementPlace::Last;
  return r;
}

std::vector<ResponseSpec> responses() {
  std::vector<ResponseSpec> all;
  for (const auto kind : {ResponseKind::Position, ResponseKind::Rotation, ResponseKind::Deflection,
                          ResponseKind::SectionForce, ResponseKind::Energy})
    all.push_back(response(kind));
  all[0].axis = Vec3(0.6, 0.8, 0);
  all[1].axis = Vec3::UnitZ();
  return all;
}

/// y and dy/dp at the end of a motion, all responses below each other.
struct Gradients {
  VectorXd y;
  MatrixXd direct, adjoint;

  Gradients(const Mechanism& m, const SimulationOptions& o, const std::vector<Quantity>& all) {
    const Taped<SE2> run(m, o);
    const auto parameters = run.parameters(all);
    const ResponseValues<SE2> values(run.mechanism, run.model);
    std::vector<ResponseSensitivity<SE2>> of;
    std::vector<int> first{0};
    for (const auto& r : responses()) {
      of.emplace_back(run.model, values, r, parameters);
      first.push_back(first.back() + components(r, true));
    }
    y = value(run);
    direct.setZero(first.back(), Eigen::Index(all.size()));
    auto end = direct_sensitivity<SE2>(
        run.model, run.tape, parameters, [&](long step, const State<SE2>& s, const auto& ds) {
          if (step != run.tape.steps()) return;
          for (std::size_t i = 0; i < of.size(); ++i)
            direct.middleRows(first[i], first[i + 1] - first[i]) = of[i](s, ds);
        });
    EXPECT_TRUE(end.complete()) << end.reason;
    end = adjoint_sensitivity<SE2>(
        run.model, run.tape, parameters, first.back(),
        [&](long step, const State<SE2>& s, StateSensitivity& bars, MatrixXd& gradient) {
          if (step != run.tape.steps()) return;
          for (std::size_t i = 0; i < of.size(); ++i) {
            const int n = first[i + 1] - first[i];
            of[i].add_cotangents(s, MatrixXd::Identity(n, n), first[i], bars, gradient);
          }
        },
        adjoint);
    EXPECT_TRUE(end.complete()) << end.reason;
    adjoint.transposeInPlace();
  }
  static VectorXd value(const Taped<SE2>& run) {
    const ResponseValues<SE2> values(run.mechanism, run.model);
    State<SE2> s = run.model.initial_state();
    run.run.trajectory.read(run.run.trajectory.size() - 1, s);
    std::vector<double> y;
    for (const auto& r : responses()) {
      const VectorXd v = values(r, s);
      y.insert(y.end(), v.begin(), v.end());
    }
    return Eigen::Map<const VectorXd>(y.data(), Eigen::Index(y.size()));
  }
};

void expect_differences_of(SegmentSpec spec) {
  const Mechanism m = segmented(sensitive_machine(), spec);
  const auto o = tight(0.02, 4e-4);
  const auto every = quantities(sensitive_machine());
  const std::vector<Quantity> all{every[0], every[1], every[2], every[3], every[10], every[13]};
  const Gradients exact(m, o, all);
  for (Eigen::Index p = 0; p < exact.direct.cols(); ++p)
    for (Eigen::Index i = 0; i < exact.direct.rows(); ++i)
      EXPECT_NEAR(exact.direct(i, p), exact.adjoint(i, p), 1e-10 * std::abs(exact.direct(i, p)))
          << i << ", " << all[std::size_t(p)].parameter.name;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const Differences found(
        [&](double change) -> MatrixXd {
          Mechanism changed = m;
          all[p].set(changed, all[p].nominal * (1 + change));
          return Gradients::value(Taped<SE2>(changed, o));
        },
        0.04, 4);
    const VectorXd at = all[p].nominal * exact.direct.col(Eigen::Index(p));
    const bool linear = all[p].parameter.name == "component of the load";
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      const double size = std::max(std::abs(at[i]), 1e-3 * std::abs(exact.y[i]));
      double best = 1;
      for (const auto& y : found.extrapolated)
        best = std::min(best, std::abs(y(i, 0) - at[i]) / size);
      EXPECT_LT(best, 1e-7) << i << ", " << all[p].parameter.name;
      const double coarse = std::abs(found.central[0](i, 0) - at[i]) / size,
                   fine = std::abs(found.central[1](i, 0) - at[i]) / size;
      EXPECT_EQ(coarse < 1e-6, linear) << i << ", " << all[p].parameter.name;
      if (!linear) {
        EXPECT_NEAR(std::log2(coarse / fine), 2, 0.25) << i << ", " << all[p].parameter.name;
      }
    }
  }
}

/// Of a slower and softer one, whose motion of 1000 steps needs no shorter ones.
Mechanism slow_and_soft(SegmentSpec spec) {
  Mechanism m = segmented(sensitive_machine(kSoft), spec);
  m.drives = {{0, 0, TimeFunction::rate(kSlow, 0.02)}};
  return m;
}

/// All but those of the disc.
std::vector<Quantity> quantities_of_segments() {
  auto all = quantities(sensitive_machine(kSoft));
  std::erase_if(all, [](const Quantity& q) { return q.parameter.name.ends_with("of the disc"); });
  all.back().parameter = {"drive", {DriveDerivative{0, 1 / kSlow}}};
  return all;
}

Quantity length_of_the_rod(const Mechanism& m) {
  return by_nearby("length of the rod", m, 0.3, [](Mechanism& c, double p) {
    std::get<BeamSpec>(c.bodies[1].kind).nodes = straight({0.15, 0, 0}, {0.15 + p, 0, 0}, 3);
    std::get<RigidSpec>(c.bodies[2].kind).frame.x = {0.15 + p, 0, 0};
  });
}

/// By a length not after 10 steps, see `GeometrySensitivity`.
template <FrameGroup G>
void expect_both_forms(const Mechanism& m, const std::vector<int>& of_steps) {
  constexpr int kEnd = 3;  // of the rod: inner nodes of a chain have no frame
  for (const int steps : of_steps) {
    auto all = quantities_of_segments();
    if (steps > 10) all.push_back(length_of_the_rod(m));
    expect_direct_equals_adjoint<G>(steps, m, all, 2e-4, kEnd);
  }
}

TEST(SegmentSensitivity, DirectEqualsAdjoint) {
  for (const SegmentSpec& spec : kSpecs)
    expect_both_forms<SE2>(slow_and_soft(spec), {10, 100, 1000});
}

/// Out of the plane, and without the damping of the rod, which a chain has not in space.
TEST(SegmentSensitivity, DirectEqualsAdjointInSpace) {
  for (const SegmentSpec& spec : kSpecs) {
    Mechanism m = slow_and_soft(spec);
    std::get<BeamSpec>(m.bodies[1].kind).damping = 0;
    m.gravity.z() = 2;
    m.loads[0].force.z() = 2;
    expect_both_forms<SE3>(m, {10, 100});
    if (&spec == kSpecs) expect_both_forms<SE3>(m, {1000});
  }
}

TEST(SegmentSensitivity, EqualsDifferencesOfSimulations) { expect_differences_of({}); }
TEST(SegmentSensitivity, OfLumpedMassesEqualsDifferences) {
  expect_differences_of({AxialPotential::Linear, true});
}
TEST(SegmentSensitivity, OfTheHyperelasticPotentialEqualsDifferences) {
  expect_differences_of({AxialPotential::NeoHookean, false});
}

/// dy/dp of the tip of a pendulum by E, rho, the sides of its section and its length: those of
/// segments and of the beam on the group come to one value with the square of the length of
/// elements.
TEST(SegmentSensitivity, ComesToThatOfTheBeamOnTheGroup) {
  const auto gradients = [](Formalism formalism, int n) {
    Mechanism m = pendulum(n);
    m.formalism = formalism;
    m.gravity_scale = TimeFunction::expression("t < 0.2 ? sin(2.5*pi*t)^2 : 1");
    const Taped<SE2> run(m, tight(0.3, 1e-3));
    std::vector<int> every;
    for (int e = 0; e < n; ++e) every.push_back(e);
    const Parameter by[] = {{"E", {by_youngs_modulus(run.mechanism, 0)}},
                            {"rho", {by_density(run.mechanism, 0)}},
                            {"height", {by_dimension(run.mechanism, 0, every, "height")}},
                            {"width", {by_dimension(run.mechanism, 0, every, "width")}}};
    const double nominal[] = {5e8, 7800, 0.01, 0.01, 1};
    Parameters<SE2> parameters;
    for (const auto& p : by) parameters.emplace_back(run.mechanism, run.model, p);
    const Quantity length = by_nearby("length", run.mechanism, 1, [n](Mechanism& c, double p) {
      std::get<BeamSpec>(c.bodies[0].kind).nodes = straight({0, 0, 0}, {p, 0, 0}, n);
    });
    parameters.emplace_back(run.mechanism, run.model, length.parameter);
    MatrixXd out;
    const auto end = direct_sensitivity<SE2>(
        run.model, run.tape, parameters, [&](long, const State<SE2>& s, const auto& ds) {
          out = s.H[std::size_t(n)].R * ds.eta.middleRows(3 * n, 2);
        });
    EXPECT_TRUE(end.complete()) << end.reason;
    for (int p = 0; p < 5; ++p) out.col(p) *= nominal[p];
    return out;
  };
  const MatrixXd limit = (4 * gradients(Formalism::SE3, 32) - gradients(Formalism::SE3, 16)) / 3;
  const auto record = [](const std::string& name, const MatrixXd& by) {
    for (int p = 0; p < 5; ++p)
      RecordProperty(name + "_" + std::to_string(p),
                     std::to_string(by(0, p)) + " " + std::to_string(by(1, p)));
  };
  record("limit", limit);
  double before = 0, before_by_length = 0;
  for (const int n : {4, 8, 16}) {
    const MatrixXd found = gradients(Formalism::Segments, n);
    const double off = (found - limit).leftCols(4).norm() / limit.leftCols(4).norm(),
                 by_length = (found - limit).col(4).norm() / limit.col(4).norm();
    record("segments_" + std::to_string(n), found);
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / off), 2, 0.4) << n;
      EXPECT_NEAR(std::log2(before_by_length / by_length), 2, 0.4) << n;
    }
    before_by_length = by_length;
    before = off;
    RecordProperty("off_" + std::to_string(n), std::to_string(off));
  }
  EXPECT_LT(before, 1e-3);
}

}  // namespace
}  // namespace liesl::test::segment_sensitivity_test
