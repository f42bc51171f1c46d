#pragma once
/// @file
/// Direct form, adjoint form and differences of simulations against each other, as tests compare
/// them.

#include <algorithm>

#include "mbs/sensitivity/machine.hpp"

namespace liesl::test {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What is asked of a state: position, velocity and acceleration of a node, and all
/// multipliers; and the derivatives by the state.
template <FrameGroup G>
struct Outputs {
  static constexpr int sd = G::space_dim, dim = G::dim;
  std::size_t node;
  int at;
  std::vector<int> groups;

  explicit Outputs(const Model<G>& model, int body = 1, int node_of_body = 1)
      : node(std::size_t(model.first_node(body) + node_of_body)),
        at(dim * int(node)),
        groups({sd, dim, dim, model.constraints()}) {}
  int size() const { return sd + 2 * dim + groups[3]; }
  VectorXd values(const State<G>& s) const {
    VectorXd y(size());
    y << s.H[node].x, s.v.segment(at, dim), s.vdot.segment(at, dim), s.lambda;
    return y;
  }
  MatrixXd derivatives(const State<G>& s, const StateSensitivity& ds) const {
    MatrixXd dy(size(), ds.v.cols());
    dy << s.H[node].R * ds.eta.middleRows(at, sd), ds.v.middleRows(at, dim),
        ds.w.middleRows(at, dim), ds.lambda;
    return dy;
  }
  /// Column `column` of the cotangents: that of output i with a weight.
  void add_cotangents(const State<G>& s, int i, double weight, int column,
                      StateSensitivity& bars) const {
    if (i < sd)
      bars.eta.col(column).segment(at, sd) += weight * s.H[node].R.row(i).transpose();
    else if (i < sd + dim)
      bars.v(at + i - sd, column) += weight;
    else if (i < sd + 2 * dim)
      bars.w(at + i - sd - dim, column) += weight;
    else
      bars.lambda(i - sd - 2 * dim, column) += weight;
  }
};

/// J_i = sum over all steps of (weight of the step) y_i, and y_i at the last step alone. An error
/// counts against the sum of |weight dy_i/dp|, and against the largest |dy_i/dp|; of an output that
/// is smaller than `least` of the largest of its kind against that.
template <class G>
void expect_direct_equals_adjoint(const Taped<G>& run, const std::vector<Quantity>& quantities,
                                  int node = 1, double least = 1e-6, double tolerance = 1e-10) {
  const long steps = run.tape.steps();
  const auto parameters = run.parameters(quantities);
  const Outputs<G> outputs(run.model, 1, node);
  const int n = outputs.size(), n_p = int(parameters.size());
  const auto weight = [](long step) { return std::sin(0.3 + 0.1 * double(step)); };
  MatrixXd sum = MatrixXd::Zero(n, n_p), sum_size = sum, last, last_size = sum;
  auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                   [&](long step, const State<G>& s, const auto& ds) {
                                     last = outputs.derivatives(s, ds);
                                     sum += weight(step) * last;
                                     sum_size += std::abs(weight(step)) * last.cwiseAbs();
                                     last_size = last_size.cwiseMax(last.cwiseAbs());
                                   });
  ASSERT_TRUE(end.complete()) << end.reason;
  MatrixXd gradient;
  end = adjoint_sensitivity<G>(
      run.model, run.tape, parameters, 2 * n,
      [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
        for (int i = 0; i < n; ++i) {
          outputs.add_cotangents(s, i, weight(step), i, bars);
          if (step == steps) outputs.add_cotangents(s, i, 1, n + i, bars);
        }
      },
      gradient);
  ASSERT_TRUE(end.complete()) << end.reason;
  double worst = 0;
  for (int p = 0; p < n_p; ++p) {
    const VectorXd size = sizes(sum_size.col(p), outputs.groups, least),
                   size_at_end = sizes(last_size.col(p), outputs.groups, least);
    for (int i = 0; i < n; ++i) {
      const double error = std::abs(sum(i, p) - gradient(p, i)) / size[i],
                   error_at_end = std::abs(last(i, p) - gradient(p, n + i)) / size_at_end[i];
      EXPECT_LT(error, tolerance) << steps << " steps, sum of output " << i << ", parameter " << p;
      EXPECT_LT(error_at_end, tolerance) << steps << " steps, output " << i << ", parameter " << p;
      worst = std::max({worst, error, error_at_end});
    }
  }
  ::testing::Test::RecordProperty("worst_" + std::to_string(steps), std::to_string(1e12 * worst));
}

/// The same of a machine that takes as many steps of the size h.
template <class G>
void expect_direct_equals_adjoint(int steps, const Mechanism& machine,
                                  const std::vector<Quantity>& quantities, double h = 2e-4,
                                  int node = 1, double least = 1e-6, double tolerance = 1e-10) {
  expect_direct_equals_adjoint<G>(Taped<G>(machine, tight(steps * h, h)), quantities, node, least,
                                  tolerance);
}

/// How differences are taken.
struct DifferenceOptions {
  SimulationOptions simulation = tight(0.02, 4e-4);
  int node = 1;                          ///< of the second body, whose motion is compared
  double largest = 0.16;                 ///< relative change of a quantity
  double error = 1e-7;                   ///< allowed
  bool of_kind = false;                  ///< errors relative to the largest output of their kind
  int samples = 0;                       ///< of a fit beside the extrapolations; 0: none
  std::vector<std::string> linear = {};  ///< quantities in which all that is compared is linear
};

/// What `sensitive_machine` moves by linearly.
inline const std::vector<std::string> kLoadsOfTheMachine = {"component of the load",
                                                            "value of the table", "load"};

/// Outputs [size x steps + 1] at all records of a motion, none of whose steps was halved.
template <FrameGroup G>
MatrixXd recorded(const Taped<G>& at, const Outputs<G>& outputs) {
  EXPECT_EQ(at.run.report.rejected_steps, 0);
  State<G> s = at.model.initial_state();
  MatrixXd y(outputs.size(), at.run.trajectory.size());
  for (int n = 0; n < at.run.trajectory.size(); ++n) {
    at.run.trajectory.read(n, s);
    y.col(n) = outputs.values(s);
  }
  return y;
}

/// The same with a quantity changed by a share of its nominal value.
template <class G>
MatrixXd changed_motion(const Mechanism& machine, const Quantity& quantity, double change,
                        const SimulationOptions& o, const Outputs<G>& outputs) {
  Mechanism changed = machine;
  quantity.set(changed, quantity.nominal * (1 + change));
  return recorded(Taped<G>(changed, o), outputs);
}

/// Differences of a motion come to p dy/dp [outputs x steps], relative to the size of each output,
/// at first with the square of their step: the smallest step at which they err by more than 1e-5.
/// Of what is linear they err by less. @param number of the quantity, by which errors are recorded
inline void expect_limit(const std::function<MatrixXd(double change)>& motion,
                         const MatrixXd& exact, const VectorXd& size,
                         const DifferenceOptions& options, const std::string& name,
                         std::size_t number) {
  constexpr double kSeen = 1e-5;
  const auto error = [&](const MatrixXd& y) {
    return (y - exact).cwiseAbs().rowwise().maxCoeff().cwiseQuotient(size).maxCoeff();
  };
  Differences differences(motion, options.largest, 6);
  if (options.samples > 0) differences.fit(motion, 0.7 * options.largest, options.samples);
  const double best = differences.least(error);
  EXPECT_LT(best, options.error) << name;
  ::testing::Test::RecordProperty("best_" + std::to_string(number), std::to_string(1e9 * best));
  std::size_t step = 3;
  const auto& linear = options.linear;
  if (std::find(linear.begin(), linear.end(), name) != linear.end()) {
    EXPECT_LT(error(differences.central[step]), kSeen) << name << " is not linear";
    return;
  }
  while (step > 0 && error(differences.central[step]) <= kSeen) --step;
  const double coarse = error(differences.central[step]),
               slope = std::log2(coarse / error(differences.central[step + 1]));
  EXPECT_GT(coarse, kSeen) << name << ": too small for a slope";
  EXPECT_NEAR(slope, 2, 0.1) << name;
  ::testing::Test::RecordProperty("slope_" + std::to_string(number), std::to_string(slope));
}

/// Outputs [size x steps + 1] with quantity p changed by a share of its nominal value.
using ChangedMotion = std::function<MatrixXd(std::size_t p, double change)>;

/// At every step of the motion, relative to the largest value over it.
template <class G>
void expect_differences(const Taped<G>& run, const std::vector<Quantity>& all,
                        const DifferenceOptions& options, const ChangedMotion& changed) {
  const auto parameters = run.parameters(all);
  const Outputs<G> outputs(run.model, 1, options.node);
  const long records = run.tape.steps() + 1;
  std::vector<MatrixXd> exact(all.size(), MatrixXd(outputs.size(), records));
  const auto end = direct_sensitivity<G>(run.model, run.tape, parameters,
                                         [&](long step, const State<G>& s, const auto& ds) {
                                           const MatrixXd dy = outputs.derivatives(s, ds);
                                           for (std::size_t p = 0; p < all.size(); ++p)
                                             exact[p].col(step) = all[p].nominal * dy.col(long(p));
                                         });
  ASSERT_TRUE(end.complete()) << end.reason;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const VectorXd size =
        sizes(exact[p].cwiseAbs().rowwise().maxCoeff(), outputs.groups, options.of_kind ? 1 : 1e-6);
    expect_limit([&](double change) { return changed(p, change); }, exact[p], size, options,
                 all[p].parameter.name, p);
  }
}

/// Of simulations with each quantity changed in the machine.
template <class G>
void expect_differences(const Mechanism& machine, const std::vector<Quantity>& all,
                        const DifferenceOptions& options = {}) {
  const Taped<G> run(machine, options.simulation);
  const Outputs<G> outputs(run.model, 1, options.node);
  expect_differences<G>(run, all, options, [&](std::size_t p, double change) {
    return changed_motion<G>(machine, all[p], change, options.simulation, outputs);
  });
}

}  // namespace liesl::test
