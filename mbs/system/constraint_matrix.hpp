#pragma once
/// @file
/// Gradients of all constraints at a configuration, dense over the coupled nodes.

#include <optional>

#include "mbs/system/equations.hpp"

namespace liesl {

/// Columns: translations, and rotations times the mechanism's length, so that both compare (m).
template <FrameGroup G>
class ConstraintMatrix {
 public:
  struct Row {
    int coupling, equation;
    bool drive;  ///< prescribes a coordinate of a joint
  };

  explicit ConstraintMatrix(const Model<G>& model);

  const std::vector<Row>& rows() const { return rows_; }
  /// [rows x columns] at the frames of `s`.
  const Eigen::MatrixXd& evaluate(const State<G>& s);

  /// Another configuration where all joints hold and drives are let go, kPerturbation of the
  /// mechanism's length from `s` along a motion that the joints leave there (`direction` = 0, 1,
  /// ... picks one of them), then Levenberg-Marquardt. Empty if nothing moves, or nothing is found.
  std::optional<State<G>> perturbed(const State<G>& s, int direction);

 private:
  void move(State<G>& s, const Eigen::VectorXd& step) const;
  void add_gradient(int coupling, int equation,
                    Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> out);

  const Model<G>& model_;
  Equations<G> equations_;
  std::vector<Row> rows_;
  std::vector<int> nodes_;   ///< coupled nodes, by block of columns
  std::vector<int> column_;  ///< by node
  Eigen::MatrixXd J_;
  Eigen::VectorXd phi_;
};

extern template class ConstraintMatrix<SE2>;
extern template class ConstraintMatrix<SE3>;

}  // namespace liesl
