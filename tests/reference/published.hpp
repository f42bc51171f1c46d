#pragma once
/// @file
/// Published and independently recomputed values of dynamics.

#include <Eigen/Core>
#include <array>

namespace liesl::test {

/// O. Bruels, A. Cardona, M. Arnold, "Lie group generalized-alpha time integration of constrained
/// flexible multibody systems", Mech. Mach. Theory 48 (2012): heavy top. Values of an adaptive
/// Runge-Kutta integration at 1e-13; x = centre of mass, omega in body axes, reaction = force of
/// the ground on the body in inertial axes.
struct HeavyTopState {
  double t;
  Eigen::Vector3d x, omega, reaction;
};
inline const HeavyTopState heavy_top_half{0.5,
                                          {-0.702468297057, -0.021165184702, -0.711400257652},
                                          {-0.471053101741, 150, 5.901083048326},
                                          {523.281243515, 404.206178320, 357.336176453}};
inline const HeavyTopState heavy_top_one{1.0,
                                         {0.173343964098, 0.640088592070, -0.748490791134},
                                         {-0.822078101692, 150, -5.923291348116},
                                         {-517.600739477, -396.843101489, 404.574925163}};
inline constexpr double heavy_top_energy = 5435.6967908655;  // J
/// Errors (largest component) of generalized-alpha on SE(3) at t = 1, rho = 0.9.
struct HeavyTopError {
  double step, x, omega, reaction;
};
inline constexpr std::array<HeavyTopError, 3> heavy_top_errors{
    {{1e-3, 0.0620, 1.24, 83.6}, {5e-4, 0.0153, 0.313, 21.1}, {2.5e-4, 0.00380, 0.0784, 5.27}}};

/// J. C. Simo, L. Vu-Quoc, "On the dynamics in space of rods undergoing large motions", CMAME 66
/// (1988): free-flying beam in 3-D, ends A (loaded) and B, mesh- and step-converged to 3 digits.
struct FlyingBeamState {
  double t;
  Eigen::Vector3d A, B;
};
inline const std::array<FlyingBeamState, 2> flying_beam_states{
    {{2.5, {3.413, 0.197, 0.017}, {4.024, 8.496, -0.733}},
     {5.0, {19.560, 1.520, -1.507}, {11.876, 6.879, 1.831}}}};

/// T. R. Kane, R. R. Ryan, A. K. Banerjee, "Dynamics of a cantilever beam attached to a moving
/// base", J. Guidance 10 (1987): spin-up manoeuvre. Lag of the tip behind the shadow beam and its
/// steady extension rho A omega^2 L^3/(3 EA), m.
inline constexpr double spin_up_lag = 0.5738, spin_up_lag_5 = 0.5654, spin_up_extension = 5.143e-4;

/// Flexible pendulum, tip at 0.5 and 1 s (mesh- and step-converged second code).
struct PendulumTips {
  int elements;
  double step;
  Eigen::Vector2d half, one;
};
inline const PendulumTips pendulum_coarse{16, 1e-3, {-0.09950, -0.99492}, {-0.99760, 0.02287}};
inline const PendulumTips pendulum_fine{64, 5e-5, {-0.09984, -0.99487}, {-0.99752, 0.02316}};

/// Slider-crank: largest midspan offset of the rod from its chord and slider at 0.12 s, m.
struct SliderCrankRow {
  int elements;
  double step, rod, offset, offset_tolerance, slider, slider_tolerance;
};

}  // namespace liesl::test
