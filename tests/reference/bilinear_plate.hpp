#pragma once
/// @file
/// A plate of nx x ny unit squares, clamped at its left side, with a force in the middle of its
/// right one: the plain bilinear element in closed form, as topology optimisation codes have it
/// (O. Sigmund, A 99 line topology optimization code written in Matlab, Struct. Multidisc. Optim.
/// 21 (2001) 120-127). Shares nothing with mbs/solids.

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace liesl::test {

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

struct PlateAnswer {
  double compliance = 0;   ///< f^T u
  Eigen::VectorXd energy;  ///< u^T k u of each square with the full stiffness k
};

/// The plate for E = 1, thickness 1 and the sum of the forces P, in equal parts on the 2 n + 1
/// nodes round the middle of the right side.
/// @param scale stiffness of each square over that of the full one, row by row from below
inline PlateAnswer solve_cantilever(int nx, int ny, double nu, double P, int n,
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
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(f);
  PlateAnswer answer{f.dot(u), Eigen::VectorXd(nx * ny)};
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int at[] = {freedom(i, j), freedom(i + 1, j), freedom(i + 1, j + 1), freedom(i, j + 1)};
      Eigen::Matrix<double, 8, 1> own = Eigen::Matrix<double, 8, 1>::Zero();
      for (int a = 0; a < 8; ++a)
        if (at[a / 2] >= 0) own[a] = u[at[a / 2] + a % 2];
      answer.energy[j * nx + i] = own.dot(k * own);
    }
  return answer;
}

inline double cantilever_compliance(int nx, int ny, double nu, double P, int n,
                                    const Eigen::VectorXd& scale) {
  return solve_cantilever(nx, ny, nu, P, n, scale).compliance;
}

/// A bound from below for all designs whose squares have stiffnesses v_e in [least, 1] times that
/// of the full one and the mean `area`. The compliance is convex in v, so for any v with energies
/// e = -dc/dv of the squares it is at least
///   c(v) - max_w e . (w - v) over all such w,
/// and the w is a sorting. v is that of the stiffest sheet of variable thickness (M. P. Rossow,
/// J. E. Taylor, AIAA J. 11 (1973) 1566-1569), by optimality criteria v <- v sqrt(e/mu).
inline double least_compliance(int nx, int ny, double nu, double P, int n, double area,
                               double least) {
  using Eigen::VectorXd;
  const int cells = nx * ny;
  VectorXd v = VectorXd::Constant(cells, area);
  double bound = 0;
  for (int round = 0; round < 200; ++round) {
    const PlateAnswer at = solve_cantilever(nx, ny, nu, P, n, v);
    VectorXd sorted = at.energy;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    double left = (area - least) * cells, most = least * at.energy.sum();
    for (int e = 0; e < cells && left > 0; ++e) {
      const double added = std::min(left, 1 - least);
      most += added * sorted[e];
      left -= added;
    }
    bound = std::max(bound, at.compliance - (most - at.energy.dot(v)));
    double low = 0, high = at.energy.maxCoeff() / (least * least);
    VectorXd next;
    for (int k = 0; k < 100; ++k) {
      const double mu = (low + high) / 2;
      next = (v.array() * (at.energy.array() / mu).sqrt()).max(least).min(1.0);
      (next.mean() > area ? low : high) = mu;
    }
    v = next;
  }
  return bound;
}

}  // namespace liesl::test
