#pragma once
/// @file
/// Derivative of the forces of a body by its shape at rest.

#include <Eigen/Core>

#include "liegroup/concepts.hpp"

namespace liesl {

template <FrameGroup G>
class Body;
template <FrameGroup G>
struct BodyState;

/// The same body at a nearby value of a parameter: d(quantity)/dp = sum of weight times quantity.
template <FrameGroup G>
struct NearbyBody {
  double weight;  ///< 1 per unit of p
  const Body<G>* body;
};

/// d/dp of the state of a body: left-invariant increments of its nodes, of v and of vdot, dim a
/// node.
struct StateDirection {
  const double *eta, *v, *vdot;
};

/// d(add_internal + add_inertia)/dp where the shape at rest changes with p and the state along a
/// direction. With states that go with the shape no strain is the difference of large ones: forces
/// are exact to the round-off of forces, whatever the stiffness.
template <FrameGroup G>
class ShapeDerivative {
 public:
  using Vector = Eigen::Matrix<double, G::space_dim, 1>;
  virtual ~ShapeDerivative() = default;
  /// @param gravity of the body and @param dgravity what it changes by  @param r += dr/dp
  virtual void add(const BodyState<G>& s, const StateDirection& d, const Vector& gravity,
                   const Vector& dgravity, double* r) const = 0;
};

}  // namespace liesl
