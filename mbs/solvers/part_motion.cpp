#include "mbs/solvers/part_motion.hpp"

#include <bit>
#include <numbers>
#include <unsupported/Eigen/FFT>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Columns at equal steps, linear between those given.
MatrixXd at_equal_steps(const std::vector<double>& t, const MatrixXd& signals) {
  const auto n = static_cast<Eigen::Index>(t.size());
  MatrixXd even(signals.rows(), n);
  Eigen::Index after = 1;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double at =
        t.front() + (t.back() - t.front()) * static_cast<double>(i) / static_cast<double>(n - 1);
    while (after < n - 1 && t[after] < at) ++after;
    const double part = (at - t[after - 1]) / (t[after] - t[after - 1]);
    even.col(i) = (1 - part) * signals.col(after - 1) + part * signals.col(after);
  }
  return even;
}

}  // namespace

template <FrameGroup G>
MatrixXd part_coordinates(const SolidBody<G>& body, int first_node,
                          const Trajectory<G>& trajectory) {
  MatrixXd e(body.basis().cols(), trajectory.size());
  for (int n = 0; n < trajectory.size(); ++n) {
    const VectorXd w = trajectory.w(n);
    e.col(n) = body.coordinates(
        {trajectory.frames(n) + first_node, nullptr, nullptr, w.data() + G::dim * first_node});
  }
  return e;
}

template <FrameGroup G>
MatrixXd energy_signals(const SolidBody<G>& body, const MatrixXd& e) {
  const auto n = e.rows();  // without padding
  const auto [lambda, phi] = linalg::symmetric_eigen(body.reduced_stiffness().topLeftCorner(n, n));
  return lambda.cwiseMax(0).cwiseSqrt().asDiagonal() * (phi.transpose() * e);
}

double bandwidth(const std::vector<double>& t, const MatrixXd& signals, double share) {
  const auto n = static_cast<Eigen::Index>(t.size());
  if (n < 3) return 0;
  const VectorXd window =
      VectorXd::LinSpaced(n, 0, std::numbers::pi).array().sin().square().matrix();
  const MatrixXd windowed = at_equal_steps(t, signals) * window.asDiagonal();
  const auto size = static_cast<Eigen::Index>(std::bit_ceil(t.size()));
  Eigen::FFT<double> transform(Eigen::FFT<double>::impl_type(), Eigen::FFT<double>::HalfSpectrum);
  VectorXd padded = VectorXd::Zero(size), power = VectorXd::Zero(size / 2 + 1);
  Eigen::VectorXcd spectrum;
  for (Eigen::Index row = 0; row < windowed.rows(); ++row) {
    padded.head(n) = windowed.row(row).transpose();
    transform.fwd(spectrum, padded);
    power += spectrum.head(power.size()).cwiseAbs2();
  }
  double above = 0;
  auto line = size / 2;
  for (const double all = power.sum(); line > 0; --line)
    if (above += power[line]; above > share * all) break;
  const double rate = static_cast<double>(n - 1) / (t.back() - t.front());
  return rate * static_cast<double>(line) / static_cast<double>(size);
}

template MatrixXd part_coordinates(const SolidBody<SE2>&, int, const Trajectory<SE2>&);
template MatrixXd part_coordinates(const SolidBody<SE3>&, int, const Trajectory<SE3>&);
template MatrixXd energy_signals(const SolidBody<SE2>&, const MatrixXd&);
template MatrixXd energy_signals(const SolidBody<SE3>&, const MatrixXd&);

}  // namespace liesl
