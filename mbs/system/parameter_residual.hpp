#pragma once
/// @file
/// Derivative of the equations of motion by a parameter, at constant state:
///   r_p = dr/dp,  Phi_p = dPhi/dp  of  r = M vdot + g_gyr + g_int - g_ext + B^T lambda,
///   Phi = row(H) - target(t).

#include "mbs/model/parameter.hpp"
#include "mbs/system/nearby_models.hpp"

namespace liesl {

/// One parameter on a model: what its derivative needs, made once; `add` allocates
/// nothing but by nearby mechanisms. Not for several threads at once: it computes in workspaces of
/// its own.
///
/// Bodies give dr/dp by `Body::derivative`, the same kernels with the derivative of the law. Force
/// laws give B^T df/dp with f = k (q - q_0) + c dq/dt - F(t): df/dk = q - q_0, df/dc = dq/dt,
/// df/dq_0 = -k, -F(t) for its factor, -dF/dp. A load gives the load itself for its factor, or that
/// of its components; a drive -target(t), or -d(target)/dp; the weight alpha of a penalty, whose
/// row is Phi - lambda/alpha, lambda/alpha^2. Nearby mechanisms give differences of the whole
/// residual; of bodies with a derivative by their shape (`Body::by_shape`) that is taken.
template <FrameGroup G>
class ParameterResidual {
 public:
  static constexpr int dim = G::dim;

  /// @param mechanism that the model is of, needed here only  @param model outlives this
  /// @throws std::invalid_argument with all that is wrong with the parameter
  ParameterResidual(const Mechanism& mechanism, const Model<G>& model, const Parameter& parameter);

  /// r_p += dr/dp [size of the model, N and N m per unit of p, nodal local frames] and
  /// phi_p += dPhi/dp [constraints] at a state. `previous`: coupling rows at the last accepted
  /// state, as in Equations::evaluate.
  void add(const State<G>& s, const Eigen::VectorXd& previous, const LoadLevel& level,
           Eigen::VectorXd& r_p, Eigen::VectorXd& phi_p) const;
  /// phi_p += the time derivative of dPhi/dp of order 0, 1 or 2 at t, constant state: only targets
  /// of drives depend on parameters, Phi_p = -d(target)/dp. By the duration at constant t/duration,
  /// where the derivative of order k of f(t/T) has dk/dT = -k/T of itself.
  void add_target(double t, int order, Eigen::VectorXd& phi_p) const;

  /// d(body)/dp, null if the body does not depend on p: its `mass`, `energy`, `section_force` are
  /// the derivatives of those of the body.
  const Body<G>* body(int body) const { return bodies_[body].get(); }
  const Parameter& parameter() const { return parameter_; }
  /// d(force)/dp of the law of a row at constant q and dq/dt; 0 if it does not depend on p.
  double force_derivative(const CouplingRow<G>& row, double q, double rate,
                          const LoadLevel& level) const;
  /// dh/dp / h, see StepDerivative.
  double step() const { return step_; }
  /// Where the parameter is known by nearby mechanisms, else null.
  const NearbyModels<G>* nearby() const { return nearby_.get(); }
  /// Nodes of the model that dr/dp acts on, growing; zero at all others.
  const std::vector<int>& nodes() const { return nodes_; }

 private:
  /// A row of a coupling whose law or target depends on p.
  struct RowDerivative {
    const Coupling<G>* coupling;
    const CouplingRow<G>* equation;
    int row;                         ///< in the coupling
    ForceDerivative law;             ///< of a force
    double target = 0;               ///< factor of a drive
    FunctionDerivative motion = {};  ///< of a drive
    double stretched = 0;            ///< dh/dp / h of a drive that follows t/duration
  };
  struct LoadChange {
    const Load<G>* load;
    double factor;  ///< of its scale
    FunctionDerivative scale;
    mutable Load<G> components;  ///< the load with the derivative of its wrench
    bool of_components;
  };

  std::string add_part(const Mechanism& mechanism, const BeamDerivative& part);
  std::string add_part(const Mechanism& mechanism, const RigidDerivative& part);
  std::string add_part(const Mechanism& mechanism, const SolidDerivative& part);
  std::string add_part(const Mechanism& mechanism, const SolidScale& part);
  std::string add_part(const Mechanism& mechanism, const ForceDerivative& part);
  std::string add_part(const Mechanism& mechanism, const LoadDerivative& part);
  std::string add_part(const Mechanism& mechanism, const DriveDerivative& part);
  std::string add_part(const Mechanism& mechanism, const PenaltyDerivative& part);
  std::string add_part(const Mechanism& mechanism, const StepDerivative& part);
  std::string add_part(const Mechanism& mechanism, const NearbyMechanisms& part);
  std::string set_body(int body, const LawDerivative<G>& law);
  void add_nodes(int first, int count);
  void add_nodes_of(int body);
  template <class Matches>
  void add_rows(RowDerivative part, Matches matches);
  /// r_p += what a load is changed by `change` of its wrench at `wrench`.
  void add_load(const LoadChange& l, const typename G::Tangent& wrench,
                const typename G::Tangent& change, const State<G>& s, Eigen::VectorXd& r_p) const;
  void add_force(const RowDerivative& row, const State<G>& s, const Eigen::VectorXd& previous,
                 const LoadLevel& level, Eigen::VectorXd& r_p) const;

  const Model<G>& model_;
  Parameter parameter_;
  std::vector<int> nodes_;
  std::vector<std::unique_ptr<Body<G>>> bodies_;
  std::vector<std::unique_ptr<BodyWorkspace>> work_;  ///< of bodies_
  std::vector<RowDerivative> rows_;
  std::vector<LoadChange> loads_;
  std::unique_ptr<NearbyModels<G>> nearby_;
  Eigen::VectorXd compliance_;  ///< -d(1/alpha)/dp by multiplier; empty: weights do not change
  double step_ = 0;
  mutable Eigen::VectorXd turned_;  ///< of a spread load
};

extern template class ParameterResidual<SE2>;
extern template class ParameterResidual<SE3>;

}  // namespace liesl
