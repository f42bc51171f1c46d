#include "apps/tasks/part_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mbs/bodies/modal.hpp"
#include "mbs/linalg/dense.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBend = 0.15;    // rad
constexpr double kEuler = 0.1;    // its bending is about as much too stiff, or too soft in tension
constexpr double kEndTurn = 1.6;  // of the first mode of a cantilever, over u/r

/// Euler load of a bar that is as soft across the line to its end: C = d(end)/dF, in the axes of
/// `end`; 0 if there is none.
template <FrameGroup G>
double euler_load(const G& start, const G& end, const MatrixXd& C) {
  constexpr int sd = G::space_dim;
  const Eigen::Matrix<double, sd, 1> span = end.x - start.x;
  const double length = span.norm();
  if (length == 0) return 0;
  const VectorXd d = end.R.transpose() * span / length;
  const MatrixXd across = MatrixXd::Identity(sd, sd) - d * d.transpose();
  const double softest = linalg::symmetric_eigenvalues(across * C * across).maxCoeff();
  return softest > 0 ? M_PI * M_PI * length / (3 * softest) : 0;
}

/// Largest compression and tension over the Euler load.
template <FrameGroup G>
void measure_pull(const SolidBody<G>& body, const MatrixXd& e, double spin, PartRange& range) {
  constexpr int sd = G::space_dim, dim = G::dim;
  const G &first = body.reference[0], &second = body.reference[1];
  const MatrixXd K = body.reduced_stiffness().topLeftCorner(dim, dim);
  const double euler = euler_load(first, second, K.inverse().topLeftCorner(sd, sd));
  if (euler == 0) return;
  const Eigen::Matrix<double, sd, 1> span = second.x - first.x;
  const VectorXd d = first.R.transpose() * span.normalized();
  const VectorXd pull = d.transpose() * (K * e.topRows(dim)).topRows(sd);
  range.euler = std::max(0., -pull.minCoeff() / euler);
  const double centrifugal = body.total_mass() * spin * spin * span.norm() / 6;
  range.pull = std::max(0., (pull.maxCoeff() + centrifugal) / euler);
}

/// Turn and spin of a part of one interface, whose coordinates are amplitudes alone.
template <FrameGroup G>
void measure_blade(const SolidBody<G>& body, const MatrixXd& e, double spin, PartRange& range) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  const int n = body.modes();
  if (n == 0) return;
  range.spin = spin * spin / body.omega2().minCoeff();
  const MatrixXd& M = body.mass().dense;
  const double r2 = M.block(sd, sd, rd, rd).trace() / (rd == 1 ? 1 : 2);
  const MatrixXd u = e.topRows(n);
  const VectorXd u2 = u.cwiseProduct(M.block(dim, dim, n, n) * u).colwise().sum();
  if (r2 > 0) range.bend = kEndTurn * std::sqrt(std::max(0., u2.maxCoeff()) / r2);
}

/// What is beyond a bound, and what helps against bending and against axial forces.
std::vector<std::string> passed(const std::string& who, const PartRange& r, const char* between,
                                const char* bending, const char* axial) {
  std::vector<std::string> said;
  if (r.bend > kBend)
    said.push_back(fmt::format("{} bends by up to {:.2g} rad{}, but its deformation is linear: {}",
                               who, r.bend, between, bending));
  const auto add = [&](const std::string& how) {
    said.push_back(
        fmt::format("{} {}, but axial forces do not change how it bends: {}", who, how, axial));
  };
  if (r.euler > kEuler) add(fmt::format("carries up to {:.2g} of its Euler load", r.euler));
  if (r.pull > kEuler) add(fmt::format("is pulled by up to {:.2g} of its Euler load", r.pull));
  if (r.spin > kEuler)
    add(fmt::format("turns at up to {:.2g} of its lowest frequency", std::sqrt(r.spin)));
  return said;
}

}  // namespace

template <FrameGroup G>
PartRange part_range(const SolidBody<G>& body, const MatrixXd& e, double spin) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  PartRange range;
  if (e.cols() == 0) return range;
  for (int i = 0; i + 1 < body.points(); ++i)
    range.bend = std::max(range.bend, e.middleRows(dim * i + sd, rd).colwise().norm().maxCoeff());
  if (body.points() == 2) measure_pull(body, e, spin, range);
  if (body.points() == 1) measure_blade(body, e, spin, range);
  return range;
}

template <FrameGroup G>
PartRange beam_range(const Mechanism& mechanism, const Model<G>& model,
                     const Trajectory<G>& trajectory, int index) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  PartRange range;
  const auto* beam = std::get_if<BeamSpec>(&mechanism.bodies.at(index).kind);
  if (!beam || model_of(*beam, mechanism.formalism) != BeamModel::Modal) return range;
  const auto* body = static_cast<const ModalBody<G>*>(model.bodies.at(index).get());
  if (trajectory.size() == 0) return range;
  const auto& X = body->reference;
  const int last = body->nodes() - 1;
  const Eigen::Index n = body->basis().cols() - body->padding();
  if (n == 0) return range;
  const MatrixXd end = body->basis().block(dim * last, 0, sd, n);
  const MatrixXd C =
      end * linalg::LDLT(body->reduced_stiffness().topLeftCorner(n, n)).solve(end.transpose());
  const double euler = euler_load(X[0], X[last], C);
  State<G> s = model.initial_state();
  for (int record = 0; record < trajectory.size(); ++record) {
    trajectory.read(record, s);
    model.complete(s);
    const BodyState<G> state = model.body_state(s, index);
    const VectorXd u = body->displacements(state.H);
    for (int k = 1; k <= last; ++k)
      range.bend = std::max(range.bend, u.segment(dim * k + sd, rd).norm());
    for (int e = 0; euler > 0 && e < body->elements(); ++e) {
      const double N = body->section_force(state, e, ElementPlace::Middle)[0];
      range.euler = std::max(range.euler, -N / euler);
      range.pull = std::max(range.pull, N / euler);
    }
  }
  return range;
}

std::vector<std::string> range_warnings(const std::string& part, const PartRange& range) {
  return passed("the part '" + part + "'", range, range.spin > 0 ? "" : " between its interfaces",
                "divide it into several parts in a row",
                "divide it into several parts in a row, or use a beam");
}

std::vector<std::string> beam_range_warnings(const std::string& beam, const PartRange& range) {
  const char* const remedy = "divide it into several beams in a row, or use formalism se3";
  return passed("the beam '" + beam + "' in a floating frame", range, "", remedy, remedy);
}

template PartRange part_range(const SolidBody<SE2>&, const MatrixXd&, double);
template PartRange part_range(const SolidBody<SE3>&, const MatrixXd&, double);
template PartRange beam_range(const Mechanism&, const Model<SE2>&, const Trajectory<SE2>&, int);
template PartRange beam_range(const Mechanism&, const Model<SE3>&, const Trajectory<SE3>&, int);

}  // namespace liesl
