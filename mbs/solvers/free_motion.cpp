#include "mbs/solvers/free_motion.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

constexpr int kMost = 8;  // free motions looked for
constexpr int kIterations = 20;
constexpr double kShift = 1e-11;  // of the largest stiffness
constexpr double kFree = 1e-14;   // stiffness that is round-off, of the largest

/// Diagonal of the metric: k for translations, k length^2 for rotations, k = largest stiffness.
template <FrameGroup G>
Eigen::VectorXd metric(const Model<G>& model, const Eigen::SparseMatrix<double>& A) {
  double k = 0;
  for (int i = 0; i < model.size(); ++i)
    if (i % G::dim < G::space_dim) k = std::max(k, std::abs(A.coeff(i, i)));
  if (k == 0) k = 1;
  Eigen::VectorXd d(model.size());
  for (int i = 0; i < d.size(); ++i)
    d[i] = i % G::dim < G::space_dim ? k : k * model.length * model.length;
  return d;
}

std::string text(Vec3 v, double size) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 1e-6 * size) v[i] = 0;
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", v.x(), v.y(), v.z());
}

/// Increments of one node for each motion, as translation and rotation in inertial axes of space.
struct NodeMotion {
  SE3 frame;
  Eigen::Matrix3Xd u, w;
};

template <FrameGroup G>
NodeMotion node_motion(const Model<G>& model, const State<G>& s, const Eigen::MatrixXd& motions,
                       int node) {
  const SE3 align = SE3::identity();
  NodeMotion m{model.space.embed(s.H[node], align), {}, {}};
  m.u.resize(3, motions.cols());
  m.w.resize(3, motions.cols());
  for (int j = 0; j < motions.cols(); ++j) {
    const typename G::Tangent h = motions.col(j).template segment<G::dim>(G::dim * node);
    SE3::Tangent full;
    if constexpr (G::dim == 6)
      full = h;
    else
      full << h[0], h[1], 0, 0, 0, h[2];
    m.u.col(j) = m.frame.R * full.template head<3>();
    m.w.col(j) = m.frame.R * full.template tail<3>();
  }
  return m;
}

/// "can move along ..." if a combination of the motions does not turn the node, else "can rotate
/// about ...".
std::string describe(const NodeMotion& m, double length) {
  const auto [sigma, V] = linalg::right_singular(length * m.w);
  int rank = 0;
  while (rank < sigma.size() && sigma[rank] > 1e-6) ++rank;
  Eigen::VectorXd best;
  for (int j = rank; j < m.u.cols(); ++j) {
    const Vec3 u = m.u * V.col(j);
    if (best.size() == 0 || u.norm() > (m.u * best).norm()) best = V.col(j);
  }
  if (best.size() > 0 && (m.u * best).norm() > 1e-6) {
    Vec3 u = (m.u * best).normalized();
    int largest;
    u.cwiseAbs().maxCoeff(&largest);
    if (u[largest] < 0) u = -u;
    return "can move along " + text(u, 1);
  }
  const Vec3 u = m.u * V.col(0), w = m.w * V.col(0);
  Vec3 axis = w.normalized();
  int largest;
  axis.cwiseAbs().maxCoeff(&largest);
  if (axis[largest] < 0) axis = -axis;
  const Vec3 point = m.frame.x + w.cross(u) / w.squaredNorm();
  return fmt::format("can rotate about {} through {}", text(axis, 1), text(point, length));
}

}  // namespace

template <FrameGroup G>
Eigen::MatrixXd free_motions(const Model<G>& model, const Eigen::SparseMatrix<double>& A) {
  const int n = model.size(), m = model.constraints(), most = std::min(kMost, n);
  const Eigen::VectorXd D = metric(model, A), root = D.cwiseSqrt();
  Eigen::SparseMatrix<double> shift(n + m, n + m);
  shift.reserve(Eigen::VectorXi::Constant(n + m, 1));
  for (int i = 0; i < n; ++i) shift.insert(i, i) = kShift * D[i];
  Eigen::SparseMatrix<double> shifted = A + shift;
  shifted.makeCompressed();
  SparseLu lu;
  if (!lu.factor(shifted)) return Eigen::MatrixXd(n, 0);
  // Subspace iteration; a fixed start that is not orthogonal to anything in particular.
  Eigen::MatrixXd X(n, most), Y(n + m, most);
  for (int j = 0; j < most; ++j)
    for (int i = 0; i < n; ++i) X(i, j) = std::sin(1.0 + 0.7 * i + 1.3 * j * (i + 1)) / root[i];
  for (int k = 0; k < kIterations; ++k) {
    Y.setZero();
    Y.topRows(n) = D.asDiagonal() * X;
    lu.solve(Y);
    if (!Y.allFinite()) return Eigen::MatrixXd(n, 0);
    const Eigen::MatrixXd Q =
        linalg::times_q(root.asDiagonal() * Y.topRows(n), Eigen::MatrixXd::Identity(n, most));
    X = root.cwiseInverse().asDiagonal() * Q;
  }
  const Eigen::SparseMatrix<double> K = A.topLeftCorner(n, n), B = A.bottomLeftCorner(m, n);
  // Columns beyond the null space of B (fewer than `most` motions exist) count as stiff.
  Eigen::MatrixXd T(most + m, most);
  T << X.transpose() * (K * X), Eigen::MatrixXd(B * X) * std::sqrt(D[0]);
  const auto [sigma, V] = linalg::right_singular(T);  // T is not wide
  int found = 0;
  while (found < most && sigma[most - 1 - found] < kFree) ++found;
  return std::sqrt(D[0]) * X * V.rightCols(found);
}

template <FrameGroup G>
std::string describe_free_motion(const Model<G>& model, const State<G>& s,
                                 const Eigen::MatrixXd& motions) {
  size_t body = 0;
  double most = -1;
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const auto rows =
        motions.middleRows(G::dim * model.first_node(static_cast<int>(b)), model.bodies[b]->size());
    if (rows.norm() > most * (1 + 1e-6)) {
      most = rows.norm();
      body = b;
    }
  }
  const int first = model.first_node(static_cast<int>(body)), nodes = model.bodies[body]->points();
  int node = 0;  // the one that moves least: the axis is near
  for (int k = 1; k < nodes; ++k) {
    const auto shift = [&](int i) {
      return motions.middleRows(G::dim * (first + i), G::space_dim).norm();
    };
    if (shift(k) < (1 - 1e-6) * shift(node)) node = k;
  }
  const std::string what = describe(node_motion(model, s, motions, first + node), model.length);
  const auto more = motions.cols() - 1;
  return fmt::format(
      "body '{}' {} at its node {} and nothing resists{}; add a joint, a drive or a spring",
      model.bodies[body]->name, what, node,
      more > 0 ? fmt::format(" (one of {} free motions)", more + 1) : "");
}

template Eigen::MatrixXd free_motions(const Model<SE2>&, const Eigen::SparseMatrix<double>&);
template Eigen::MatrixXd free_motions(const Model<SE3>&, const Eigen::SparseMatrix<double>&);
template std::string describe_free_motion(const Model<SE2>&, const State<SE2>&,
                                          const Eigen::MatrixXd&);
template std::string describe_free_motion(const Model<SE3>&, const State<SE3>&,
                                          const Eigen::MatrixXd&);

}  // namespace liesl
