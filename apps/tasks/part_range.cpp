#include "apps/tasks/part_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBend = 0.15;  // rad
constexpr double kEuler = 0.1;  // its bending is about as much too stiff, or too soft in tension

/// Largest compression over the Euler load.
template <FrameGroup G>
double over_euler(const SolidBody<G>& body, const MatrixXd& e) {
  constexpr int sd = G::space_dim, dim = G::dim;
  const auto& frames = body.reference;
  const Eigen::Matrix<double, sd, 1> span = frames[1].x - frames[0].x;
  const double length = span.norm();
  if (length == 0) return 0;
  const VectorXd d = frames[1].R.transpose() * span / length;
  const MatrixXd K = body.reduced_stiffness().topLeftCorner(dim, dim);
  const MatrixXd C = K.inverse().topLeftCorner(sd, sd);
  const MatrixXd across = MatrixXd::Identity(sd, sd) - d * d.transpose();
  const double softest = linalg::symmetric_eigenvalues(across * C * across).maxCoeff();
  const double euler = M_PI * M_PI * length / (3 * softest);
  const VectorXd pull = d.transpose() * (K * e.topRows(dim)).topRows(sd);
  return std::max(0., -pull.minCoeff() / euler);
}

}  // namespace

template <FrameGroup G>
PartRange part_range(const SolidBody<G>& body, const MatrixXd& e) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  PartRange range;
  if (e.cols() == 0) return range;
  for (int i = 0; i + 1 < body.points(); ++i)
    range.bend = std::max(range.bend, e.middleRows(dim * i + sd, rd).colwise().norm().maxCoeff());
  if (body.points() == 2) range.euler = over_euler(body, e);
  return range;
}

std::vector<std::string> range_warnings(const std::string& part, const PartRange& range) {
  std::vector<std::string> warnings;
  if (range.bend > kBend)
    warnings.push_back(
        fmt::format("the part '{}' bends by up to {:.2g} rad between its interfaces, but its "
                    "deformation is linear: divide it into several parts in a row",
                    part, range.bend));
  if (range.euler > kEuler)
    warnings.push_back(
        fmt::format("the part '{}' carries up to {:.2g} of its Euler load, but axial forces do not "
                    "change how it bends: divide it into several parts in a row, or use a beam",
                    part, range.euler));
  return warnings;
}

template PartRange part_range(const SolidBody<SE2>&, const MatrixXd&);
template PartRange part_range(const SolidBody<SE3>&, const MatrixXd&);

}  // namespace liesl
