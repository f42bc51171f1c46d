#pragma once
/// @file
/// Eigenpairs of K phi = lambda M phi nearest a shift, by Lanczos on (K - sigma M)^-1 (Spectra).

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/Core>
#include <cmath>
#include <exception>

namespace liesl {

/// @param op y = (K - sigma M)^-1 x, with rows(), cols(), set_shift(sigma), perform_op(x, y),
/// regular()  @param mass y = M x, likewise  @param most dimension of the space of the solution
/// @param lambda growing  @param phi M-normal
/// @returns false if the operator is singular or the iteration does not end
template <class Operator, class Mass>
bool shift_invert_lanczos(Operator& op, Mass& mass, int count, int most, double sigma,
                          double tolerance, Eigen::VectorXd& lambda, Eigen::MatrixXd& phi) {
  const int basis = std::min(most, std::max(2 * count + 20, 3 * count));
  Spectra::SymGEigsShiftSolver<Operator, Mass, Spectra::GEigsMode::ShiftInvert> solver(
      op, mass, count, basis, sigma);
  if (!op.regular()) return false;
  const auto n = op.rows();
  Eigen::VectorXd start(n), image(n);  // in the range of the operator: M may be singular
  for (Eigen::Index i = 0; i < n; ++i) start[i] = std::sin(1.0 + 1.7 * static_cast<double>(i));
  mass.perform_op(start.data(), image.data());
  start = image;
  op.perform_op(start.data(), image.data());
  if (!image.allFinite() || image.norm() == 0) return false;
  image /= image.cwiseAbs().maxCoeff();
  try {
    solver.init(image.data());
    solver.compute(Spectra::SortRule::LargestMagn, 300, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const std::exception&) {  // Spectra's way to say that the start is in too small a space
    return false;
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  lambda = solver.eigenvalues();
  phi = solver.eigenvectors();
  return lambda.allFinite() && phi.allFinite();
}

}  // namespace liesl
