/// @file
/// Sensitivities of motions that others have published.

#include "mbs/sensitivity/functional.hpp"
#include "mbs/sensitivity/machine.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"
#include "reference/published_sensitivities.hpp"

namespace liesl::test::published_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::LinearAbsorber;
using test::SundialsSliderCrank;
using test::Taped;

/// G = sum_i T m_i rms(y_i)^2/2 over the angular velocities of both bodies and the velocity of the
/// slider: the integral of the kinetic energy by the trapezoidal rule.
struct KineticEnergy {
  std::vector<ResponseSpec> velocities;
  std::vector<double> inertia;

  KineticEnergy() {
    add(ResponseKind::AngularVelocity, 0, 1);
    add(ResponseKind::AngularVelocity, 1, 2);
    add(ResponseKind::Velocity, 2, 1);
  }
  void add(ResponseKind kind, int body, double mass) {
    ResponseSpec r;
    r.kind = kind;
    r.at = {body, 0};
    r.in = Axes::Inertial;
    velocities.push_back(r);
    inertia.push_back(mass);
  }
};

/// [G, dG/dk, dG/dc] with a step, by either form.
template <FrameGroup G>
Vector3d figures(double step, bool adjoint) {
  const Mechanism m = SundialsSliderCrank::make();
  const Taped<G> run(m, test::options(SundialsSliderCrank::kDuration, step, 1, 1e-11));
  Parameters<G> parameters;
  parameters.emplace_back(m, run.model, Parameter{"k", {ForceDerivative{0, 1}}});
  parameters.emplace_back(m, run.model, Parameter{"c", {ForceDerivative{0, 0, 1}}});
  const ResponseValues<G> values(run.mechanism, run.model);
  const KineticEnergy energy;
  const long steps = run.tape.steps();
  std::vector<ResponseSensitivity<G>> responses;
  std::vector<FunctionalValue> rms;
  VectorXd t(steps + 1);
  for (const auto& spec : energy.velocities) {
    responses.emplace_back(run.model, values, spec, parameters);
    MatrixXd y(3, steps + 1);
    State<G> s = run.model.initial_state();
    for (int n = 0; n <= steps; ++n) {
      run.run.trajectory.read(n, s);
      t[n] = s.t;
      y.col(n) = values(spec, s);
    }
    rms.push_back(evaluate({FunctionalKind::Rms, 0}, t, y));
  }
  const double T = SundialsSliderCrank::kDuration;
  Vector3d out = Vector3d::Zero();
  for (std::size_t i = 0; i < rms.size(); ++i)
    out[0] += 0.5 * T * energy.inertia[i] * rms[i].value * rms[i].value;
  const auto weight = [&](std::size_t i, long n) -> MatrixXd {
    return T * energy.inertia[i] * rms[i].value * rms[i].by_y.col(n);
  };
  MatrixXd gradient = MatrixXd::Zero(2, 1);
  SensitivityEnd end;
  if (adjoint)
    end = adjoint_sensitivity<G>(
        run.model, run.tape, parameters, 1,
        [&](long n, const State<G>& s, StateSensitivity& bars, MatrixXd& by_p) {
          for (std::size_t i = 0; i < rms.size(); ++i)
            responses[i].add_cotangents(s, weight(i, n), 0, bars, by_p);
        },
        gradient);
  else
    end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                [&](long n, const State<G>& s, const StateSensitivity& ds) {
                                  for (std::size_t i = 0; i < rms.size(); ++i)
                                    gradient += responses[i](s, ds).transpose() * weight(i, n);
                                });
  EXPECT_TRUE(end.complete()) << end.reason;
  out.tail<2>() = gradient;
  return out;
}

/// Second order in the step, and extrapolated the published digits.
template <FrameGroup G>
void expect_published(double step) {
  const Vector3d published{SundialsSliderCrank::kG, SundialsSliderCrank::kByStiffness,
                           SundialsSliderCrank::kByDamping};
  const Vector3d coarse = figures<G>(4 * step, false), middle = figures<G>(2 * step, false),
                 fine = figures<G>(step, false), adjoint = figures<G>(step, true);
  const Vector3d first = (4 * middle - coarse) / 3, second = (4 * fine - middle) / 3;
  const Vector3d extrapolated = (16 * second - first) / 15;
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(adjoint[i], fine[i], 1e-10 * std::abs(fine[i]));
    EXPECT_NEAR(std::log2((coarse[i] - middle[i]) / (middle[i] - fine[i])), 2, 0.05) << i;
    EXPECT_NEAR(extrapolated[i], published[i], 1e-9 * std::abs(published[i])) << i;
    ::testing::Test::RecordProperty("error_1e9_" + std::to_string(i),
                                    std::to_string(1e9 * (extrapolated[i] - published[i])));
  }
}

TEST(PublishedSensitivities, SliderCrankOfSundialsInThePlane) { expect_published<SE2>(2.5e-3); }
TEST(PublishedSensitivities, SliderCrankOfSundialsInSpace) { expect_published<SE3>(5e-3); }

/// [|x''|, |x|] at their peaks, and their gradients by k and c: of the motion as it is computed.
struct AbsorberPeaks {
  Eigen::Vector2d value;
  Eigen::Matrix2d gradient;  ///< row: quantity
};

AbsorberPeaks absorber(double k, double c) {
  const Mechanism m = LinearAbsorber::make(k, c);
  const Taped<SE3> run(m, test::options(10, 2e-3, 1, 1e-10));
  Parameters<SE3> parameters;
  parameters.emplace_back(m, run.model, Parameter{"k", {ForceDerivative{0, 1}}});
  parameters.emplace_back(m, run.model, Parameter{"c", {ForceDerivative{0, 0, 1}}});
  AbsorberPeaks peaks{Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
  const auto end = direct_sensitivity<SE3>(
      run.model, run.tape, parameters, [&](long, const State<SE3>& s, const StateSensitivity& ds) {
        const double y[] = {s.vdot[0], s.H[0].x[0]};
        const Eigen::RowVectorXd dy[] = {ds.w.row(0), ds.eta.row(0)};
        for (int i : {0, 1})
          if (std::abs(y[i]) > peaks.value[i]) {
            peaks.value[i] = std::abs(y[i]);
            peaks.gradient.row(i) = (y[i] > 0 ? 1 : -1) * dy[i];
          }
      });
  EXPECT_TRUE(end.complete()) << end.reason;
  return peaks;
}

/// At the published point: the published value, the limit active, KKT. (The optimiser finds it in
/// tests/optim/nlp/linear_absorber_test.cpp.)
TEST(PublishedSensitivities, LinearAbsorber) {
  const AbsorberPeaks at = absorber(LinearAbsorber::kStiffness, LinearAbsorber::kDamping);
  EXPECT_NEAR(at.value[0], LinearAbsorber::kAcceleration, 1e-4);
  EXPECT_NEAR(at.value[1], 1, 2e-4);
  const Eigen::Vector2d f = at.gradient.row(0).normalized(), g = at.gradient.row(1).normalized();
  EXPECT_LT((f + g).norm(), 1e-2) << "gradients of the objective and the limit are opposite";
}

}  // namespace
}  // namespace liesl::test::published_test
