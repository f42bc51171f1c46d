/// @file
/// Derivatives of a motion by parameters: direct form, adjoint form and differences of simulations.

#include "mbs/sensitivity/motion_sensitivity.hpp"

#include <gtest/gtest.h>

#include "mbs/run.hpp"
#include "reference/mechanisms.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A mechanism by parameters, on which masses, stiffnesses, forces and dampers depend linearly.
using Family = std::function<Mechanism(const VectorXd& p)>;

template <FrameGroup G>
Space<G> space_of(const Mechanism& m) {
  if constexpr (G::space_dim == 2)
    return find_plane(m).plane.value();
  else
    return {};
}

/// dr/dp by differences of the residual in p, exact as r is linear in p.
template <FrameGroup G>
class LinearIn final : public ParameterDerivative<G> {
 public:
  LinearIn(const Family& family, const VectorXd& p) {
    for (int i = 0; i < p.size(); ++i) {
      VectorXd up = p, down = p;
      up[i] *= 1.5;
      down[i] *= 0.5;
      ends_.push_back({build(family(up)), build(family(down)), p[i]});
    }
  }
  int parameters() const override { return static_cast<int>(ends_.size()); }
  void add(const State<G>& s, MatrixXd& r_p) const override {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      Equations<G> up(*ends_[i].up), down(*ends_[i].down);
      up.evaluate(s, s.q, {s.t, 1});
      down.evaluate(s, s.q, {s.t, 1});
      r_p.col(static_cast<int>(i)) += (up.r - down.r) / ends_[i].size;
    }
  }

 private:
  struct Ends {
    std::unique_ptr<Model<G>> up, down;
    double size;
  };
  static std::unique_ptr<Model<G>> build(const Mechanism& m) {
    return std::make_unique<Model<G>>(Model<G>::build(m, space_of<G>(m)));
  }
  std::vector<Ends> ends_;
};

/// Young's modulus and density of a rod, the weight, a spring with a damper at the crank's hinge.
Mechanism crank_by(const VectorXd& p) {
  Mechanism m = reference::slider_crank({.elements = 3, .crank = 0.02, .rod = 0.008});
  m.gravity = {0, -9.81 * p[2], 0};
  auto& rod = std::get<BeamSpec>(m.bodies[1].kind);
  rod.material.E *= p[0];
  rod.material.rho *= p[1];
  rod.damping = 1e-5;
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = 20 * p[3];
  spring.damping = 0.1 * p[3];
  m.forces = {spring};
  return m;
}
const VectorXd kOnes = VectorXd::Ones(4);

SimulationOptions tight(double duration, double step) {
  auto o = testing::options(duration, step);
  o.tolerance = 1e-10;
  o.max_iterations = 40;
  return o;
}

template <FrameGroup G>
struct Taped {
  Model<G> model;
  Tape<G> tape;
  Taped(const Mechanism& m, const SimulationOptions& o)
      : model(Model<G>::build(m, space_of<G>(m))) {
    const auto run = simulate(model, o, {}, &tape);
    EXPECT_EQ(run.report.status, SolveStatus::Converged) << run.report.reason;
  }
};

/// What is asked of a state: positions of the middle of the rod, a velocity, an acceleration and a
/// multiplier, as numbers; and its derivatives by the state.
template <FrameGroup G>
VectorXd outputs(const Model<G>& model, const State<G>& s) {
  const int node = model.first_node(1) + 1;
  VectorXd y(G::space_dim + 3);
  y << s.H[std::size_t(node)].x, s.v[G::dim * node + 1], s.vdot[G::dim * node + 1], s.lambda[0];
  return y;
}

template <FrameGroup G>
MatrixXd output_derivatives(const Model<G>& model, const State<G>& s, const StateSensitivity& ds) {
  const int node = model.first_node(1) + 1, at = G::dim * node;
  MatrixXd dy(G::space_dim + 3, ds.v.cols());
  dy << s.H[std::size_t(node)].R * ds.eta.middleRows(at, G::space_dim), ds.v.row(at + 1),
      ds.w.row(at + 1), ds.lambda.row(0);
  return dy;
}

/// Column `column` of the cotangents: that of output i with a weight.
template <FrameGroup G>
void add_cotangents(const Model<G>& model, const State<G>& s, int i, double weight, int column,
                    StateSensitivity& bars) {
  const int node = model.first_node(1) + 1, at = G::dim * node;
  if (i < G::space_dim)
    bars.eta.col(column).segment(at, G::space_dim) +=
        weight * s.H[std::size_t(node)].R.row(i).transpose();
  else if (i == G::space_dim)
    bars.v(at + 1, column) += weight;
  else if (i == G::space_dim + 1)
    bars.w(at + 1, column) += weight;
  else
    bars.lambda(0, column) += weight;
}

template <class G>
class MotionSensitivity : public ::testing::Test {};
using Groups = ::testing::Types<SE2, SE3>;
TYPED_TEST_SUITE(MotionSensitivity, Groups);

/// J_i = sum over all steps of (weight of the step) y_i, and y_i at the last step alone.
TYPED_TEST(MotionSensitivity, DirectEqualsAdjoint) {
  using G = TypeParam;
  for (const int steps : {10, 100, 1000}) {
    if (steps == 1000 && G::space_dim == 3) continue;  // the same code; time
    const Taped<G> run(crank_by(kOnes), tight(steps * 1e-4, 1e-4));
    const LinearIn<G> derivative(crank_by, kOnes);
    const int outputs = G::space_dim + 3;
    const auto weight = [](long step) { return std::sin(0.3 + 0.1 * static_cast<double>(step)); };
    MatrixXd direct = MatrixXd::Zero(4, 2 * outputs);
    auto end = direct_sensitivity<G>(run.model, run.tape, derivative,
                                     [&](long step, const State<G>& s, const auto& ds) {
                                       const MatrixXd dy = output_derivatives(run.model, s, ds);
                                       direct.leftCols(outputs) += weight(step) * dy.transpose();
                                       direct.rightCols(outputs) = dy.transpose();
                                     });
    ASSERT_TRUE(end.complete()) << end.reason;
    MatrixXd adjoint;
    end = adjoint_sensitivity<G>(
        run.model, run.tape, derivative, 2 * outputs,
        [&](long step, const State<G>& s, StateSensitivity& bars, MatrixXd&) {
          for (int i = 0; i < outputs; ++i) {
            add_cotangents(run.model, s, i, weight(step), i, bars);
            if (step == run.tape.steps()) add_cotangents(run.model, s, i, 1, outputs + i, bars);
          }
        },
        adjoint);
    ASSERT_TRUE(end.complete()) << end.reason;
    for (int j = 0; j < 2 * outputs; ++j)
      EXPECT_LT((direct.col(j) - adjoint.col(j)).norm(), 1e-10 * direct.col(j).norm())
          << steps << " steps, functional " << j;
  }
}

/// Central differences of simulations: order 2, and 1e-7 at the best step.
TYPED_TEST(MotionSensitivity, EqualsDifferencesOfSimulations) {
  using G = TypeParam;
  const auto o = tight(0.01, 1e-4);
  const Taped<G> run(crank_by(kOnes), o);
  const LinearIn<G> derivative(crank_by, kOnes);
  MatrixXd dy, start;
  const auto end = direct_sensitivity<G>(run.model, run.tape, derivative,
                                         [&](long step, const State<G>& s, const auto& ds) {
                                           dy = output_derivatives(run.model, s, ds);
                                           if (step == 0) start = dy;
                                         });
  ASSERT_TRUE(end.complete()) << end.reason;
  for (int i = 0; i < 4; ++i) {
    double best = 1, best_start = 1;
    std::vector<double> errors;
    for (const double h : {0.04, 0.02, 0.01, 1e-3, 1e-4}) {
      VectorXd up = kOnes, down = kOnes;
      up[i] += h;
      down[i] -= h;
      const Taped<G> a(crank_by(up), o), b(crank_by(down), o);
      const auto error = [&](const State<G>& x, const State<G>& y, const VectorXd& exact) {
        const VectorXd difference = (outputs(a.model, x) - outputs(b.model, y)) / (2 * h);
        double worst = 0;
        for (int k = 0; k < exact.size(); ++k)
          worst = std::max(worst, std::abs(difference[k] - exact[k]) /
                                      std::max(std::abs(exact[k]), 1e-6 * exact.norm()));
        return worst;
      };
      errors.push_back(error(a.tape.end, b.tape.end, dy.col(i)));
      best = std::min(best, errors.back());
      best_start = std::min(best_start,
                            error(a.tape.checkpoints[0].s, b.tape.checkpoints[0].s, start.col(i)));
    }
    EXPECT_LT(best, 1e-6) << "parameter " << i;
    if (start.col(i).norm() > 1e-9) {
      EXPECT_LT(best_start, 1e-6) << "parameter " << i;
    }
    if (errors[0] > 1e-6) {  // else linear in p
      EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.1) << "parameter " << i;
      EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.1) << "parameter " << i;
    }
  }
}

TYPED_TEST(MotionSensitivity, RefusesWhatItCannotDifferentiate) {
  using G = TypeParam;
  const LinearIn<G> derivative(crank_by, kOnes);
  const auto direct = [&](const Mechanism& m) {
    const Taped<G> run(m, testing::options(1e-3, 1e-4));
    direct_sensitivity<G>(run.model, run.tape, derivative,
                          [](long, const State<G>&, const StateSensitivity&) {});
  };
  Mechanism jerked = crank_by(kOnes);
  jerked.drives = {{0, 0, TimeFunction::rate(150, 0)}};
  EXPECT_THROW(direct(jerked), std::invalid_argument);
  Mechanism classical = crank_by(kOnes);
  classical.formalism = Formalism::Classical;
  EXPECT_THROW(direct(classical), std::invalid_argument);
  EXPECT_NO_THROW(direct(crank_by(kOnes)));
}

}  // namespace
}  // namespace liesl
