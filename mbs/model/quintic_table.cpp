/// @file
/// Tables as quintic splines, C4, at rest at both ends.

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "mbs/model/time_function_kind.hpp"

namespace liesl {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

/// Slope m and second derivative s at both ends of a piece of length h, values f_0 and f_1, D =
/// f_1 - f_0: the energy 1/2 int f'''^2 of its quintic has the gradient K [m_0; s_0; m_1; s_1] + D
/// b, the jumps of f'''' and f''' with their signs. That of the whole spline is least where both
/// are continuous.
struct PieceEnergy {
  Matrix2d first, mixed, second;  ///< K = [first mixed; mixed^T second]
  Vector2d b_first, b_second;

  explicit PieceEnergy(double h) {
    const double h2 = h * h, h3 = h2 * h, h4 = h2 * h2;
    first << 192 / h3, 36 / h2, 36 / h2, 9 / h;
    mixed << 168 / h3, -24 / h2, 24 / h2, -3 / h;
    second << 192 / h3, -36 / h2, -36 / h2, 9 / h;
    b_first << -360 / h4, -60 / h3;
    b_second << -360 / h4, 60 / h3;
  }
};

/// Slopes and second derivatives at the points, zero at the first and the last: the positive
/// definite block-tridiagonal system of the inner ones, eliminated from left to right.
std::vector<Vector2d> derivatives(const std::vector<double>& t, const std::vector<double>& f) {
  const std::size_t pieces = t.size() - 1;
  std::vector<Vector2d> z(t.size(), Vector2d::Zero());
  std::vector<Matrix2d> to_next(t.size(), Matrix2d::Zero());  // z_i = z[i] - to_next[i] z_{i+1}
  for (std::size_t i = 1; i < pieces; ++i) {
    const PieceEnergy before(t[i] - t[i - 1]), after(t[i + 1] - t[i]);
    const Matrix2d pivot =
        (before.second + after.first - before.mixed.transpose() * to_next[i - 1]).inverse();
    const Vector2d rhs = -((f[i] - f[i - 1]) * before.b_second + (f[i + 1] - f[i]) * after.b_first);
    z[i] = pivot * (rhs - before.mixed.transpose() * z[i - 1]);
    to_next[i] = pivot * after.mixed;
  }
  for (std::size_t i = pieces; i-- > 1;) z[i] -= to_next[i] * z[i + 1];
  return z;
}

class QuinticTable final : public TimeFunctionKind {
 public:
  QuinticTable(std::vector<double> t, std::vector<double> f) : t_(std::move(t)), f_(std::move(f)) {
    const auto z = derivatives(t_, f_);
    for (std::size_t i = 0; i + 1 < t_.size(); ++i) {
      const double h = t_[i + 1] - t_[i], D = f_[i + 1] - f_[i];
      const double m0 = h * z[i][0], s0 = h * h * z[i][1], m1 = h * z[i + 1][0],
                   s1 = h * h * z[i + 1][1];
      pieces_.push_back({h,
                         {f_[i], m0, s0 / 2, 10 * D - 6 * m0 - 1.5 * s0 - 4 * m1 + 0.5 * s1,
                          -15 * D + 8 * m0 + 1.5 * s0 + 7 * m1 - s1,
                          6 * D - 3 * m0 - 0.5 * s0 - 3 * m1 + 0.5 * s1}});
    }
  }
  double value(double t) const override {
    if (t <= t_.front()) return f_.front();
    if (t >= t_.back()) return f_.back();
    const auto [u, h, c] = at(t);
    return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
  }
  double rate(double t) const override {
    if (outside(t)) return 0;
    const auto [u, h, c] = at(t);
    return (c[1] + u * (2 * c[2] + u * (3 * c[3] + u * (4 * c[4] + u * 5 * c[5])))) / h;
  }
  double acceleration(double t) const override {
    if (outside(t)) return 0;
    const auto [u, h, c] = at(t);
    return (2 * c[2] + u * (6 * c[3] + u * (12 * c[4] + u * 20 * c[5]))) / (h * h);
  }
  bool is_constant() const override {
    return std::all_of(f_.begin(), f_.end(), [&](double f) { return f == f_.front(); });
  }

 private:
  struct Piece {
    double h;
    double c[6];  ///< f = sum c_k u^k, u = (t - t_i)/h
  };
  struct Place {
    double u, h;
    const double* c;
  };
  bool outside(double t) const { return t <= t_.front() || t >= t_.back(); }
  /// NaN, which an iteration that diverges asks for, gives NaN. @pre t is inside the table or NaN
  Place at(double t) const {
    const auto next = std::upper_bound(t_.begin(), t_.end() - 1, t);
    const auto i = static_cast<std::size_t>(next - t_.begin()) - 1;
    return {(t - t_[i]) / pieces_[i].h, pieces_[i].h, pieces_[i].c};
  }

  std::vector<double> t_, f_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::shared_ptr<const TimeFunctionKind> quintic_table(std::vector<double> t,
                                                      std::vector<double> f) {
  return std::make_shared<QuinticTable>(std::move(t), std::move(f));
}

}  // namespace liesl
