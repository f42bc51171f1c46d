#include "mbs/levelset/placement.hpp"

#include <utility>

namespace liesl::levelset {
namespace {

using Eigen::Vector3d;

/// X = R^T (x - c): d phi/dx = R g, d phi/dc = -R g, and with delta X = X x (T delta w)
/// d phi/dw = T^T (g x X), where g = d phi/dX.
class Placed final : public LevelSet {
 public:
  Placed(std::vector<Parameter> own, LevelSetPtr shape)
      : at_{static_cast<int>(own.size()), {}}, shape_(std::move(shape)) {
    parameters_ = std::move(own);
    for (const Parameter& p : shape_->parameters()) parameters_.push_back(p);
    set(start().data());
  }

  using LevelSet::set;
  void set(const double* p) override {
    at_.set(p);
    shape_->set(p + at_.count);
  }

  double value(const Vector3d& x) const override { return shape_->value(at_.to_local(x)); }

  double evaluate(const Vector3d& x, Vector3d& dx, double* dp) const override {
    const Vector3d X = at_.to_local(x);
    Vector3d g;
    const double phi = shape_->evaluate(X, g, dp ? dp + at_.count : nullptr);
    dx = at_.R * g;
    if (dp) at_.put(-dx, g.cross(X), dp);
    return phi;
  }

  std::string error() const override { return shape_->error(); }

 private:
  Placement at_;
  LevelSetPtr shape_;
};

}  // namespace

Eigen::VectorXd LevelSet::start() const {
  Eigen::VectorXd p(size());
  for (int i = 0; i < size(); ++i) p[i] = parameters_[i].value;
  return p;
}

LevelSetPtr placed_in_plane(double x, double y, double angle, LevelSetPtr shape) {
  return std::make_unique<Placed>(Placement::in_plane(x, y, angle), std::move(shape));
}

LevelSetPtr placed(const Pose& pose, LevelSetPtr shape) {
  return std::make_unique<Placed>(Placement::in_space(pose), std::move(shape));
}

}  // namespace liesl::levelset
