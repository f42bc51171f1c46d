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
constexpr double kStill = 1e-6;   // a motion that is none, of the largest

/// Way of a unit of each unknown, m: 1 for translations, the mechanism's length for rotations. 0
/// where the unit is another: amplitudes, what stands in for rotations of positions, followers.
template <FrameGroup G>
Eigen::VectorXd arms(const Model<G>& model) {
  Eigen::VectorXd a = Eigen::VectorXd::Zero(model.size());
  for (const int k : model.positions()) a.template segment<G::space_dim>(G::dim * k).setOnes();
  for (const int k : model.frames()) {
    a.template segment<G::space_dim>(G::dim * k).setOnes();
    a.template segment<G::rotation_dim>(G::dim * k + G::space_dim).setConstant(model.length);
  }
  return a;
}

/// Largest stiffness of each body against motions of its nodes, N/m.
template <FrameGroup G>
Eigen::VectorXd stiffest(const Model<G>& model, const Eigen::SparseMatrix<double>& A,
                         const Eigen::VectorXd& arm) {
  Eigen::VectorXd k = Eigen::VectorXd::Zero(static_cast<int>(model.bodies.size()));
  for (int b = 0; b < k.size(); ++b) {
    const int first = G::dim * model.first_node(b);
    for (int j = first; j < first + model.bodies[b]->size(); ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(A, j); it; ++it)
        if (it.row() < arm.size() && arm[it.row()] * arm[j] > 0)
          k[b] = std::max(k[b], std::abs(it.value()) / (arm[it.row()] * arm[j]));
  }
  return k;
}

/// Diagonal of the metric, in which every stiffness is a number without unit: k arm^2 with the
/// largest stiffness k of the body, and of all bodies where it has none; the own stiffness of
/// unknowns of another unit.
template <FrameGroup G>
Eigen::VectorXd metric(const Model<G>& model, const Eigen::SparseMatrix<double>& A,
                       const Eigen::VectorXd& arm) {
  const Eigen::VectorXd k = stiffest(model, A, arm);
  const double most = k.maxCoeff() > 0 ? k.maxCoeff() : 1;
  Eigen::VectorXd d(model.size());
  for (int b = 0; b < k.size(); ++b) {
    const int first = G::dim * model.first_node(b);
    for (int i = first; i < first + model.bodies[b]->size(); ++i) {
      const double own = std::abs(A.coeff(i, i));
      d[i] = arm[i] > 0 ? (k[b] > 0 ? k[b] : most) * arm[i] * arm[i] : own > 0 ? own : most;
    }
  }
  return d;
}

/// The same motions, orthonormal with the arms; what has none is measured by the metric D.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& motions, const Eigen::VectorXd& arm,
                            const Eigen::VectorXd& D) {
  if (motions.cols() == 0) return motions;
  const Eigen::VectorXd w = (arm.array() > 0).select(arm, (D / D.maxCoeff()).cwiseSqrt());
  const Eigen::MatrixXd Q = linalg::times_q(
      w.asDiagonal() * motions, Eigen::MatrixXd::Identity(motions.rows(), motions.cols()));
  return w.cwiseInverse().asDiagonal() * Q;
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
std::string describe(NodeMotion m, double length) {
  const double size = std::hypot(m.u.norm(), length * m.w.norm());
  if (!(size > 0)) return "can deform";
  m.u /= size;
  m.w /= size;
  const auto [sigma, V] = linalg::right_singular(length * m.w);
  int rank = 0;
  while (rank < sigma.size() && sigma[rank] > kStill) ++rank;
  Eigen::VectorXd best;
  for (int j = rank; j < m.u.cols(); ++j) {
    const Vec3 u = m.u * V.col(j);
    if (best.size() == 0 || u.norm() > (m.u * best).norm()) best = V.col(j);
  }
  if (best.size() > 0 && (m.u * best).norm() > kStill) {
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

/// Of a body that moves, the node that is moved least by it: the axis is near.
/// @param ways of the unknowns of a node, a block of `dim` rows each
template <FrameGroup G>
int node_of_axis(const Eigen::MatrixXd& ways) {
  const int nodes = static_cast<int>(ways.rows()) / G::dim;
  const auto moved = [&](int k, int rows) { return ways.middleRows(G::dim * k, rows).norm(); };
  double most = 0;
  for (int k = 0; k < nodes; ++k) most = std::max(most, moved(k, G::dim));
  int node = -1;
  for (int k = 0; k < nodes; ++k)
    if (moved(k, G::dim) >= kStill * most &&
        (node < 0 || moved(k, G::space_dim) < (1 - kStill) * moved(node, G::space_dim)))
      node = k;
  return node;
}

}  // namespace

template <FrameGroup G>
Eigen::MatrixXd free_motions(const Model<G>& model, const Eigen::SparseMatrix<double>& A) {
  const int n = model.size(), m = model.constraints(), most = std::min(kMost, n);
  const Eigen::VectorXd arm = arms(model), D = metric(model, A, arm), root = D.cwiseSqrt();
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
  // Rows of B are measured as the unknowns are.
  const Eigen::VectorXd sizes = (B.cwiseAbs2() * D.cwiseInverse()).cwiseSqrt();
  // Columns beyond the null space of B (fewer than `most` motions exist) count as stiff.
  Eigen::MatrixXd T(most + m, most);
  T << X.transpose() * (K * X), Eigen::MatrixXd(B * X);
  for (int i = 0; i < m; ++i)
    if (sizes[i] > 0) T.row(most + i) /= sizes[i];
  const auto [sigma, V] = linalg::right_singular(T);  // T is not wide
  int found = 0;
  while (found < most && sigma[most - 1 - found] < kFree) ++found;
  return orthonormal(X * V.rightCols(found), arm, D);
}

template <FrameGroup G>
std::string describe_free_motion(const Model<G>& model, const State<G>& s,
                                 const Eigen::MatrixXd& motions) {
  const Eigen::MatrixXd ways = arms(model).asDiagonal() * motions;
  const auto of_body = [&](size_t b, int nodes) {
    return ways.middleRows(G::dim * model.first_node(static_cast<int>(b)), G::dim * nodes);
  };
  size_t body = 0;
  double most = -1;
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const double moved = of_body(b, model.bodies[b]->nodes()).norm();
    if (moved > most * (1 + kStill)) {
      most = moved;
      body = b;
    }
  }
  const int first = model.first_node(static_cast<int>(body)), points = model.bodies[body]->points();
  const bool at_points = of_body(body, points).norm() >= kStill * most;
  const int node = node_of_axis<G>(of_body(body, at_points ? points : model.bodies[body]->nodes()));
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
