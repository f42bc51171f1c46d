#pragma once
/// @file
/// A plate of nx x ny unit squares, clamped at its left side, with a force in the middle of its
/// right one: the plain bilinear element in closed form, as topology optimisation codes have it
/// (O. Sigmund, A 99 line topology optimization code written in Matlab, Struct. Multidisc. Optim.
/// 21 (2001) 120-127). Shares nothing with mbs/solids.

#include <Eigen/SparseCholesky>
#include <cmath>
#include <vector>

namespace liesl::reference {

/// Stiffness of a unit square for E = 1 and thickness 1, corners counter-clockwise from lower left.
inline Eigen::Matrix<double, 8, 8> bilinear_square(double nu) {
  const double k[] = {1. / 2 - nu / 6,
                      1. / 8 + nu / 8,
                      -1. / 4 - nu / 12,
                      -1. / 8 + 3 * nu / 8,
                      -1. / 4 + nu / 12,
                      -1. / 8 - nu / 8,
                      nu / 6,
                      1. / 8 - 3 * nu / 8};
  const int order[8][8] = {{0, 1, 2, 3, 4, 5, 6, 7}, {1, 0, 7, 6, 5, 4, 3, 2},
                           {2, 7, 0, 5, 6, 3, 4, 1}, {3, 6, 5, 0, 7, 2, 1, 4},
                           {4, 5, 6, 7, 0, 1, 2, 3}, {5, 4, 3, 2, 1, 0, 7, 6},
                           {6, 3, 4, 1, 2, 7, 0, 5}, {7, 2, 1, 4, 3, 6, 5, 0}};
  Eigen::Matrix<double, 8, 8> K;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) K(i, j) = k[order[i][j]] / (1 - nu * nu);
  return K;
}

/// f^T u for E = 1, thickness 1 and the sum of the forces P, in equal parts on the 2 n + 1 nodes
/// round the middle of the right side.
/// @param scale stiffness of each square over that of the full one, row by row from below
inline double cantilever_compliance(int nx, int ny, double nu, double P, int n,
                                    const Eigen::VectorXd& scale) {
  const Eigen::Matrix<double, 8, 8> k = bilinear_square(nu);
  const auto freedom = [&](int i, int j) { return 2 * ((i - 1) * (ny + 1) + j); };  // i = 0: held
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int at[] = {freedom(i, j), freedom(i + 1, j), freedom(i + 1, j + 1), freedom(i, j + 1)};
      for (int a = 0; a < 8; ++a)
        for (int b = 0; b < 8; ++b)
          if (at[a / 2] >= 0 && at[b / 2] >= 0)
            entries.emplace_back(at[a / 2] + a % 2, at[b / 2] + b % 2, scale[j * nx + i] * k(a, b));
    }
  Eigen::SparseMatrix<double> K(2 * nx * (ny + 1), 2 * nx * (ny + 1));
  K.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd f = Eigen::VectorXd::Zero(K.rows());
  for (int m = -n; m <= n; ++m) f[freedom(nx, ny / 2 + m) + 1] = P / (2 * n + 1);
  return f.dot(Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(f));
}

}  // namespace liesl::reference
