#pragma once
/// @file
/// Limits on responses of a motion that no static problem tells: positions, velocities, joint
/// forces, energy, responses of several bodies; of all responses in the fully coupled method.

#include "optim/problems/case_screen.hpp"
#include "optim/problems/motion_gradients.hpp"

namespace liesl {

/// Rows v_rn/limit_r - 1 that keep the value of the analysed design whatever x is; a
/// CorrectedProblem gives them their slope. Retained: every
/// maximum over time above half of the largest (of hundreds of points the records near the largest,
/// case_screen.hpp), or what the treatment of the limit says (treatment.hpp). Neighbours of a
/// maximum, which `add_records` joins, bound the design before the maximum moves to them. Rows of
/// constraints with a weight are those of a term of the objective, the number of the constraint.
/// The objective is 0 without them.
class MotionRows final : public CaselessProblem {
 public:
  /// @param motion gradients that contain those of these rows
  /// @param first, count of their responses in `motion`  @param variables of the whole design
  MotionRows(const MotionGradients& motion, int first, int count, const StudySpec& study,
             const std::vector<NlpVariable>& variables);

  int load_cases() const override { return static_cast<int>(constraints_.size()); }
  std::vector<LimitedResponse> responses() const override { return responses_; }
  std::vector<RowImage> images() const override { return images_; }
  std::vector<ObjectiveTerm> objective_terms() const override;
  int add_records(const std::vector<std::set<int>>& records) override;
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  /// What rows are made of, by response.
  struct Series {
    std::string name;  ///< of the limit
    double limit = 0;
    bool joined = false;  ///< by neighbours of its maxima
    ObjectiveTerm term;
    std::vector<double> times, values;  ///< by record
  };
  void add_row(int response, int record);

  std::vector<Series> series_;
  std::vector<LimitedResponse> responses_;
  std::vector<RowImage> images_;
  std::vector<ObjectiveTerm> terms_;
  std::vector<double> g_;
};

/// A response that is the largest over several points, as one response a point: the inner nodes of
/// a deflection `everywhere`, the stress points of a beam; any other as it is.
std::vector<ResponseSpec> at_every_point(const ResponseSpec& response, const Mechanism& mechanism);

}  // namespace liesl
