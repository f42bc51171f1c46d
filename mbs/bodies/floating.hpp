#pragma once
/// @file
/// Floating frame of reference: a flexible body that is linear in a frame that moves with it,
/// reduced to the frames it is held at and to modes (Craig, Bampton 1968; Shabana 2013,
/// "Dynamics of Multibody Systems", chapter 5).
///
/// The floating frame is the body's first node, H_0. The further interface frames H_i are unknowns
/// of their own, so that couplings hold on to them as to any node:
///   u_i = log(X_i^-1 H_0^-1 H_i),  X_k = H_0^-1 H_k at reference,  e = [u_i; eta],  u = Psi e,
/// Psi = [static shapes of unit u_i, modes with all interfaces held], V = e^T K_e e / 2 with K_e
/// constant. What moves with [v_0; edot] and how heavy it is, is up to the kind of body:
/// `ModalBody` over the nodes of a beam, `SolidBody` over a mesh.

#include <memory>

#include "liegroup/se2.hpp"
#include "liegroup/se3.hpp"
#include "mbs/bodies/body.hpp"

namespace liesl {

template <FrameGroup G>
class FloatingBody : public Body<G> {
 public:
  using Body<G>::dim;
  using typename Body<G>::Tangent;
  using typename Body<G>::Vector;
  using typename Body<G>::Matrices;

  NodeKind kind(int node) const override { return kind_[node]; }
  std::unique_ptr<BodyWorkspace> make_workspace() const override;
  int modes() const { return static_cast<int>(omega2_.size()); }
  /// Squares of the circular frequencies of the internal modes, 1/s^2.
  const Eigen::VectorXd& omega2() const { return omega2_; }
  /// Constant stiffness of e.
  const Eigen::MatrixXd& reduced_stiffness() const { return K_e_; }
  int padding() const override { return unused_; }

  void add_inertia(const BodyState<G>& s, const Vector& gravity, double* r,
                   ForceScale& scale) const override;
  void add_internal(const BodyState<G>& s, double* r, ForceScale& scale) const override;
  /// The mass at this state matters where the frame is held by a hinge: a turn of the frame is then
  /// nearly a motion of the modes, and the mass at reference nearly singular.
  void exact_tangent(const BodyState<G>& s, const Vector& gravity, TangentWeights w,
                     const Tangent* stress, Matrices& A) const override;
  void exact_tangents(const BodyState<G>& s, const Vector& gravity, const Tangent* stress,
                      Matrices& K, Matrices& C, Matrices& M) const override;

 protected:
  /// Coordinates of the reduced body and their rates at one state.
  struct Motion {
    Eigen::VectorXd e, rate, acceleration;          ///< [u_i; eta]
    std::vector<G, Eigen::aligned_allocator<G>> Y;  ///< H_0^-1 H_i
  };

  struct Workspace : BodyWorkspace {
    Motion motion;
    Eigen::VectorXd q;  ///< forces conjugate to e
  };
  /// Sizes the part of a workspace that all floating bodies have.
  void set_up(Workspace& work) const;

  /// Nodes without a kind yet: `reduce_to` says.
  FloatingBody(std::string body_name, std::vector<G> nodes_at_rest);
  /// Fixes the unknowns: kinds of the nodes, of which the first is a frame; K_e and the squares of
  /// the frequencies. e is padded with amplitudes that never move up to whole nodes.
  void reduce_to(std::vector<NodeKind> kind, const Eigen::MatrixXd& K_e, Eigen::VectorXd omega2);
  /// Constant matrices, from `inertia_matrix`: the last thing a constructor does.
  void set_constant_matrices();
  /// Makes this copy of a body the derivative of it: K_e is replaced by dK_e/dp [padded or not],
  /// and padding has no stiffness or mass. `set_constant_matrices` comes next.
  /// @param massless of a law of stiffness alone: there is no inertia to evaluate
  void become_derivative(const Eigen::MatrixXd& dK_e, bool massless);

  /// Inertia force conjugate to [v_0; edot]: f_0 on the frame, q on e. a_0 is the rate of v_0 less
  /// gravity in the axes of the frame.
  virtual void inertia_force(const Motion& m, const Tangent& v_0, const Tangent& a_0, Tangent& f_0,
                             Eigen::VectorXd& q, ForceScale& scale, Workspace& work) const = 0;
  /// The mass matrix of [v_0; edot], dim + n; columns of padding are zero.
  virtual Eigen::MatrixXd inertia_matrix(const Motion& m) const = 0;
  /// Derivatives of [f_0; q], dim + n rows each: `inertia_matrix`, by [v_0; edot] and by e; and q.
  struct InertiaTangents {
    Eigen::MatrixXd mass, by_rates, by_e;
    Eigen::VectorXd q;
  };
  virtual InertiaTangents inertia_tangents(const Motion& m, const Tangent& v_0,
                                           const Tangent& a_0) const = 0;

  /// Without `rates` of H and w alone.
  void measure(const BodyState<G>& s, bool rates, Motion& m) const;
  /// The motion at reference, at rest.
  Motion at_reference() const;
  /// E: de = E [h_0; h_i; deta].
  Eigen::MatrixXd increments(const Motion& m) const;
  /// Gradient c_e, c_rate with respect to e and edot added to that with respect to the unknowns.
  void add_unknowns(const Motion& m, const BodyState<G>& s, const Eigen::VectorXd& c_e,
                    const Eigen::VectorXd& c_rate, double* h, double* v) const;
  /// The same of a gradient with respect to d^2 e/dt^2.
  void add_unknowns_of_acceleration(const Motion& m, const BodyState<G>& s,
                                    const Eigen::VectorXd& c, double* h, double* v,
                                    double* vdot) const;
  int interface_size() const { return dim * static_cast<int>(interfaces_.size()); }
  int reduced_size() const { return static_cast<int>(K_e_.cols()); }  ///< n of e, with padding

  std::vector<G, Eigen::aligned_allocator<G>> X_;
  std::vector<int> interfaces_, slots_;  ///< nodes: without node 0; that hold amplitudes

 private:
  /// Calls f with the workspace of a state, or with one of its own.
  template <class F>
  void in_workspace(const BodyState<G>& s, const F& f) const {
    const auto own = s.work ? nullptr : this->make_workspace();
    f(static_cast<Workspace&>(s.work ? *s.work : *own));
  }
  void set_matrix(const Motion& m, double mass, double stiffness, Matrices& A) const;
  /// The rows of `increments` of the interfaces, columns [h_0; h_i]: the others are zero.
  Eigen::MatrixXd interface_increments(const Motion& m) const;
  /// A = [d f_0; 0] + E^T d q, d [f_0; q] = by_e E + by_frames, from by_e in its last n columns.
  /// @param by_frames dim + n rows, columns [h_0; h_i]
  void add_frames(const Motion& m, const Eigen::MatrixXd& by_frames, Matrices& A) const;
  /// Derivatives of edot and eddot by the frames, and of eddot by v, at constant v and vdot, the
  /// columns and rows that are not zero: by h_0 and h_i, of the interfaces. Those of e are
  /// `increments`, of edot by v and of eddot by vdot as well.
  struct Kinematics {
    Eigen::MatrixXd rate, acceleration, acceleration_by_v;
  };
  Kinematics kinematics(const BodyState<G>& s, const Motion& m) const;
  /// What the exact tangents of one state are made of.
  struct Linearisation {
    Motion motion;
    InertiaTangents inertia;
    Kinematics by_frames;
  };
  Linearisation linearise(const BodyState<G>& s, const Vector& gravity) const;
  void set_exact(const BodyState<G>& s, const Vector& gravity, const Linearisation& at,
                 TangentWeights w, Matrices& A) const;
  /// A += weight times the derivative of the shares of forces q on frames and interfaces at
  /// constant q.
  void add_turning(const Motion& m, const Eigen::VectorXd& q, double weight, Matrices& A) const;
  /// r += forces q conjugate to e, on the interfaces, the frame and the amplitudes.
  void add_conjugate(const Motion& m, const Eigen::VectorXd& q, double* r, ForceScale& scale) const;

  std::vector<NodeKind> kind_;
  Eigen::MatrixXd K_e_;
  int unused_ = 0;                          ///< amplitudes of the last slot
  double unused_weight_ = 1;                ///< their mass and stiffness
  bool massless_ = false, elastic_ = true;  ///< of a derivative: which of its forces there are
  Eigen::VectorXd omega2_;
};

extern template class FloatingBody<SE2>;
extern template class FloatingBody<SE3>;

}  // namespace liesl
