#pragma once
/// @file
/// Derivatives of responses over a motion, as tests compare them: direct form, adjoint form and
/// differences of simulations.

#include "mbs/sensitivity/forms.hpp"
#include "mbs/sensitivity/response_sensitivity.hpp"

namespace liesl::test {

/// Responses of `sensitive_machine`, of each way to depend on the motion: frames, velocities,
/// multipliers, the law itself.
inline std::vector<ResponseSpec> responses_of_the_machine() {
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

/// Further ones, of which no place or sign is looked for.
inline std::vector<ResponseSpec> further_responses_of_the_machine() {
  const auto of_port = [](ResponseKind kind, Axes in) {
    ResponseSpec r;
    r.kind = kind;
    r.name = name_of(kind);
    r.at = {1, 2, SE3(Mat3::Identity(), {0.01, 0.02, 0})};
    r.to = {0, 0};
    r.joint = 0;
    r.in = in;
    return r;
  };
  std::vector<ResponseSpec> all = {of_port(ResponseKind::Translation, Axes::Inertial),
                                   of_port(ResponseKind::Elongation, Axes::Inertial),
                                   of_port(ResponseKind::DriveForce, Axes::Inertial)};
  for (const auto in : {Axes::Inertial, Axes::Body})
    for (const auto kind : {ResponseKind::Displacement, ResponseKind::Rotation,
                            ResponseKind::AngularVelocity, ResponseKind::Velocity})
      all.push_back(of_port(kind, in));
  return all;
}

/// y at all records, components x records.
template <FrameGroup G>
MatrixXd response_history(const Taped<G>& of, const ResponseSpec& r) {
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
std::vector<MatrixXd> direct_responses(const Taped<G>& run, const Parameters<G>& parameters,
                                       const std::vector<ResponseSensitivity<G>>& responses,
                                       int rows) {
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
MatrixXd adjoint_responses(const Taped<G>& run, const Parameters<G>& parameters,
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

/// Histories of all responses, one below the other.
template <FrameGroup G>
MatrixXd response_histories(const Taped<G>& of, const std::vector<ResponseSpec>& responses,
                            int rows) {
  MatrixXd y(rows, of.run.trajectory.size());
  int first = 0;
  for (const auto& r : responses) {
    const MatrixXd one = response_history(of, r);
    y.middleRows(first, one.rows()) = one;
    first += int(one.rows());
  }
  return y;
}

/// Of the sum of all responses over the steps of the second half: direct form and adjoint form.
/// @return dy/dp at all steps, by parameter
template <FrameGroup G>
std::vector<MatrixXd> expect_response_forms(const Taped<G>& run, const std::vector<Quantity>& all,
                                            const std::vector<ResponseSpec>& responses) {
  const auto parameters = run.parameters(all);
  const ResponseValues<G> values(run.mechanism, run.model);
  std::vector<ResponseSensitivity<G>> sensitivities;
  std::vector<int> groups;
  int rows = 0;
  for (const auto& r : responses) {
    sensitivities.emplace_back(run.model, values, r, parameters);
    rows += groups.emplace_back(components(r, G::space_dim == 2));
  }
  auto exact = direct_responses(run, parameters, sensitivities, rows);
  const MatrixXd gradient = adjoint_responses(run, parameters, sensitivities, groups, rows);
  const long steps = run.tape.steps();
  double worst = 0;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const MatrixXd second = exact[p].rightCols(steps + 1 - steps / 2);
    const VectorXd sum_size = sizes(second.cwiseAbs().rowwise().sum(), groups);
    const VectorXd gap = second.rowwise().sum() - gradient.row(long(p)).transpose();
    const double error = gap.cwiseAbs().cwiseQuotient(sum_size).maxCoeff();
    EXPECT_LT(error, 1e-10) << steps << " steps, " << all[p].parameter.name;
    worst = std::max(worst, error);
  }
  ::testing::Test::RecordProperty("worst_" + std::to_string(steps), std::to_string(1e12 * worst));
  return exact;
}

/// Of all responses over a motion: direct, adjoint and differences.
template <FrameGroup G>
void expect_response_gradients(const Mechanism& machine, const SimulationOptions& o,
                               const std::vector<Quantity>& all,
                               const std::vector<ResponseSpec>& responses,
                               const DifferenceOptions& options = {}) {
  const auto exact = expect_response_forms(Taped<G>(machine, o), all, responses);
  std::vector<int> groups;
  for (const auto& r : responses) groups.push_back(components(r, G::space_dim == 2));
  const int rows = int(exact.front().rows());
  for (std::size_t p = 0; p < all.size(); ++p) {
    const auto motion = [&](double change) {
      Mechanism changed = machine;
      all[p].set(changed, all[p].nominal * (1 + change));
      return response_histories(Taped<G>(changed, o), responses, rows);
    };
    const MatrixXd scaled = all[p].nominal * exact[p];
    expect_limit(motion, scaled, sizes(scaled.cwiseAbs().rowwise().maxCoeff(), groups), options,
                 all[p].parameter.name, p);
  }
}

}  // namespace liesl::test
