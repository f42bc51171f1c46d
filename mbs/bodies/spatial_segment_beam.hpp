#pragma once
/// @file
/// A beam in space as a chain of straight segments without shear and torsion: `SegmentBeam` with
/// points and end frames in space. With d_e = x_{e+1} - x_e, l_e = |d_e|, t_e = d_e/l_e, and
/// t_{-1}, t_n the x axes of the end frames,
///   V = sum_e L_e W(l_e/L_e) + sum_i c_i phi_i^2/2,   cos phi_i = z_i = t_{i-1} . t_i,
/// W and c_i as in the plane. With q_i = (phi_i/sin phi_i) t_{i-1} x t_i the moments are m_i = c_i
/// q_i, and dV = sum N dl + sum m_i . (dw_i - dw_{i-1}), dw_e = t_e x dt_e: the force of segment e
/// on node e + 1 is N t + (m_e - m_{e+1}) x t/l, the moments on the end frames are -m_0 and m_n. In
/// a plane that is the planar chain.
///
/// A cross-section has no turn about the axis. So both bending stiffnesses are equal, the beam is
/// straight at rest, and no moment is about the axis: an end frame spins freely, with the inertia
/// of half a segment, rho I L/2, polar about x. In static tangents a small stiffness holds it where
/// it is (`exact_tangent`). Nor is there material damping: what is objective and known by points is
/// the angle phi_i alone, and its rate has no limit at phi_i = 0, where a straight beam is.
///
/// Nodes between the ends are positions (NodeKind::Position). Their axes come from the first frame
/// by the smallest rotations along the chain, onto each segment and, half way between two, onto the
/// bisector of their directions, x of the node: without twist (R. L. Bishop, Amer. Math. Monthly 82
/// (1975) 246-251). In them stiffness and mass are those at rest, however far the beam has turned.
/// The axes of a segment, y and z of section forces and strains, are those of its first node,
/// turned onto it likewise.

#include "mbs/bodies/spatial_segment_parts.hpp"

namespace liesl {

class SpatialSegmentBeam final : public Body<SE3> {
 public:
  /// @param nodes_at_rest n + 1, n >= 1  @param sections one a segment, stiffness over [eps_x,
  /// gamma_y, gamma_z, kappa_x, kappa_y, kappa_z]; those of shear and torsion are not used
  /// @param damping 0
  /// @throws std::invalid_argument if a section couples N and M, has its mass off the axis or two
  /// bending stiffnesses, if the beam is curved or twisted at rest, or damped
  SpatialSegmentBeam(std::string body_name, std::vector<SE3> nodes_at_rest,
                     const std::vector<ElementSection<SE3>>& sections, double damping,
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
  void turn_axes(SE3* H) const override;
  /// The last frame about its x axis, to where the chain carries the axes of the first.
  void settle_spin(SE3* H) const override;
  /// By both ends, linear in between.
  void follow_frames(const SE3* start, SE3* H) const override;
  /// Rates of the angular velocities of nodes between the ends are left at 0.
  void complete(SE3* H, double* v, double* vdot, const double* w) const override;
  std::optional<ShapeFault> fault(const SE3* H) const override;

  void add_inertia(const BodyState<SE3>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<SE3>& s, double* r, ForceScale& scale) const override;
  /// Of statics (no weight of mass and damping) with 1e-4 c about the axis at both ends, which no
  /// force answers to: what turns an end there alone is not held in place by it.
  /// @param stress of `extrapolate_stress`
  void exact_tangent(const BodyState<SE3>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  void exact_tangents(const BodyState<SE3>& s, const Vector& gravity, const Tangent* stress,
                      Matrices& K, Matrices& C, Matrices& M) const override;
  /// Half of a load per length at either node; a moment per length has no share.
  Matrices load_distribution() const override;
  /// [l/L - 1; 0; 0; 0; mean of q/h at its nodes], h the half segments there, in the axes of the
  /// segment.
  Tangent strain(const BodyState<SE3>& s, int e) const override;
  /// Middle: [N; V_y; V_z; 0; mean of the moments], in the axes of the segment.
  Tangent section_force(const BodyState<SE3>& s, int e, ElementPlace at) const override;
  /// By node [N of the segment that begins there; 0; 0; moment], inertial: tangents about them keep
  /// Newton's method on its way where positions that move straight stretch segments that turn.
  int stresses() const override { return nodes(); }
  void extrapolate_stress(const BodyState<SE3>& s, const double* delta,
                          Tangent* stress) const override;
  BodyEnergy energy(const BodyState<SE3>& s, const Vector& gravity) const override;
  double total_mass() const override { return m_.sum(); }
  double axial_stiffness() const override { return k_.maxCoeff(); }
  /// @throws std::invalid_argument also if the two bending stiffnesses would not stay equal
  std::unique_ptr<Body<SE3>> derivative(const LawDerivative<SE3>& law) const override;
  void add_section_force_gradient(const BodyState<SE3>& s, int e, ElementPlace at, const Tangent& f,
                                  double* h) const override;
  void add_energy_gradient(const BodyState<SE3>& s, const Vector& gravity, const BodyEnergy& weight,
                           double* h, double* v) const override;
  void to_unknowns(const BodyState<SE3>& s, double* h, double* v) const override;

 private:
  void require_straight() const;
  void set_sections(const std::vector<ElementSection<SE3>>& sections);
  void set_matrices();
  void add_mass(const SE3* H, double weight, Matrices& A) const;
  void add_stiffness(const SE3* H, const Tangent* stress, Matrices& A) const;
  void add_rates(const BodyState<SE3>& s, double weight, Matrices& A) const;
  void add_turning(const BodyState<SE3>& s, const Vector& gravity, const Tangent* stress,
                   Matrices& A) const;
  void add_tangent(const BodyState<SE3>& s, const Vector& gravity, TangentWeights w,
                   const Tangent* stress, Matrices& A) const;
  double nodal_mass(int i, int j) const;  ///< between equal or neighbouring nodes, kg

  SpatialSegment segment(const SE3* H, int e) const;
  Misalignment bend(const SE3* H, int i) const;
  Vec3 moment(const SE3* H, int i) const;
  /// Normal force and the moments at both nodes of a segment, inertial, of the state or of
  /// `extrapolate_stress`.
  struct SegmentForces {
    double N;
    Vec3 first, last;
  };
  SegmentForces forces(const SE3* H, int e, const Tangent* stress) const;
  /// Of segment e on node e + 1, inertial.
  Vec3 force(const SE3* H, int e, const Tangent* stress = nullptr) const;
  Mat3 axes_of(const SE3* H, int e) const;
  double axial(int e, double l) const;
  double axial_slope(int e, double l) const;
  NodalGradient turn_gradient(const SE3* H, int i) const;
  NodalGradient moment_gradient(const SE3* H, int i, const Vec3* about = nullptr) const;
  NodalGradient force_gradient(const SE3* H, int e, const Tangent* stress = nullptr) const;

  AxialPotential potential_;
  SegmentRange acting_;  ///< all, but of a derivative
  bool lumped_;
  Eigen::VectorXd L_, k_, EI_, m_;    ///< by segment: m, N/m, N m^2, kg
  Eigen::VectorXd c_, half_;          ///< by node: N m, half segments beside it, m
  Eigen::VectorXd dead_mass_, dead_;  ///< by node: in place of the rotations of positions
  Eigen::Vector2d spin_;              ///< that holds the ends about their x axes, N m
  Mat3 J_[2];                         ///< of the end sections, kg m^2
};

}  // namespace liesl
