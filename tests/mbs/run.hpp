#pragma once
/// @file
/// Runs a mechanism in a test and reads what came out.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include "mbs/solvers/dynamics.hpp"
#include "mbs/system/energy.hpp"
#include "mbs/system/penalty.hpp"
#include "mbs/system/plane.hpp"
#include "reference/mechanisms.hpp"

namespace liesl::test {

/// Space, or the plane of a mechanism that has one.
template <FrameGroup G>
Space<G> space_of(const Mechanism& m) {
  if constexpr (G::space_dim == 2) {
    const PlaneSearch found = find_plane(m);
    if (!found.plane) throw std::runtime_error("not planar: " + found.reason);
    return *found.plane;
  } else {
    return {};
  }
}

template <class G>
struct Run {
  std::unique_ptr<Model<G>> model;
  DynamicResult<G> result;
  const Trajectory<G>& trajectory() const { return result.trajectory; }
  const Report& report() const { return result.report; }
  int last() const { return trajectory().size() - 1; }
  /// Record at time t. @pre the records are `every` seconds apart
  int at(double t, double every) const { return int(std::lround(t / every)); }
};

template <class G>
Run<G> run(const Mechanism& m, const Space<G>& space, const SimulationOptions& options) {
  Run<G> r;
  r.model = std::make_unique<Model<G>>(Model<G>::build(m, space));
  r.result = simulate(*r.model, options);
  return r;
}
inline Run<SE3> run_spatial(const Mechanism& m, const SimulationOptions& options) {
  return run<SE3>(m, {}, options);
}
inline Run<SE2> run_planar(const Mechanism& m, const SimulationOptions& options) {
  return run<SE2>(m, space_of<SE2>(m), options);
}

inline SimulationOptions options(double duration, double step, double rho = 0.8,
                                 double tolerance = 1e-6) {
  SimulationOptions o;
  o.duration = duration;
  o.step = step;
  o.rho_inf = rho;
  o.tolerance = tolerance;
  return o;
}

/// Number in State::rows of a joint coordinate, -1 if the coupling does not keep it.
template <class G>
int row_of(const Model<G>& model, int coupling, int coordinate) {
  const auto& c = model.couplings[std::size_t(coupling)];
  for (std::size_t i = 0; i < c.rows.size(); ++i)
    if (c.rows[i].coordinate == coordinate) return c.first_row + int(i);
  return -1;
}

/// Wrench of a joint's multipliers on its port b, in the axes of b: -B_b^T lambda.
template <class G>
typename G::Tangent joint_wrench(const Model<G>& model, const G* H, const Eigen::VectorXd& lambda,
                                 int coupling) {
  const auto& c = model.couplings[std::size_t(coupling)];
  const Frames<G> frames(H, H + model.nodes());
  const RelativeMotion<G> motion(c.a.frame(frames), c.b.frame(frames));
  typename G::Tangent wrench = G::Tangent::Zero();
  for (int i = 0; i < c.constraints; ++i) {
    typename Row<G>::Gradient g;
    c.rows[std::size_t(i)].row.gradient(motion, g);
    wrench -= lambda[c.first_constraint + i] * g.template tail<G::dim>();
  }
  return wrench;
}

/// Kinetic + elastic + potential energy of a record, J.
template <class G>
double total_energy(const Run<G>& r, int record) {
  State<G> s = r.model->initial_state();
  r.trajectory().read(record, s);
  return total(mechanical_energy(*r.model, s));
}

/// Largest |E(t) - E(0) - integral of the power|, J, by the trapezoidal rule over records `step` s
/// apart. @param power of a state, W
template <class G, class Power>
double largest_energy_imbalance(const Run<G>& r, double step, const Power& power) {
  State<G> s = r.model->initial_state();
  PenaltyWork<G> of_penalties(*r.model);
  double work = 0, before = 0, worst = 0;
  for (int i = 0; i < r.trajectory().size(); ++i) {
    r.trajectory().read(i, s);
    const double now = power(s);
    if (i > 0) work += 0.5 * step * (before + now);
    work += of_penalties.step(s);
    before = now;
    worst = std::max(worst, std::abs(total_energy(r, i) - total_energy(r, 0) - work));
  }
  return worst;
}

/// Largest offset of the middle node from the chord of a chain of nodes first .. first + n.
template <class G>
double largest_chord_offset(const Trajectory<G>& t, int first, int n) {
  double largest = 0;
  for (int i = 0; i < t.size(); ++i) {
    const G* H = t.frames(i) + first;
    const auto chord = ((H[n].x - H[0].x).normalized()).eval();
    const auto d = (H[n / 2].x - H[0].x).eval();
    largest = std::max(largest, (d - chord * chord.dot(d)).norm());
  }
  return largest;
}

/// Numbers in [-1, 1] that are the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()() { return distribution_(engine_); }
  Eigen::VectorXd vector(int n) {
    return Eigen::VectorXd::NullaryExpr(n, [this] { return (*this)(); });
  }
  Eigen::MatrixXd matrix(int rows, int columns) {
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [this] { return (*this)(); });
  }
  /// Symmetric positive definite.
  Eigen::MatrixXd spd(int n) {
    const Eigen::MatrixXd a = matrix(n, n);
    return a * a.transpose() + 0.5 * Eigen::MatrixXd::Identity(n, n);
  }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> distribution_{-1, 1};
};

}  // namespace liesl::test
