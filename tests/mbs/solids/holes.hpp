#pragma once
/// @file
/// A disc meshed round a point in it, so that a hole there follows the sides of the cells.

#include <cmath>
#include <numbers>
#include <vector>

#include "mbs/solids/solid_statics.hpp"

namespace liesl::test {

/// Rings round the origin, square cells that grow outwards, with a circle of `radius` among the
/// rings; the rim has the radius 1 about `centre`. What is left out in the middle is a hundredth
/// of that circle.
struct HoledDisc {
  static constexpr double kThickness = 0.01, kCore = 1e-2;

  HoledDisc(int round, double radius, const Material& material)
      : round_(round), model(mesh_of(round, radius), material, {}, {kThickness, {1, 1e-9}}) {
    const SolidMesh& mesh = model.mesh();
    const auto load = [&](const Eigen::Vector3d& towards, const Eigen::Vector3d& traction) {
      return traction_load(model, rim(mesh, towards), traction);
    };
    const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0);
    loads.resize(model.size(), 2);
    loads << load(x, 1e6 * x) + load(-x, -1e6 * x) + load(y, 3e5 * y) + load(-y, -3e5 * y),
        load(x, 1e6 * y) + load(-x, -1e6 * y) + load(y, 1e6 * x) + load(-y, -1e6 * x);
    outputs =
        node_output(model, rim(mesh, x).front(), 0) - node_output(model, rim(mesh, -x).front(), 0);
    unbalanced = load(x, 1e6 * (x + 0.3 * y));
  }

  SolidStatics statics(bool relief) {
    SolidSupport support = SolidSupport::relief();
    if (!relief) {
      support = {};
      fix_nodes(support, model, {rim(model.mesh(), {-1, 0, 0}).front()}, "xy");
      fix_nodes(support, model, {rim(model.mesh(), {1, 0, 0}).front()}, "y");
    }
    SolidStatics s(model, support, outputs);
    Eigen::MatrixXd f = loads;
    if (relief) f.col(0) += unbalanced;
    s.set_loads(f);
    return s;
  }

  /// The ring of cells at this distance from the origin.
  std::vector<int> cells_at(double distance) const {
    int nearest = 0;
    const auto off = [&](int e) {
      return std::abs(std::log(model.mesh().corners_of(e).rowwise().mean().norm() / distance));
    };
    for (int e = 0; e < model.mesh().cell_count(); ++e)
      if (off(e) < off(nearest)) nearest = e;
    std::vector<int> ring;
    for (int e = 0; e < round_; ++e) ring.push_back(nearest / round_ * round_ + e);
    return ring;
  }

  int round_ = 0;
  SolidModel model;
  Eigen::MatrixXd loads, outputs;
  Eigen::VectorXd unbalanced;

 private:
  static Eigen::Vector3d centre() { return {0.17, -0.11, 0}; }

  static std::vector<int> rim(const SolidMesh& mesh, const Eigen::Vector3d& towards) {
    return nodes_where(mesh, [&](const Eigen::Vector3d& p) {
      return (p - centre()).norm() > 1 - 1e-9 && (p - centre()).dot(towards) > 0.8;
    });
  }

  static SolidMesh mesh_of(int round, double radius) {
    const double step = 2 * std::numbers::pi / round;  // of log r, for square cells
    const int inner = static_cast<int>(std::ceil(std::log(1 / kCore) / step));
    const int outer = static_cast<int>(std::ceil(std::log(1 / radius) / step));
    SolidMesh mesh;
    mesh.nodes.resize(3, (inner + outer + 1) * round);
    mesh.cells.resize(4, (inner + outer) * round);
    for (int i = 0; i <= inner + outer; ++i)
      for (int j = 0; j < round; ++j) {
        const Eigen::Vector3d ray(std::cos(step * j), std::sin(step * j), 0);
        const double along = ray.dot(centre());
        const double far = along + std::sqrt(along * along + 1 - centre().squaredNorm());
        const double r = i <= inner ? radius * std::pow(kCore, 1 - double(i) / inner)
                                    : radius * std::pow(far / radius, double(i - inner) / outer);
        mesh.nodes.col(i * round + j) = r * ray;
        const int next = i * round + (j + 1) % round;
        if (i < inner + outer)
          mesh.cells.col(i * round + j) =
              Eigen::Vector4i(i * round + j, (i + 1) * round + j, next + round, next);
      }
    return mesh;
  }
};

}  // namespace liesl::test
