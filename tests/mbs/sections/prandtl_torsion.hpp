#pragma once
/// @file
/// Independent torsion solution: Prandtl's stress function by finite differences.

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

namespace liesl::test {

/// phi with lap phi = -2 on a W x H rectangle, phi = 0 on its outline; over a concentric hollow
/// with walls of thickness `wall` (0: none) phi is constant (the discrete energy then gives Bredt's
/// condition on the hollow by itself). J = 2 int phi; tau at the outline = -d phi/dn M_x/J.
class PrandtlTorsion {
 public:
  /// Square cells of side `cell`, which must divide W, H and wall.
  PrandtlTorsion(double W, double H, double wall, double cell)
      : h_(cell), nx_(int(std::lround(W / cell))), ny_(int(std::lround(H / cell))) {
    const int k = int(std::lround(wall / cell));
    number_.assign(std::size_t((nx_ + 1) * (ny_ + 1)), -1);
    int n = 1;  // unknown 0: the hollow
    for (int i = 1; i < nx_; ++i)
      for (int j = 1; j < ny_; ++j)
        at(i, j) = k > 0 && i >= k && i <= nx_ - k && j >= k && j <= ny_ - k ? 0 : n++;
    solve(n);
  }

  double J() const { return J_; }

  /// -d phi/dn in the middle of the bottom side (normal to H) shifted by `fraction` of half of it.
  double slope_bottom(double fraction) const {
    const int i = int(std::lround(nx_ / 2.0 * (1 + fraction)));
    return slope(value(i, 1), value(i, 2), value(i, 3));
  }
  double slope_left(double fraction) const {
    const int j = int(std::lround(ny_ / 2.0 * (1 + fraction)));
    return slope(value(1, j), value(2, j), value(3, j));
  }

 private:
  int& at(int i, int j) { return number_[std::size_t(i * (ny_ + 1) + j)]; }
  double value(int i, int j) const {
    const int k = number_[std::size_t(i * (ny_ + 1) + j)];
    return k < 0 ? 0 : phi_[k];
  }
  /// Third-order one-sided difference from phi = 0 on the outline.
  double slope(double a, double b, double c) const { return (3 * a - 1.5 * b + c / 3) / h_; }

  /// Minimises 1/2 int |grad phi|^2 - 2 int phi over the grid.
  void solve(int n) {
    std::vector<Eigen::Triplet<double>> K;
    Eigen::VectorXd f = Eigen::VectorXd::Zero(n);
    const auto edge = [&](int p, int q) {
      if (p >= 0) K.emplace_back(p, p, 1);
      if (q >= 0) K.emplace_back(q, q, 1);
      if (p >= 0 && q >= 0) K.emplace_back(p, q, -1), K.emplace_back(q, p, -1);
    };
    for (int i = 0; i <= nx_; ++i)
      for (int j = 0; j <= ny_; ++j) {
        if (at(i, j) >= 0) f[at(i, j)] += 2 * h_ * h_;
        if (i < nx_) edge(at(i, j), at(i + 1, j));
        if (j < ny_) edge(at(i, j), at(i, j + 1));
      }
    if (f[0] == 0) K.emplace_back(0, 0, 1);  // no hollow
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(K.begin(), K.end());
    phi_ = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(f);
    J_ = phi_.dot(f);
  }

  double h_;
  int nx_, ny_;
  std::vector<int> number_;
  Eigen::VectorXd phi_;
  double J_ = 0;
};

}  // namespace liesl::test
