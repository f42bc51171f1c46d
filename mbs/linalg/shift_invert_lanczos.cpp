#include "mbs/linalg/shift_invert_lanczos.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <cmath>
#include <exception>

#include "mbs/linalg/stop_request.hpp"

namespace liesl {

bool shift_invert_lanczos(ShiftedInverse& inverse, const LinearOperator& mass, int count, int most,
                          double sigma, double tolerance, Eigen::VectorXd& lambda,
                          Eigen::MatrixXd& phi) {
  const int basis = std::min(most, std::max(2 * count + 20, 3 * count));
  Spectra::SymGEigsShiftSolver<ShiftedInverse, const LinearOperator,
                               Spectra::GEigsMode::ShiftInvert>
      solver(inverse, mass, count, basis, sigma);
  if (!inverse.regular()) return false;
  const auto n = inverse.rows();
  Eigen::VectorXd start(n), image(n);  // in the range of the operator: M may be singular
  for (Eigen::Index i = 0; i < n; ++i) start[i] = std::sin(1.0 + 1.7 * static_cast<double>(i));
  mass.perform_op(start.data(), image.data());
  start = image;
  inverse.perform_op(start.data(), image.data());
  if (!image.allFinite() || image.norm() == 0) return false;
  image /= image.cwiseAbs().maxCoeff();
  try {
    solver.init(image.data());
    solver.compute(Spectra::SortRule::LargestMagn, 300, tolerance, Spectra::SortRule::SmallestAlge);
  } catch (const Stopped&) {
    throw;
  } catch (const std::exception&) {  // Spectra's way to say that the start is in too small a space
    return false;
  }
  if (solver.info() != Spectra::CompInfo::Successful) return false;
  lambda = solver.eigenvalues();
  phi = solver.eigenvectors();
  return lambda.allFinite() && phi.allFinite();
}

}  // namespace liesl
