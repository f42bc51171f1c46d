#pragma once
/// @file
/// A beam in the plane as a chain of straight segments without shear and torsion (J. C. Garcia
/// Orden, A simple shear and torsion-free beam model for multibody dynamics, J. Comput. Nonlinear
/// Dyn. 12 (2017)). Its nodes are points x_0 ... x_n; with d_e = x_{e+1} - x_e, l_e = |d_e|, psi_e
/// the direction of segment e and theta_0, theta_n those of the end sections,
///   V = sum_e L_e W(l_e/L_e) + sum_i c_i (phi_i - phi_i0)^2 / 2,
///   phi_i = psi_i - psi_{i-1}, phi_0 = psi_0 - theta_0, phi_n = theta_n - psi_{n-1},
///   W = EA (lambda - 1)^2 / 2, or EA/6 (lambda^2 + 2/lambda - 3): neo-Hookean, incompressible;
///   1/c_i = sum of L_e/(2 EI_e) over the segments at node i, each of which bends by its half.
/// The end sections are frames: what they hold on to, clamps and fixed joints among them, bends the
/// half segment beside them, which keeps second order there. Without a moment theta_0 = psi_0: the
/// direction of the end segment. Their inertia is that of half a segment, rho I L/2; inside it is
/// left out (Euler-Bernoulli).
///
/// Nodes between the ends are positions (NodeKind::Position) whose axes bisect the segments: in
/// them stiffness and mass are those at rest, however far the beam has turned.

#include "liegroup/se2.hpp"
#include "mbs/bodies/body.hpp"
#include "mbs/bodies/segment_law.hpp"
#include "mbs/model/mechanism.hpp"

namespace liesl {

class SegmentBeam final : public Body<SE2> {
 public:
  /// @param nodes_at_rest n + 1, n >= 1  @param sections one a segment, [N, V, M] over [eps, gamma,
  /// kappa]; the shear stiffness is not used  @param damping stiffness-proportional, s
  /// @throws std::invalid_argument if a section couples N and M or its mass is off the axis
  SegmentBeam(std::string body_name, std::vector<SE2> nodes_at_rest,
              const std::vector<ElementSection<SE2>>& sections, double damping,
              const SegmentSpec& spec);

  NodeKind kind(int node) const override {
    return node == 0 || node + 1 == nodes() ? NodeKind::Frame : NodeKind::Position;
  }
  int elements() const override { return nodes() - 1; }
  /// Of a segment and those beside it, which its springs act on.
  std::pair<int, int> nodes_of(int e) const override {
    const auto [first, end] = SegmentRange{e, e + 1}.with_neighbours(elements());
    return {first, end - first + 1};
  }
  double damping() const override { return damping_; }
  void turn_axes(SE2* H) const override;
  /// By both ends, linear in between.
  void follow_frames(const SE2* start, SE2* H) const override;
  void complete(SE2* H, double* v, double* vdot, const double* w) const override;

  void add_inertia(const BodyState<SE2>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<SE2>& s, double* r, ForceScale& scale) const override;
  /// @param stress [N, V, M] in the middle of each segment
  void exact_tangent(const BodyState<SE2>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  /// Half of a load per length at either node; a moment per length has no share.
  Matrices load_distribution() const override;
  /// [l/L - 1; 0; mean of phi/h at its nodes], h the half segments there.
  Tangent strain(const BodyState<SE2>& s, int e) const override;
  /// Middle: [N; (M_e - M_{e+1})/l; mean of the moments], in the axes of the segment.
  Tangent section_force(const BodyState<SE2>& s, int e, ElementPlace at) const override;
  void extrapolate_stress(const BodyState<SE2>& s, const double* delta,
                          Tangent* stress) const override;
  BodyEnergy energy(const BodyState<SE2>& s, const Vector& gravity) const override;
  double dissipation(const BodyState<SE2>& s) const override;
  double total_mass() const override { return m_.sum(); }
  double axial_stiffness() const override { return k_.maxCoeff(); }
  std::unique_ptr<Body<SE2>> derivative(const LawDerivative<SE2>& law) const override;
  void add_section_force_gradient(const BodyState<SE2>& s, int e, ElementPlace at, const Tangent& f,
                                  double* h) const override;
  void add_energy_gradient(const BodyState<SE2>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;
  void to_unknowns(const BodyState<SE2>& s, double* h, double* v) const override;

 private:
  using Matrix2 = Eigen::Matrix2d;
  struct Segment;
  struct Gradient;

  void set_sections(const std::vector<ElementSection<SE2>>& sections);
  void set_matrices();
  double mass_between(int i, int j) const;
  void add_mass(const SE2* H, double weight, Matrices& A) const;
  void add_material(const SE2* H, double weight, bool tangent, Matrices& A) const;
  void add_stiffness(const BodyState<SE2>& s, const Tangent* stress, Matrices& A) const;
  void add_damping_stiffness(const BodyState<SE2>& s, Matrices& A) const;
  void add_rates(const BodyState<SE2>& s, double weight, Matrices& A) const;
  void add_turning(const BodyState<SE2>& s, const Vector& gravity, const Tangent* stress,
                   Matrices& A) const;

  Segment segment(const SE2* H, int e) const;
  double angle(const SE2* H, int i) const;
  double moment(const SE2* H, int i) const { return c_[i] * (angle(H, i) - phi0_[i]); }
  double axial(int e, double l) const;
  double axial_slope(int e, double l) const;
  /// Gradients by the increments of nodes: of l_e, of phi_i, and of their rates, v held.
  Gradient length_gradient(const SE2* H, int e) const;
  Gradient angle_gradient(const SE2* H, int i) const;
  Gradient length_rate_gradient(const BodyState<SE2>& s, int e) const;
  Gradient angle_rate_gradient(const BodyState<SE2>& s, int i) const;
  Gradient direction_gradient(const SE2* H, int e) const;
  Gradient direction_rate_gradient(const BodyState<SE2>& s, int e) const;
  double length_rate(const BodyState<SE2>& s, int e) const;
  double direction_rate(const BodyState<SE2>& s, int e) const;
  double angle_rate(const BodyState<SE2>& s, int i) const;

  AxialPotential potential_;
  SegmentRange acting_;  ///< all, but of a derivative
  bool lumped_;
  double damping_;
  Eigen::VectorXd L_, k_, EI_, m_;      ///< by segment: m, N/m, N m^2, kg
  Eigen::VectorXd c_, phi0_, half_;     ///< by node: N m, rad, half segments beside it, m
  Eigen::VectorXd dead_mass_, dead_;    ///< by node: in place of the rotation of positions
  Eigen::Vector2d J_;                   ///< of the end sections, kg m^2
  std::vector<Matrix2> from_bisector_;  ///< by node: its axes at rest in those of the bisector
};

}  // namespace liesl
