/// @file
/// Derivatives of motions with gears, cylinders and springs with tables: closed forms and
/// differences, direct and adjoint.

#include "mbs/run.hpp"
#include "mbs/sensitivity/motion_sensitivity.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl::test::coupling_sensitivity_test {
namespace {

/// Value at the end and its derivative, by the direct and the adjoint form.
struct AtEnd {
  double value = 0, direct = 0, adjoint = 0;
};

AtEnd at_end(const Mechanism& m, const ResponseSpec& response, const Parameter& parameter,
             double duration, double step) {
  const auto model = Model<SE2>::build(m, space_of<SE2>(m));
  Tape<SE2> tape;
  const auto result = simulate<SE2>(model, options(duration, step, 0.8, 1e-11), {}, &tape);
  EXPECT_EQ(result.report.status, SolveStatus::Converged) << result.report.reason;
  const ResponseValues<SE2> values(m, model);
  Parameters<SE2> parameters;
  parameters.emplace_back(m, model, parameter);
  const ResponseSensitivity<SE2> sensitivity(model, values, response, parameters);
  const long last = std::lround(duration / step);
  AtEnd out;
  auto end = direct_sensitivity<SE2>(model, tape, parameters,
                                     [&](long n, const State<SE2>& s, const StateSensitivity& ds) {
                                       if (n != last) return;
                                       out.value = values(response, s)[0];
                                       out.direct = sensitivity(s, ds)(0, 0);
                                     });
  EXPECT_TRUE(end.complete()) << end.reason;
  Eigen::MatrixXd gradient;
  end = adjoint_sensitivity<SE2>(
      model, tape, parameters, 1,
      [&](long n, const State<SE2>& s, StateSensitivity& bars, Eigen::MatrixXd& g) {
        if (n == last) sensitivity.add_cotangents(s, Eigen::MatrixXd::Ones(1, 1), 0, bars, g);
      },
      gradient);
  EXPECT_TRUE(end.complete()) << end.reason;
  out.adjoint = gradient(0, 0);
  return out;
}

ResponseSpec coordinate(int joint) {
  ResponseSpec r;
  r.kind = ResponseKind::Coordinate;
  r.joint = joint;
  return r;
}

/// q = T t^2 / 2 (J1 + r^2 J2): by J2, -r^2 q / (J1 + r^2 J2).
TEST(CouplingSensitivity, OfAGearIsThatOfTheClosedForm) {
  const double ratio = -0.4, torque = 1.5, J1 = 0.03, J2 = 0.2;
  Mechanism m;
  m.bodies = {{"small", block({0, 0, 0}, 1, J1)}, {"large", block({0.3, 0, 0}, 4, J2)}};
  m.joints = {{"in", JointType::Revolute, {}, {0, 0}}, {"out", JointType::Revolute, {}, {1, 0}}};
  m.gears = {{"mesh", {0, 0}, {1, 0}, ratio}};
  ForceSpec f;
  f.joint = 0;
  f.force = TimeFunction::constant(torque);
  m.forces = {f};
  RigidDerivative inertia;
  inertia.body = 1;
  inertia.inertia = Mat3::Identity();
  const double sum = J1 + ratio * ratio * J2, angle = 0.5 * torque * 0.25 / sum;
  for (const int joint : {0, 1}) {
    const AtEnd e = at_end(m, coordinate(joint), {"J2", {inertia}}, 0.5, 5e-3);
    const double q = joint == 0 ? angle : ratio * angle, by = -ratio * ratio * q / sum;
    EXPECT_NEAR(e.value / q, 1, 1e-7);
    EXPECT_NEAR(e.direct / by, 1, 1e-6);
    EXPECT_NEAR(e.adjoint / e.direct, 1, 1e-9);
  }
}

/// A mass on a hardening spring, and its force in a cylinder, by the rest of the spring.
TEST(CouplingSensitivity, OfASpringTableIsThatOfDifferences) {
  const auto machine = [](double rest) {
    Mechanism m;
    m.bodies = {{"mass", block({1, 0, 0}, 2, 0.1)}, {"other", block({0.3, 0.4, 0}, 1, 0.1)}};
    m.bodies[0].velocity = {2, 0, 0};
    m.joints = {{"guide", JointType::Prismatic, {}, {0, 0}, Vec3::UnitX()},
                {"axle", JointType::Revolute, {}, {1, 0}},
                {"strut", JointType::Cylinder, {1, 0, SE3(Mat3::Identity(), {0.1, 0, 0})}, {0, 0}}};
    ForceSpec f;
    f.joint = 2;
    f.rest = rest;
    f.damping = 4;
    f.curve.emplace(std::vector<double>{-0.4, -0.1, 0.1, 0.4},
                    std::vector<double>{-300, -20, 20, 300}, TimeFunction::Interpolation::Cubic);
    m.forces = {f};
    return m;
  };
  ResponseSpec force;
  force.kind = ResponseKind::JointForce;
  force.joint = 2;
  ForceDerivative by;
  by.force = 0;
  by.rest = 1;
  for (const ResponseSpec& r : {coordinate(0), coordinate(1), force}) {
    const AtEnd e = at_end(machine(0.02), r, {"rest", {by}}, 0.2, 1e-3);
    const auto value = [&](double rest) {
      return at_end(machine(rest), r, {"rest", {by}}, 0.2, 1e-3).value;
    };
    const auto difference = [&](double h) { return (value(0.02 + h) - value(0.02 - h)) / (2 * h); };
    const double fourth_order = (4 * difference(5e-5) - difference(1e-4)) / 3;
    EXPECT_NEAR(e.direct / fourth_order, 1, 1e-5) << name_of(r.kind);
    EXPECT_NEAR(e.adjoint / e.direct, 1, 1e-8) << name_of(r.kind);
  }
}

}  // namespace
}  // namespace liesl::test::coupling_sensitivity_test
