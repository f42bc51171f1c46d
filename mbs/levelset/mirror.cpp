#include <utility>

#include "mbs/levelset/csg.hpp"
#include "mbs/levelset/placement.hpp"

namespace liesl::levelset {
namespace {

using Eigen::Vector3d;

Vector3d flipped(const Vector3d& a) { return {a[0], -a[1], a[2]}; }

/// The image of x is c + R D Z, Z = R^T (x - c), D = diag(1, -1, 1). With g = d phi/dx at the image
/// and G = R^T g: d phi/dx = R D G, d phi/dc = g - R D G, d phi/dw = T^T (D Z x G - Z x D G).
class Mirrored final : public LevelSet {
 public:
  Mirrored(Operand operand, const std::vector<Parameter>& plane)
      : at_{static_cast<int>(plane.size()), {}},
        label_(operand.label.empty() ? operand.name : operand.label),
        shape_(std::move(operand.shape)) {
    for (Parameter p : shape_->parameters()) {
      if (!operand.name.empty()) p.name = operand.name + "." + p.name;
      parameters_.push_back(std::move(p));
    }
    parameters_.insert(parameters_.end(), plane.begin(), plane.end());
    set(start().data());
  }

  using LevelSet::set;
  void set(const double* p) override {
    shape_->set(p);
    at_.set(p + shape_->size());
  }

  double value(const Vector3d& x) const override {
    return std::max(shape_->value(x), shape_->value(image(at_.to_local(x))));
  }

  double evaluate(const Vector3d& x, Vector3d& dx, double* dp) const override {
    const Vector3d Z = at_.to_local(x), y = image(Z);
    double* plane = dp ? dp + shape_->size() : nullptr;
    if (plane) std::fill_n(plane, at_.count, 0.0);
    if (shape_->value(x) >= shape_->value(y)) return shape_->evaluate(x, dx, dp);
    Vector3d g;
    const double phi = shape_->evaluate(y, g, dp);
    const Vector3d G = at_.R.transpose() * g;
    dx = at_.R * flipped(G);
    if (plane) at_.put(g - dx, flipped(Z).cross(G) - Z.cross(flipped(G)), plane);
    return phi;
  }

  std::string error() const override { return shape_->error(); }
  std::optional<Part> part(const std::string& path) const override {
    if (path == label_ && !path.empty()) return Part{shape_.get(), 0, 1};
    const std::string prefix = label_ + ".";
    return shape_->part(path.starts_with(prefix) ? path.substr(prefix.size()) : path);
  }

 private:
  Vector3d image(const Vector3d& Z) const { return at_.c + at_.R * flipped(Z); }

  Placement at_;
  std::string label_;
  LevelSetPtr shape_;
};

}  // namespace

LevelSetPtr mirrored_in_plane(double x, double y, double angle, Operand shape) {
  return std::make_unique<Mirrored>(std::move(shape), Placement::in_plane(x, y, angle));
}

LevelSetPtr mirrored(const Pose& plane, Operand shape) {
  return std::make_unique<Mirrored>(std::move(shape), Placement::in_space(plane));
}

}  // namespace liesl::levelset
