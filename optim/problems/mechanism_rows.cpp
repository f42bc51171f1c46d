#include "optim/problems/mechanism_rows.hpp"

namespace liesl {
namespace {

std::vector<int> records_of(const MotionRows& rows) {
  std::vector<int> out;
  for (const RowImage& image : rows.images()) out.push_back(image.record);
  return out;
}

}  // namespace

template <FrameGroup G>
MechanismRows<G>::MechanismRows(std::unique_ptr<MotionRows> rows,
                                const DesignSimulator<G>& simulator, const DesignRun<G>& run,
                                const StudySpec& study)
    : CaselessProblem(rows->variables()),
      rows_(std::move(rows)),
      statics_(simulator, run, records_of(*rows_)) {
  constraints_ = rows_->constraints();
  const std::vector<LimitedResponse> responses = rows_->responses();
  for (const RowImage& image : rows_->images()) {
    const LimitedResponse& r = responses[static_cast<std::size_t>(image.response)];
    of_.push_back({r.response, image.record,
                   study.constraints[static_cast<std::size_t>(r.constraint)].limit});
  }
}

template <FrameGroup G>
void MechanismRows<G>::values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
  f = 0;
  for (std::size_t i = 0; i < of_.size(); ++i)
    g[static_cast<Eigen::Index>(i)] =
        statics_.value(of_[i].response, of_[i].record, x, nullptr) / of_[i].limit - 1;
}

template <FrameGroup G>
void MechanismRows<G>::gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) {
  df.setZero();
  Eigen::VectorXd slope;
  for (std::size_t i = 0; i < of_.size(); ++i) {
    statics_.value(of_[i].response, of_[i].record, x, &slope);
    dg.row(static_cast<Eigen::Index>(i)) = slope.transpose() / of_[i].limit;
  }
}

template class MechanismRows<SE2>;
template class MechanismRows<SE3>;

}  // namespace liesl
