#include <algorithm>
#include <utility>

#include "liegroup/so3.hpp"
#include "mbs/levelset/level_set.hpp"

namespace liesl::levelset {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// X = R^T (x - c): d phi/dx = R g, d phi/dc = -R g, and with delta X = X x (T delta w)
/// d phi/dw = T^T (g x X), where g = d phi/dX.
class Placed final : public LevelSet {
 public:
  Placed(std::vector<Parameter> own, LevelSetPtr shape)
      : own_(static_cast<int>(own.size())), shape_(std::move(shape)) {
    parameters_ = std::move(own);
    for (const Parameter& p : shape_->parameters()) parameters_.push_back(p);
    set(start().data());
  }

  using LevelSet::set;
  void set(const double* p) override {
    if (own_ == 3) {
      c_ = {p[0], p[1], 0};
      w_ = {0, 0, p[2]};
    } else {
      c_ = {p[0], p[1], p[2]};
      w_ = {p[3], p[4], p[5]};
    }
    R_ = SO3::exp(w_).R;
    T_ = SO3::T(w_);
    shape_->set(p + own_);
  }

  double value(const Vector3d& x) const override {
    return shape_->value(R_.transpose() * (x - c_));
  }

  double evaluate(const Vector3d& x, Vector3d& dx, double* dp) const override {
    const Vector3d X = R_.transpose() * (x - c_);
    Vector3d g;
    const double phi = shape_->evaluate(X, g, dp ? dp + own_ : nullptr);
    dx = R_ * g;
    if (!dp) return phi;
    const Vector3d turn = T_.transpose() * g.cross(X);
    for (int i = 0; i < own_ / 3 + 1; ++i) dp[i] = -dx[i];  // 2 in the plane, 3 in space
    if (own_ == 3) {
      dp[2] = turn[2];
    } else {
      std::copy_n(turn.data(), 3, dp + 3);
    }
    return phi;
  }

  std::string flaw() const override { return shape_->flaw(); }

 private:
  int own_;
  LevelSetPtr shape_;
  Vector3d c_, w_;
  Matrix3d R_, T_;
};

}  // namespace

Eigen::VectorXd LevelSet::start() const {
  Eigen::VectorXd p(size());
  for (int i = 0; i < size(); ++i) p[i] = parameters_[i].value;
  return p;
}

LevelSetPtr placed_in_plane(double x, double y, double angle, LevelSetPtr shape) {
  return std::make_unique<Placed>(
      std::vector<Parameter>{{"x", x}, {"y", y}, {"angle", angle, "rad"}}, std::move(shape));
}

LevelSetPtr placed(const Pose& pose, LevelSetPtr shape) {
  const Vector3d &c = pose.position, &w = pose.rotation;
  return std::make_unique<Placed>(std::vector<Parameter>{{"x", c[0]},
                                                         {"y", c[1]},
                                                         {"z", c[2]},
                                                         {"rx", w[0], "rad"},
                                                         {"ry", w[1], "rad"},
                                                         {"rz", w[2], "rad"}},
                                  std::move(shape));
}

}  // namespace liesl::levelset
