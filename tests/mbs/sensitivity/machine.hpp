#pragma once
/// @file
/// A slider-crank with parameters of all kinds, what is asked of its states, and differences of
/// simulations: what the tests of sensitivities share.

#include <Eigen/QR>
#include <functional>
#include <limits>

#include "mbs/run.hpp"
#include "mbs/sensitivity/motion_sensitivity.hpp"

namespace liesl::test {

/// A scale with kinks, as a function of its second value.
inline TimeFunction pulse(double top) {
  return TimeFunction::table({0, 0.007, 0.013, 0.03}, {0.2, top, 0.4, 0.5},
                             TimeFunction::Interpolation::Linear);
}
/// Of a plastic: differences of simulations are as exact as what EA/L makes of the round-off in
/// positions, which is small beside the forces of inertia then. With a tenth of E their errors are
/// a tenth. Under its weight, with a load on the rod, one that varies by a table, a spring with a
/// damper between crank and rod, and a disc on the crank whose centre of mass is off it.
inline Mechanism sensitive_machine(double E = 7e9) {
  Mechanism m = test::slider_crank({.elements = 3, .crank = 0.02, .rod = 0.016, .ramp = 0.02});
  for (std::size_t b : {0, 1})
    std::get<BeamSpec>(m.bodies[b].kind).material = {"plastic", E, 0.3, 1200};
  m.gravity = {0, -9.81, 0};
  std::get<BeamSpec>(m.bodies[1].kind).damping = 1e-5;
  ForceSpec spring;
  spring.name = "spring";
  spring.joint = 1;
  spring.stiffness = 20;
  spring.damping = 0.1;
  spring.rest = 0.01;
  m.forces = {spring};
  LoadSpec load;
  load.name = "load";
  load.port = {1, 2};
  load.force = {3, -8, 0};
  LoadSpec pulsing = load;
  pulsing.name = "pulsing";
  pulsing.port = {1, 1};
  pulsing.scale = pulse(1);
  m.loads = {load, pulsing};
  RigidSpec disc = block({0.05, 0, 0}, 0.05, 1e-4);
  disc.centre = {0.01, 0.02, 0};
  m.bodies.push_back({"disc", disc});
  m.joints.push_back({"bolt", JointType::Fixed, {0, 1}, {3, 0}});
  return m;
}

/// A quantity of the machine: its value, how it is changed, its derivative.
struct Quantity {
  double nominal;
  std::function<void(Mechanism&, double)> set;
  Parameter parameter;
};

inline std::vector<Quantity> quantities(const Mechanism& m) {
  const auto beam = [](Mechanism& c, std::size_t b) -> BeamSpec& {
    return std::get<BeamSpec>(c.bodies[b].kind);
  };
  const auto diameters = [beam](std::vector<std::size_t> elements) {
    return [beam, elements](Mechanism& c, double p) {
      for (const auto e : elements) std::get<Circle>(beam(c, 1).sections[e].shape).diameter = p;
    };
  };
  return {
      {0.016, diameters({0, 1}), {"diameter 1", {by_dimension(m, 1, {0, 1}, "diameter")}}},
      {0.016, diameters({2}), {"diameter 2", {by_dimension(m, 1, {2}, "diameter")}}},
      {std::get<BeamSpec>(m.bodies[1].kind).material.E,
       [beam](Mechanism& c, double p) { beam(c, 1).material.E = p; },
       {"E", {by_youngs_modulus(m, 1)}}},
      {1200,
       [beam](Mechanism& c, double p) { beam(c, 0).material.rho = p; },
       {"rho", {by_density(m, 0)}}},
      {0.2,
       [](Mechanism& c, double p) { std::get<RigidSpec>(c.bodies[2].kind).mass = p; },
       {"mass of the slider", {RigidDerivative{2, 1}}}},
      {20,
       [](Mechanism& c, double p) { c.forces[0].stiffness = p; },
       {"spring", {ForceDerivative{.force = 0, .stiffness = 1}}}},
      {0.1,
       [](Mechanism& c, double p) { c.forces[0].damping = p; },
       {"damper", {ForceDerivative{.force = 0, .damping = 1}}}},
      {0.1,
       [](Mechanism& c, double p) { c.forces[0].rest = p - 0.09; },
       {"rest", {ForceDerivative{.force = 0, .rest = 1}}}},
      {1e-4,
       [](Mechanism& c, double p) { std::get<RigidSpec>(c.bodies[3].kind).inertia(2, 2) = p; },
       {"inertia of the disc", {RigidDerivative{3, 0, Vec3::Zero(), Vec3(0, 0, 1).asDiagonal()}}}},
      {0.02,
       [](Mechanism& c, double p) { std::get<RigidSpec>(c.bodies[3].kind).centre.y() = p; },
       {"centre of the disc", {RigidDerivative{3, 0, {0, 1, 0}}}}},
      {-8,
       [](Mechanism& c, double p) { c.loads[0].force.y() = p; },
       {"component of the load", {LoadDerivative{0, 0, {}, {0, 1, 0}}}}},
      {1,
       [](Mechanism& c, double p) { c.loads[1].scale = pulse(p); },
       {"value of the table", {LoadDerivative{1, 0, {{0.5, pulse(2)}, {-0.5, pulse(0)}}}}}},
      {1,
       [](Mechanism& c, double p) { c.loads[0].scale = TimeFunction::constant(p); },
       {"load", {LoadDerivative{0, 1}}}},
      {150,
       [](Mechanism& c, double p) { c.drives[0].motion = TimeFunction::rate(p, 0.02); },
       {"drive", {DriveDerivative{0, 1. / 150}}}},
  };
}

/// A quantity that is known by nearby mechanisms alone.
inline Quantity by_nearby(const std::string& name, const Mechanism& m, double nominal,
                          const std::function<void(Mechanism&, double)>& set) {
  const double step = std::abs(nominal) / 1024;
  std::array<Mechanism, 4> at{m, m, m, m};
  for (const auto& [i, steps] : {std::pair<std::size_t, int>{0, -2}, {1, -1}, {2, 1}, {3, 2}})
    set(at[i], nominal + steps * step);
  return {
      nominal,
      set,
      {name,
       {NearbyMechanisms{std::make_shared<const std::array<Mechanism, 4>>(std::move(at)), step}}}};
}

inline SimulationOptions tight(double duration, double step) {
  auto o = options(duration, step, 0.8, 1e-11);
  o.max_iterations = 40;
  o.tangent = TangentStrategy::Exact;  // ends at round-off, not just below the tolerance
  return o;
}

/// A simulation with its tape.
template <FrameGroup G>
struct Taped {
  Mechanism mechanism;
  Model<G> model;
  Tape<G> tape;
  DynamicResult<G> run;

  /// @param every accepted steps between two checkpoints, see Tape
  Taped(const Mechanism& m, const SimulationOptions& o, int every = 0)
      : mechanism(m), model(Model<G>::build(m, space_of<G>(m))) {
    tape.every = every;
    run = simulate(model, o, {}, &tape);
    EXPECT_EQ(run.report.status, SolveStatus::Converged) << run.report.reason;
  }
  Parameters<G> parameters(const std::vector<Quantity>& all) const {
    Parameters<G> made;
    for (const Quantity& q : all) made.emplace_back(mechanism, model, q.parameter);
    return made;
  }
};

/// Central differences with steps h, h/2, ..., by the relative change of a quantity, and their
/// extrapolations to h = 0 (W. Romberg 1955): errors O(h^4), O(h^6), ... at steps where the
/// round-off of simulations, that is divided by them, is small.
struct Differences {
  std::vector<Eigen::MatrixXd> central, extrapolated;

  Differences(const std::function<Eigen::MatrixXd(double)>& f, double h, int count) {
    for (int i = 0; i < count; ++i, h /= 2) central.push_back((f(h) - f(-h)) / (2 * h));
    auto column = central;
    for (double power = 4; column.size() > 1; power *= 4) {
      for (std::size_t i = 0; i + 1 < column.size(); ++i)
        column[i] = (power * column[i + 1] - column[i]) / (power - 1);
      column.pop_back();
      extrapolated.insert(extrapolated.end(), column.begin(), column.end());
    }
  }
  /// Adds the slopes at 0 of polynomials in odd powers, fitted to `samples` differences up to the
  /// step h by least squares: round-off averages out.
  void fit(const std::function<Eigen::MatrixXd(double)>& f, double h, int samples) {
    constexpr int kFewest = 3, kMost = 8;  // powers
    std::vector<Eigen::MatrixXd> odd;
    Eigen::MatrixXd V(samples, kMost);
    for (int k = 0; k < samples; ++k) {
      const double x = double(k + 1) / samples;
      odd.push_back((f(h * x) - f(-h * x)) / (2 * h));
      for (int j = 0; j < kMost; ++j) V(k, j) = std::pow(x, 2 * j + 1);
    }
    for (int powers = kFewest; powers <= kMost; ++powers) {
      const Eigen::HouseholderQR<Eigen::MatrixXd> qr(V.leftCols(powers));
      const Eigen::MatrixXd weights = qr.solve(Eigen::MatrixXd::Identity(samples, samples));
      Eigen::MatrixXd slope = weights(0, 0) * odd[0];
      for (int k = 1; k < samples; ++k) slope += weights(0, k) * odd[std::size_t(k)];
      extrapolated.push_back(slope);
    }
  }
  /// Least of the largest errors over all extrapolations: some err by h, others by round-off.
  double least(const std::function<double(const Eigen::MatrixXd&)>& largest_error) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& y : extrapolated) least = std::min(least, largest_error(y));
    return least;
  }
};

/// Sizes of quantities in groups of one kind: their own, or the largest of the group where the own
/// is below `least` of it (zero by symmetry).
inline Eigen::VectorXd sizes(Eigen::VectorXd own, const std::vector<int>& groups,
                             double least = 1e-6) {
  int at = 0;
  for (const int n : groups) {
    const double largest = n > 0 ? own.segment(at, n).maxCoeff() : 0;
    for (int i = at; i < at + n; ++i)
      if (own[i] < least * largest) own[i] = largest;
    at += n;
  }
  return own;
}

}  // namespace liesl::test
