#pragma once
/// @file
/// Residual of the equations of motion at one state, and the gradients of the couplings:
///   r = M vdot + g_gyr + g_int - g_ext + B^T lambda,   Phi = row(H) - target(t).
/// By penalties lambda is an unknown all the same, so that nothing is as stiff as they are: with
/// compliances C = 1/alpha the rows are
///   Phi + tau dPhi/dt - C (lambda - lambda*) = 0,
/// which eliminated is M vdot + B^T alpha Phi = Q (Garcia Orden, Arribas, Dopico, Gabaldon 2024,
/// eq. 3).

#include "mbs/system/model.hpp"

namespace liesl {

/// What drives and loads are at: functions of time at `t`; gravity, loads and forces of actuators
/// times `factor`.
struct LoadLevel {
  double t = 0;
  double factor = 1;  ///< 1 in dynamics; the load factor in statics
};

/// Workspace of one evaluation. Sized once; an evaluation allocates nothing.
template <FrameGroup G>
class Equations {
 public:
  static constexpr int dim = G::dim;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 2 * dim, Eigen::RowMajor>;

  explicit Equations(const Model<G>& model);

  /// Fills r, phi, B, the scales. `previous`: coupling rows at the last accepted state (angles are
  /// continued from there). `stress`: section forces of each body, see BodyState; null = exact.
  using SectionForces = std::vector<typename Body<G>::Stresses>;
  void evaluate(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
                const SectionForces* stress = nullptr);

  /// What linearisations take from it and no more: phi, B and the forces of couplings; r has no
  /// forces of bodies and loads.
  void evaluate_couplings(const State<G>& s, const Eigen::VectorXd& previous,
                          const LoadLevel& level);

  /// Leaves the forces of a body out of r from now on; its loads and joints stay.
  void leave_out(int body) { left_out_[static_cast<std::size_t>(body)] = true; }

  /// Values of all coupling rows at a state, into `rows`.
  void observe(const State<G>& s, const Eigen::VectorXd& previous, Eigen::VectorXd& rows) const;

  /// Power of the loads at a state (dynamics), W. Overwrites r, and adds the loads to the
  /// scales: evaluate() comes next.
  double load_power(const State<G>& s);

  /// out -= factor times the wrench of a load, in the nodal local frames.
  static void add_load(const Model<G>& model, const Load<G>& load, double factor, const State<G>& s,
                       Eigen::VectorXd& out, ForceScale& scale);

  /// Norm of r with moments divided by the size of the mechanism, N; of one body's part of r.
  double residual() const;
  double residual(int body) const;
  /// The same norm of the parts that r is the sum of, plus what round-off alone makes, N.
  double scale() const { return scale_; }
  double scale(int body) const { return scales_[body].norm(model.length); }
  double round_off() const { return round_off_; }
  double constraint_residual() const {
    return phi.size() ? phi.template lpNorm<Eigen::Infinity>() : 0;
  }
  /// Largest |Phi|, m or rad.
  double opening() const { return gap.size() ? gap.template lpNorm<Eigen::Infinity>() : 0; }

  const Model<G>& model;
  Eigen::VectorXd r;    ///< size of the model
  Eigen::VectorXd phi;  ///< the rows of the constraints: Phi, by penalties with the other terms
  Eigen::VectorXd gap;  ///< Phi
  Eigen::VectorXd compliance;  ///< C of the file's head; 0 where Phi = 0 is asked for
  Eigen::VectorXd estimate;    ///< lambda*
  double damping = 0;          ///< tau, s
  struct CouplingData {
    Rows B;                 ///< acting rows x [node of a; node of b]
    Eigen::VectorXd force;  ///< of the acting rows that are not constraints, else 0
    Eigen::VectorXd rate;   ///< time derivative of the acting rows
    Eigen::VectorXd slope;  ///< of the springs of the acting rows, df/dq; of constraints 0
  };
  std::vector<CouplingData> couplings;

  /// d(rows)/dt = target rate of each constraint at t, and second derivative minus (dB/dt) v.
  void velocity_target(double t, Eigen::VectorXd& rate) const;
  void acceleration_target(const State<G>& s, double t, Eigen::VectorXd& rate) const;

 private:
  void add_bodies(const State<G>& s, const LoadLevel& level, const SectionForces* stress);
  void add_loads(const State<G>& s, const LoadLevel& level);
  void clear();
  void add_couplings(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level);
  void add_coupling(const Coupling<G>& c, CouplingData& data, const State<G>& s,
                    const Eigen::VectorXd& previous, const LoadLevel& level);
  void add_compliance(const State<G>& s, double t);
  double norm_of(int first, int nodes) const;
  std::vector<ForceScale> scales_;                    ///< by body
  std::vector<bool> left_out_;                        ///< by body
  std::vector<std::unique_ptr<BodyWorkspace>> work_;  ///< by body
  double scale_ = 0, round_off_ = 0;
};

/// Value of a time function of a load.
inline double load_value(const TimeFunction& f, const LoadLevel& level) {
  return level.factor * f(level.t);
}

extern template class Equations<SE2>;
extern template class Equations<SE3>;

}  // namespace liesl
