#pragma once
/// @file
/// What a user may set of a simulation. Defaults are good for a first run.

#include <string>
#include <vector>

namespace liesl {

enum class SimulationType { Dynamic, Static, Modes };
enum class SpaceChoice { Auto, Planar, Spatial };

/// Where a motion starts.
enum class StartChoice {
  Assembled,   ///< where the scene puts the bodies, undeformed: weight and loads strike them
  Equilibrium  ///< in equilibrium under the weight and the loads of t = 0, drives where they are
               ///< then
};

/// When the matrix of the Newton iteration is factored.
enum class TangentStrategy {
  Auto,      ///< the formalism's: constant, again where steps take many corrections; adaptive
             ///< (r3so3, floating), exact (classical)
  Constant,  ///< once, at the reference shape; again only where the iteration would fail
  Adaptive,  ///< again at the current state whenever a correction gains less than a digit
  Exact      ///< in every iteration
};

struct SimulationOptions {
  SimulationType type = SimulationType::Dynamic;
  SpaceChoice space = SpaceChoice::Auto;

  // Dynamic: Lie-group generalized-alpha, index 3.
  double duration = 1.0;  ///< s, > 0
  double step = 1e-3;     ///< s, > 0; the largest step if adaptive
  double rho_inf = 0.8;   ///< spectral radius at infinity, [0, 1]
  TangentStrategy tangent = TangentStrategy::Auto;
  bool rescale = true;            ///< classical: rotation vectors are kept below pi
  double tolerance = 1e-5;        ///< of the residual, relative to the forces, (0, 1e-2]
  int max_iterations = 12;        ///< corrections a step before the step is halved, [3, 100]
  bool adaptive = false;          ///< choose the step from a local error estimate
  double error_tolerance = 1e-4;  ///< adaptive: local error relative to the scene's size, per step
  double step_min = 0;            ///< s; 0 = step / 1024
  int output_every = 1;           ///< steps between two records, >= 1
  StartChoice start = StartChoice::Assembled;

  // Static: load factor from 0 to 1.
  double at = 0;            ///< s, >= 0; static, modes: time of drives and other functions of time
  int load_steps = 1;       ///< >= 1
  bool arc_length = false;  ///< follow the path past limit points
  double max_load = 1.0;    ///< load factor at which the path ends, > 0
  bool critical = false;    ///< bisect the load factor where the tangent loses definiteness

  // Modes: about the static equilibrium.
  int modes = 10;  ///< how many frequencies, >= 1

  /// All values that are out of their range, one sentence each with key, what is expected and what
  /// is there: "simulation.step: a number above 0 s is expected, not 0". Empty: the options are
  /// valid.
  std::vector<std::string> errors() const;
  /// @throws std::invalid_argument with all of errors(), a line each
  void require_valid() const;
};

}  // namespace liesl
