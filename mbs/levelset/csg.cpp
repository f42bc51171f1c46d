#include "mbs/levelset/csg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mbs/levelset/features.hpp"

namespace liesl::levelset {
namespace {

using Eigen::Vector3d;

struct Blend {
  double phi = 0, da = 0, db = 0, dr = 0;
};

Blend intersection(double a, double b, double r) {
  const double least = std::min(a, b);
  if (least >= r || r <= 0) return {least, a <= b ? 1.0 : 0.0, a <= b ? 0.0 : 1.0, 0};
  const double u = std::max(r - a, 0.0), w = std::max(r - b, 0.0);
  const double length = std::hypot(u, w);  // > 0: one of a, b is below r
  return {r - length, u / length, w / length, 1 - (u + w) / length};
}

enum class Operation { Union, Intersection, Difference };

/// sign_0 * (fold of intersections of sign_i phi_i).
class Csg final : public LevelSet {
 public:
  Csg(Operation operation, std::vector<Operand> operands, std::optional<double> radius)
      : smooth_(radius.has_value()), radius_(radius.value_or(0)) {
    if (operands.empty()) throw std::invalid_argument("a Boolean operation needs an operand");
    outer_ = operation == Operation::Union ? -1 : 1;
    for (auto& [name, shape, label] : operands) {
      if (!shape) throw std::invalid_argument("operand '" + name + "' is empty");
      const bool first = shapes_.empty();
      sign_.push_back(operation == Operation::Intersection ||
                              (operation == Operation::Difference && first)
                          ? 1
                          : -1);
      for (Parameter p : shape->parameters()) {
        if (!name.empty()) p.name = name + "." + p.name;
        parameters_.push_back(std::move(p));
      }
      names_.push_back(name);
      labels_.push_back(label.empty() ? name : label);
      shapes_.push_back(std::move(shape));
    }
    if (smooth_) parameters_.push_back({"radius", radius_, "m", -1e-300});
  }

  using LevelSet::set;
  void set(const double* p) override {
    for (auto& shape : shapes_) {
      shape->set(p);
      p += shape->size();
    }
    if (smooth_) radius_ = *p;
  }

  double value(const Vector3d& x) const override {
    double phi = sign_[0] * shapes_[0]->value(x);
    for (std::size_t i = 1; i < shapes_.size(); ++i)
      phi = intersection(phi, sign_[i] * shapes_[i]->value(x), radius_).phi;
    return outer_ * phi;
  }

  double evaluate(const Vector3d& x, Vector3d& dx, double* dp) const override {
    const std::size_t n = shapes_.size();
    std::array<Blend, 64> small;
    std::vector<Blend> large;
    Blend* step = small.data();
    if (n > small.size()) {
      large.resize(n);
      step = large.data();
    }
    step[0].phi = sign_[0] * shapes_[0]->value(x);
    for (std::size_t i = 1; i < n; ++i)
      step[i] = intersection(step[i - 1].phi, sign_[i] * shapes_[i]->value(x), radius_);
    back_propagate(x, step, dx, dp);
    return outer_ * step[n - 1].phi;
  }

  std::string error() const override {
    if (smooth_ && radius_ < 0) return "radius is negative";
    for (std::size_t i = 0; i < shapes_.size(); ++i)
      if (const std::string f = shapes_[i]->error(); !f.empty())
        return names_[i].empty() ? f : names_[i] + ": " + f;
    return {};
  }

  std::optional<Part> part(const std::string& path) const override {
    int first = 0;
    for (std::size_t i = 0; i < shapes_.size(); first += shapes_[i++]->size()) {
      const int sign = static_cast<int>(outer_ * sign_[i]);
      if (path == labels_[i] && !path.empty()) return Part{shapes_[i].get(), first, sign};
      const std::string prefix = labels_[i] + ".";
      auto inner = shapes_[i]->part(path);
      if (!inner && path.starts_with(prefix)) inner = shapes_[i]->part(path.substr(prefix.size()));
      if (inner) return Part{inner->shape, first + inner->first, sign * inner->sign};
    }
    return std::nullopt;
  }

 private:
  /// From the last step of the fold to the first; only operands with a weight are differentiated.
  void back_propagate(const Vector3d& x, const Blend* step, Vector3d& dx, double* dp) const {
    dx.setZero();
    double weight = outer_, dr = 0;
    double* end = dp ? dp + size() - (smooth_ ? 1 : 0) : nullptr;
    for (std::size_t i = shapes_.size(); i-- > 0;) {
      const double own = sign_[i] * weight * (i > 0 ? step[i].db : 1);
      const int k = shapes_[i]->size();
      double* begin = dp ? end - k : nullptr;
      if (own != 0) {
        Vector3d g;
        shapes_[i]->evaluate(x, g, begin);
        dx += own * g;
        for (int j = 0; dp && j < k; ++j) begin[j] *= own;
      } else if (dp) {
        std::fill(begin, end, 0.0);
      }
      if (i > 0) {
        dr += weight * step[i].dr;
        weight *= step[i].da;
      }
      end = begin;
    }
    if (dp && smooth_) dp[size() - 1] = dr;
  }

  bool smooth_;
  double radius_, outer_ = 1;
  std::vector<double> sign_;
  std::vector<std::string> names_, labels_;
  std::vector<LevelSetPtr> shapes_;
};

}  // namespace

LevelSetPtr unite(std::vector<Operand> operands, std::optional<double> radius) {
  return std::make_unique<Csg>(Operation::Union, std::move(operands), radius);
}
LevelSetPtr intersect(std::vector<Operand> operands, std::optional<double> radius) {
  return std::make_unique<Csg>(Operation::Intersection, std::move(operands), radius);
}
LevelSetPtr subtract(std::vector<Operand> operands, std::optional<double> radius) {
  return std::make_unique<Csg>(Operation::Difference, std::move(operands), radius);
}

LevelSetPtr extrude(double height, LevelSetPtr shape) {
  std::vector<Operand> operands;
  operands.push_back({"", slab(height)});
  operands.push_back({"", std::move(shape)});
  return intersect(std::move(operands));
}

}  // namespace liesl::levelset
