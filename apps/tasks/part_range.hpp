#pragma once
/// @file
/// How far a body in a floating frame, a meshed part or a beam, goes beyond what it can describe:
/// its deformation is linear in its frame; and beams that could leave the plane of their motion.

#include <string>
#include <vector>

#include "mbs/bodies/modal.hpp"
#include "mbs/bodies/solid_body.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/solvers/trajectory.hpp"
#include "mbs/system/model.hpp"

namespace liesl {

/// What is largest of a body over the states of a simulation.
struct PartRange {
  double bend = 0;      ///< turn of an interface or a node against the first, rad
  double euler = 0;     ///< compression over the Euler load; parts of two interfaces, beams
  double pull = 0;      ///< tension over it, at the first interface or in an element
  double spin = 0;      ///< (Omega_J/omega_1)^2; parts of one interface
  double sideways = 0;  ///< compression of a beam in a plane over its Euler load out of the plane
  double twist = 0;     ///< of a chain of segments in space whose ends are held, or turned, rad
  double turn = 0;      ///< of its ends about the axis, rad/s
  double speed = 0;     ///< of its ends over its length, 1/s
};

/// A note on a range. `beyond`: the result cannot be relied on.
struct RangeNote {
  std::string text;
  bool beyond = false;
};

/// Ranges of meshed parts and of beams in floating frames, state after state.
///
/// Parts of two interfaces: compression N = -d . f_1, f = K_e e the force on the second interface,
/// d the direction from the first to it. Euler load between hinges of a bar that is as soft across
/// d as the part held at its first interface, y = F L^3/(3 EI): P_E = pi^2 EI/L^2 = pi^2 L/(3 y/F).
/// Tension is -N, with the share of the first interface in the centrifugal force of a part that
/// turns, m Omega^2 L/6 with Omega = |Omega x d|; that of the second, m Omega^2 L/3, is in f_1.
///
/// A part of one interface has no force at another, and no turn of it. With Omega the angular
/// velocity of its frame and J its inertia about the interface, Omega_J^2 = Omega . J Omega over
/// the largest principal value of J: |Omega x d|^2 of a slender blade along d. omega_1 is its
/// lowest circular frequency held at the interface: what spins is stiffened by its tension, omega^2
/// = omega_1^2 + c Omega^2 with c from 0.2 (bending in the plane of rotation) to 1.2 (out of it), a
/// linear part is softened instead. Its turn is that of the end of a slender cantilever in its
/// first mode with the same r.m.s. of displacement over distance from the interface, 1.6 sqrt(e^T
/// M_e e / int rho r^2).
///
/// Beams in floating frames: turns of their nodes, normal forces of their elements, the Euler load
/// from the softness of the end held at the start.
///
/// Chains of segments in space have no torsion: where joints at both ends hold the turn about the
/// axis, or a moment, a force beside the axis or a spin at the start may turn an end that is free,
/// the turn of the last frame against the first, carried along the chain without twist,
/// is what torsion would resist; against how far the chain turns by bending.
/// Nor have their nodes inside a spin about the axis: its angular momentum, rho I_p L omega,
/// against that of the motion across, rho A L^2 v/3, from the largest speeds of their ends.
///
/// Out of the plane: pi^2 EI/L^2, EI the least of its elements about the axis in the plane, of all
/// flexible beams where some are in floating frames or chains of segments (`PlaneStability` knows
/// neither).
template <FrameGroup G>
class PartRanges {
 public:
  /// @param mechanism outlives it, as does the model
  PartRanges(const Mechanism& mechanism, const Model<G>& model);
  /// @param s completed
  void add(const State<G>& s);
  void add(const Trajectory<G>& records);

  /// A note for each bound that is passed: a tenth of the Euler load and of (Omega_J/omega_1)^2,
  /// 0.15 rad. Beyond: 1.5 rad, where a cantilever is as far off its line as it is
  /// long, the Euler load in compression, (Omega_J/omega_1)^2 = 1, where the
  /// part would bend for ever. Of a chain a twist of a fiftieth of its bending, and as much of the
  /// angular momentum in its spin; beyond: a fifth.
  std::vector<RangeNote> notes() const;
  /// A note on the beam that carries most of its Euler load out of the plane, above a fourth of
  /// that between hinges, where one with a free end buckles.
  std::vector<std::string> leaving_plane() const;

 private:
  /// Of a meshed part; those of two interfaces have an Euler load, those of one modes.
  struct Part {
    const SolidBody<G>* body;
    int index;
    Eigen::VectorXd d;       ///< from the first interface to the second, in axes of the first
    Eigen::VectorXd pull;    ///< tension by the coordinates of the second interface, N
    double euler = 0;        ///< N; 0: none
    double centrifugal = 0;  ///< m L/6, kg m
    Eigen::MatrixXd J;       ///< about the interface, kg m^2; empty: not a part of one interface
    double largest = 0;      ///< principal value of J
    double r2 = 0;           ///< int rho r^2, kg m^2
    double omega2 = 0;       ///< omega_1^2
    PartRange range;
  };
  struct Member {
    const Body<G>* body;
    const ModalBody<G>* modal;  ///< null: not in a floating frame
    int index;
    double euler = 0, sideways = 0;  ///< Euler loads, N; 0: none
    PartRange range = {};
    bool may_twist = false;  ///< a chain in space, of which `twist` tells something
    double polar = 0;        ///< of a chain in space: 3 I_p/(A L^2)
  };

  void add_part(const SolidBody<G>& body, int index);
  void add_members();
  double sideways_load(int body) const;
  bool may_twist(int body) const;
  void measure_twist(Member& chain, const State<G>& s) const;
  static double polar_share(const BeamSpec& chain);
  void measure_spin(Member& chain, const BodyState<G>& state) const;
  void measure(Part& part, const State<G>& s) const;
  void measure(Member& beam, const State<G>& s) const;

  const Mechanism& mechanism_;
  const Model<G>& model_;
  std::vector<Part> parts_;
  std::vector<Member> members_;
};

extern template class PartRanges<SE2>;
extern template class PartRanges<SE3>;

}  // namespace liesl
