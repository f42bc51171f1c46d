#pragma once
/// @file
/// A scalar parameter p of a mechanism as data: the derivatives d/dp of what depends on it. What is
/// not named does not depend on p; what has no derivative of its own, geometry (frames, lengths,
/// axes) above all, is a matter of `NearbyMechanisms`.

#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "mbs/model/element_place.hpp"
#include "mbs/model/mechanism.hpp"
#include "mbs/sections/section_law.hpp"

namespace liesl {

/// Section laws of a beam.
struct BeamDerivative {
  int body = -1;
  std::vector<SectionLaw> laws;  ///< d(K, M_s)/dp by element, section axes in space
  /// The same at both ends of the elements of a taper; empty: as `laws`.
  std::vector<std::array<SectionLaw, 2>> ends = {};
  /// dS/dp by element, see `element_stress_points`; empty = they do not depend on p.
  std::vector<std::vector<Eigen::Matrix<double, 3, 6>>> stress = {};

  /// d(K, M_s)/dp at a place of element e.
  const SectionLaw& law_at(std::size_t e, ElementPlace place) const;

  /// By a parameter that moves several dimensions alike. @pre of the same beam
  BeamDerivative& operator+=(const BeamDerivative& other);
};

/// Mass, centre of mass and inertia about it of a rigid body.
struct RigidDerivative {
  int body = -1;
  double mass = 0;             ///< kg per unit of p
  Vec3 centre = Vec3::Zero();  ///< body axes
  Mat3 inertia = Mat3::Zero();
};

/// Fractions of the cells of a meshed part.
struct SolidDerivative {
  int body = -1;
  Eigen::VectorXd fractions;  ///< by cell
};

/// df/dp of a function of time, as a sum of weights times functions.
struct WeightedFunction {
  double weight = 0;
  TimeFunction function;
};
using FunctionDerivative = std::vector<WeightedFunction>;

/// Material and thickness of all of a meshed part, geometry and Poisson's ratio fixed.
struct SolidScale {
  int body = -1;
  double E = 0, rho = 0, thickness = 0;  ///< relative, 1 per unit of p: 1/E by E

  double stiffness() const { return E + thickness; }  ///< dK/dp / K
  double mass() const { return rho + thickness; }     ///< dM/dp / M
};

/// Spring, damper and rest value of a force law; of its F(t) a factor and any change in time.
struct ForceDerivative {
  int force = -1;  ///< number in Mechanism::forces
  double stiffness = 0, damping = 0, rest = 0, factor = 0;
  FunctionDerivative function = {};  ///< N per unit of p
};

/// Of the scale s(t) of a load a factor and any change in time; its components.
struct LoadDerivative {
  int load = -1;
  double factor = 1;
  FunctionDerivative scale = {};
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();  ///< axes as in LoadSpec
};

/// Of the motion of a drive a factor and any change in time.
struct DriveDerivative {
  int drive = -1;
  double factor = 1;
  FunctionDerivative motion = {};  ///< m or rad per unit of p
};

/// Weights alpha of penalties; those that are chosen do not depend on p.
struct PenaltyDerivative {
  double displacement = 0, rotation = 0;  ///< dalpha/dp of lengths, of angles
};

/// Of the duration of a motion that takes as many steps, its drives being functions of t/duration:
/// every step changes by dh/dp = relative h, and targets of drives at a step do not change. Nothing
/// else may depend on time.
struct StepDerivative {
  double relative = 0;  ///< dh/dp / h: 1/duration by the duration itself
};

/// By all that p changes, as differences of fourth order of the equations at constant state, of the
/// start and of the responses: geometry, Poisson's ratio, gravity, velocities at the start. The
/// only part of its parameter.
struct NearbyMechanisms {
  static constexpr std::array kWeights = {1., -8., 8., -1.};  ///< over 12 step
  /// At p - 2 step, p - step, p + step, p + 2 step.
  std::shared_ptr<const std::array<Mechanism, 4>> at;
  double step = 0;  ///< unit of p

  double weight(std::size_t i) const { return kWeights[i] / (12 * step); }
};

struct Parameter {
  std::string name;
  std::vector<std::variant<BeamDerivative, RigidDerivative, SolidDerivative, SolidScale,
                           ForceDerivative, LoadDerivative, DriveDerivative, PenaltyDerivative,
                           StepDerivative, NearbyMechanisms>>
      parts;
};

/// By a dimension of the sections of some elements (none given: of all).
/// @throws std::invalid_argument for a body that is no beam, an element or a dimension that does
/// not exist
BeamDerivative by_dimension(const Mechanism& mechanism, int body, const std::vector<int>& elements,
                            std::string_view dimension);
/// By Young's modulus (Poisson's ratio fixed): dK/dE = K/E; by the density: dM_s/drho = M_s/rho.
/// @throws std::invalid_argument for a body that is no beam, or with sections given by matrices
BeamDerivative by_youngs_modulus(const Mechanism& mechanism, int body);
BeamDerivative by_density(const Mechanism& mechanism, int body);

/// Generalized inertia of a rigid body about its frame, conjugate to [u; w], c the centre of mass:
///   M = [m 1, -m c~; m c~, J - m c~ c~], and its derivative.
SE3::Matrix generalized_inertia(const RigidSpec& rigid);
SE3::Matrix generalized_inertia_derivative(const RigidSpec& rigid, const RigidDerivative& by);

}  // namespace liesl
