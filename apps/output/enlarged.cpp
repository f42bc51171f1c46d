#include "apps/output/enlarged.hpp"

#include <Eigen/Geometry>

namespace liesl::output {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d mean_turn(const BodyResult& body, std::size_t first) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(body.nodes); ++k) {
    const Matrix3d turn =
        axes_at(body.rotations, first + k) * axes_at(body.reference_rotations, k).transpose();
    const Eigen::Vector4d q = Eigen::Quaterniond(turn).coeffs();
    sum += sum.dot(q) < 0 ? Eigen::Vector4d(-q) : q;
  }
  return Eigen::Quaterniond(Eigen::Vector4d(sum.normalized())).toRotationMatrix();
}

std::vector<double> shares(const BodyResult& beam) {
  const std::vector<double>& x = beam.reference_positions;
  std::vector<double> out(static_cast<std::size_t>(beam.nodes), 0);
  for (std::size_t k = 1; k < out.size(); ++k)
    out[k] = out[k - 1] + (vector_at(x, k) - vector_at(x, k - 1)).norm();
  for (const double length = out.back(); double& s : out) s /= length;
  return out;
}

}  // namespace

bool from_rest(const Results& results) { return results.abscissa != "time"; }

Enlarged::Enlarged(const Results& results, const BodyResult& body, std::size_t row)
    : body_(body),
      known_(!body.reference_positions.empty() && !body.reference_rotations.empty()),
      from_rest_(from_rest(results)),
      first_(row * static_cast<std::size_t>(body.nodes)) {
  if (!known_ || from_rest_ || body.elements.empty()) return;
  share_ = shares(body);
  turn_ = mean_turn(body, first_);
}

Vector3d Enlarged::at(int node, const Vector3d& place) const {
  if (!known_) return Vector3d::Zero();
  const auto k = static_cast<std::size_t>(node);
  if (from_rest_)
    return vector_at(body_.positions, first_ + k) + axes_at(body_.rotations, first_ + k) * place -
           vector_at(body_.reference_positions, k) - axes_at(body_.reference_rotations, k) * place;
  return share_.empty() ? Vector3d(Vector3d::Zero()) : about_chord(k);
}

Vector3d Enlarged::about_chord(std::size_t node) const {
  const auto beside = [&](const std::vector<double>& x, std::size_t first) -> Vector3d {
    const std::size_t last = first + static_cast<std::size_t>(body_.nodes) - 1;
    const double s = share_[node];
    return vector_at(x, first + node) - (1 - s) * vector_at(x, first) - s * vector_at(x, last);
  };
  return beside(body_.positions, first_) - turn_ * beside(body_.reference_positions, 0);
}

}  // namespace liesl::output
