#pragma once
/// @file
/// What a study minimises besides mass, near a design: duration and effort of the drives.

#include "optim/problems/static_problem.hpp"

namespace liesl {

/// w_T T + w_e J of the motion at one design x_k: J = sum over responses of int v^2 dt.
struct ObjectiveModel {
  int duration = -1;  ///< variable T; -1: it stays, and does not count
  double weight_duration = 0, weight_effort = 0;
  double effort = 0;
  Eigen::VectorXd by_effort;  ///< dJ/dx
  Eigen::MatrixXd curvature;  ///< int (dv/dx) (dv/dx)^T dt
  double extremes = 0;        ///< of largest values and lowest frequencies: rows tell their change
};

/// minimise extremes + w_T T + w_e J without constraints, J that of responses to first order
/// (Gauss-Newton), which torques are in the values of the tables of drives:
///   J = (T/T_k) int (v + dv/dx . s)^2 dt = (T/T_k) (J_k + b . s + s . C s),
/// s = x - x_k, of the duration s = (T_k/2) (1 - (T_k/T)^2), exact for forces of inertia. J >= 0.
class ObjectiveProblem final : public CaselessProblem {
 public:
  ObjectiveProblem(ObjectiveModel model, const Eigen::VectorXd& x_k,
                   const std::vector<NlpVariable>& variables);

  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd&) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix&) override;
  void hessian(const Eigen::VectorXd& x, double sigma, const Eigen::VectorXd&,
               Eigen::MatrixXd& h) override;

 private:
  /// q = J_k + b . s + s . C s, its gradient by s, and what s and T/T_k are there.
  struct Effort {
    double q = 0, stretch = 1;
    Eigen::VectorXd by_s;
    double s_first = 1, s_second = 0;  ///< ds/dT, d2s/dT2
  };
  Effort effort(const Eigen::VectorXd& x) const;
  /// dq/dx
  Eigen::VectorXd slope(const Effort& e) const;

  const ObjectiveModel model_;
  const Eigen::VectorXd x_k_;
  Eigen::VectorXd b_;
};

}  // namespace liesl
