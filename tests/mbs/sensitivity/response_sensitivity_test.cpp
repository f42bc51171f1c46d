/// @file
/// Derivatives of responses by parameters over a motion: direct, adjoint and differences.

#include "mbs/sensitivity/response_sensitivity.hpp"

#include "mbs/sensitivity/machine.hpp"

namespace liesl::test::response_sensitivity_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Taped;

/// Responses of each way to depend on the motion: frames, velocities, multipliers, the law itself.
std::vector<ResponseSpec> responses() {
  const auto of = [](ResponseKind kind, auto set) {
    ResponseSpec r;
    r.kind = kind;
    r.name = name_of(kind);
    r.body = 1;
    r.at = {1, 2, SE3(Mat3::Identity(), {0.01, 0.02, 0})};
    set(r);
    return r;
  };
  const auto plain = [](ResponseSpec&) {};
  return {of(ResponseKind::Position, plain),
          of(ResponseKind::Velocity, plain),
          of(ResponseKind::Acceleration, plain),
          of(ResponseKind::AngularAcceleration, plain),
          of(ResponseKind::Deflection, plain),
          of(ResponseKind::Coordinate, [](ResponseSpec& r) { r.joint = 1; }),
          of(ResponseKind::JointForce, [](ResponseSpec& r) { r.joint = 1; }),
          of(ResponseKind::SectionForce, [](ResponseSpec& r) { r.component = 5; }),
          of(ResponseKind::Energy, plain),
          of(ResponseKind::Compliance, plain)};
}

template <class G>
class ResponsesOfAMotion : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(ResponsesOfAMotion, Groups);

/// y at all records, components x records.
template <FrameGroup G>
MatrixXd history(const Taped<G>& of, const ResponseSpec& r) {
  const ResponseValues<G> values(of.mechanism, of.model);
  const auto& trajectory = of.run.trajectory;
  State<G> s = of.model.initial_state();
  MatrixXd y(components(r, G::space_dim == 2), trajectory.size());
  for (int n = 0; n < trajectory.size(); ++n) {
    trajectory.read(n, s);
    y.col(n) = values(r, s);
  }
  return y;
}

/// dy/dp of all responses, one below the other, at all steps: by parameter.
template <FrameGroup G>
std::vector<MatrixXd> direct(const Taped<G>& run, const Parameters<G>& parameters,
                             const std::vector<ResponseSensitivity<G>>& responses, int rows) {
  std::vector<MatrixXd> dy(parameters.size(), MatrixXd(rows, run.tape.steps() + 1));
  const auto end = direct_sensitivity<G>(
      run.model, run.tape, parameters, [&](long step, const State<G>& s, const auto& ds) {
        int at = 0;
        for (const auto& response : responses) {
          const MatrixXd d = response(s, ds);
          for (std::size_t p = 0; p < dy.size(); ++p)
            dy[p].col(step).segment(at, d.rows()) = d.col(long(p));
          at += int(d.rows());
        }
      });
  EXPECT_TRUE(end.complete()) << end.reason;
  return dy;
}

/// Of the sum of y over the steps of the second half, by parameter x row.
template <FrameGroup G>
MatrixXd adjoint(const Taped<G>& run, const Parameters<G>& parameters,
                 const std::vector<ResponseSensitivity<G>>& responses,
                 const std::vector<int>& groups, int rows) {
  MatrixXd gradient;
  const auto end = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, rows,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd& by_p) {
        if (2 * step < run.tape.steps()) return;
        int column = 0;
        for (std::size_t r = 0; r < responses.size(); ++r)
          for (int c = 0; c < groups[r]; ++c)
            responses[r].add_cotangents(s, VectorXd::Unit(groups[r], c), column++, bars, by_p);
      },
      gradient);
  EXPECT_TRUE(end.complete()) << end.reason;
  return gradient;
}

TYPED_TEST(ResponsesOfAMotion, HaveTheDerivativesOfDifferencesAndOfTheAdjoint) {
  using G = TypeParam;
  const Mechanism machine = test::sensitive_machine();
  const auto o = test::tight(0.02, 4e-4);
  const Taped<G> run(machine, o);
  const auto all = test::quantities(machine);
  const auto parameters = run.parameters(all);
  const ResponseValues<G> values(run.mechanism, run.model);
  std::vector<ResponseSensitivity<G>> sensitivities;
  std::vector<int> groups;
  int rows = 0;
  for (const auto& r : responses()) {
    sensitivities.emplace_back(run.model, values, r, parameters);
    rows += groups.emplace_back(components(r, G::space_dim == 2));
  }
  const auto exact = direct(run, parameters, sensitivities, rows);
  const MatrixXd gradient = adjoint(run, parameters, sensitivities, groups, rows);
  const long half = run.tape.steps() / 2;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const MatrixXd second = exact[p].rightCols(exact[p].cols() - half);
    const VectorXd sum_size = test::sizes(second.cwiseAbs().rowwise().sum(), groups),
                   size = test::sizes(exact[p].cwiseAbs().rowwise().maxCoeff(), groups);
    const VectorXd gap = second.rowwise().sum() - gradient.row(long(p)).transpose();
    EXPECT_LT(gap.cwiseAbs().cwiseQuotient(sum_size).maxCoeff(), 1e-10) << all[p].parameter.name;
    const auto motion = [&](double change) {
      Mechanism changed = machine;
      all[p].set(changed, all[p].nominal * (1 + change));
      const Taped<G> at(changed, o);
      MatrixXd y(rows, run.tape.steps() + 1);
      int first = 0;
      for (const auto& r : responses()) {
        const MatrixXd one = history(at, r);
        y.middleRows(first, one.rows()) = one;
        first += int(one.rows());
      }
      return y;
    };
    const test::Differences differences(motion, 0.16, 6);
    const double best = differences.least([&](const MatrixXd& y) {
      const MatrixXd error = (y / all[p].nominal - exact[p]).cwiseAbs();
      return error.rowwise().maxCoeff().cwiseQuotient(size).maxCoeff();
    });
    EXPECT_LT(best, 1e-7) << all[p].parameter.name;
    ::testing::Test::RecordProperty("best_" + std::to_string(p), std::to_string(1e9 * best));
  }
}

}  // namespace
}  // namespace liesl::test::response_sensitivity_test
