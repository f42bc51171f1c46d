#pragma once
/// @file
/// The port of an averaged interface of a body whose nodes all move (RBE3). With the places s_i of
/// the nodes in the axes of the port at rest, y_i = R^T (x_i - x) where they are now, and Q an
/// orthonormal basis of the rigid motions [I, -s~_i] of all nodes together,
///   c = Q^T (y - s),  V = k c^T c / 2,
/// so that the port moves as the nodes do by least squares but for what its force strains the
/// stiffness k; the nodes stay free to deform. Forces on them are f = k Q c, spread as those of a
/// rigid motion are, and -[sum f_i; sum y_i x f_i] on the port: in balance in any shape.
/// The port has inertia m [u' + w x u - R^T g], j w', a small share of that of its nodes, without
/// which its accelerations would not be known; it weighs m g, so that it falls as all else.

#include <Eigen/StdVector>
#include <vector>

#include "liegroup/rotation.hpp"
#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/body.hpp"

namespace liesl {

/// w x y = turn(y) w, so that y x f = turn(y)^T f.
template <class G>
auto turn(const Eigen::Matrix<double, G::space_dim, 1>& y) {
  return (-RotationOf<G>::cross(y)).eval();
}

template <FrameGroup G>
class AveragedPort {
 public:
  static constexpr int dim = G::dim, sd = G::space_dim, rd = G::rotation_dim;
  using Tangent = typename G::Tangent;
  using Points = Eigen::Matrix<double, sd, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<double, sd, 1>;

  /// @param port node of the body  @param nodes nodes of the body, one a place
  /// @param places s_i, m  @param stiffness k, N/m  @param mass m, kg
  AveragedPort(int port, std::vector<int> nodes, Points places, double stiffness, double mass);

  int port() const { return port_; }
  const std::vector<int>& nodes() const { return nodes_; }
  int strains() const { return static_cast<int>(Q_.cols()); }  ///< length of c
  /// Components of the port and of its nodes, dim and sd each, in the unknowns of the body.
  std::vector<int> unknowns() const;

  /// k c; with increments of the body also what it changes by to first order.
  Eigen::VectorXd stress(const G* H, const double* delta = nullptr) const;
  double elastic_energy(const G* H) const;
  double kinetic_energy(const double* v) const;
  double potential_energy(const G* H, const Vector& gravity) const {
    return -mass_ * gravity.dot(H[port_].x);
  }
  /// Elastic forces times a weight, in the axes of the nodes of the body. @param scale may be null
  void add_internal(const G* H, double weight, double* r, ForceScale* scale) const;
  /// Of inertia and weight.
  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r) const;
  /// Weight times a factor, as forces that do work: -m R^T g by the place of the port.
  void add_weight(const G* H, const Vector& gravity, double factor, double* r) const;
  /// Of the weight by the turn of the port.
  typename G::Matrix weight_stiffness(const G* H, const Vector& gravity) const;
  /// Gradient of the kinetic energy times a weight.
  void add_momentum(const double* v, double weight, double* out) const;

  /// Derivatives of the forces by increments of `unknowns()`, with k c = `stress` in their
  /// geometric part; of the forces of inertia by v and by v'.
  Eigen::MatrixXd stiffness_at(const G* H, const Eigen::VectorXd& stress) const;
  Eigen::MatrixXd damping_at(const double* v) const;
  Eigen::MatrixXd mass() const;

  /// d/dp of what the port is made of: the places s_i and, of the rigid motions A = [I, -s~_i] of
  /// all nodes, dA and A^+; Q Q^T then changes by (I - Q Q^T) dA A^+ and the transposed of it.
  struct Variation {
    Points places;
    Eigen::MatrixXd motions, inverse;
    double stiffness = 0, mass = 0, inertia = 0;
  };
  /// By ports of the same nodes at nearby values, each with its weight.
  Variation variation(const std::vector<std::pair<double, const AveragedPort*>>& nearby) const;
  /// r += d(add_internal + add_inertia)/dp where the state changes along a direction of the body.
  void add_variation(const BodyState<G>& s, const StateDirection& d, const Vector& gravity,
                     const Vector& dgravity, const Variation& by, double* r) const;

  /// Makes it the derivative by a scale of the law.
  void scale(double stiffness, double mass);

 private:
  Points local(const G* H) const;                                  ///< y
  Eigen::MatrixXd by_unknowns(const G* H, const Points& y) const;  ///< dy
  static Eigen::MatrixXd rigid_motions(const Points& places);
  int size() const { return dim + sd * static_cast<int>(nodes_.size()); }

  int port_;
  std::vector<int> nodes_;
  Points places_;
  Eigen::MatrixXd Q_;
  double stiffness_, mass_, inertia_;
};

extern template class AveragedPort<SE2>;
extern template class AveragedPort<SE3>;

}  // namespace liesl
