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

/// Largest |Omega x d|: what spins about d is not pulled along it.
template <FrameGroup G>
double turn_across(const VectorXd& d, const MatrixXd& omega) {
  if constexpr (G::rotation_dim == 1)
    return omega.cwiseAbs().maxCoeff();
  else
    return (omega - d * (d.transpose() * omega)).colwise().norm().maxCoeff();
}

/// Largest compression and tension over the Euler load.
template <FrameGroup G>
void measure_pull(const SolidBody<G>& body, const MatrixXd& e, const MatrixXd& omega,
                  PartRange& range) {
  constexpr int sd = G::space_dim, dim = G::dim;
  const G &first = body.reference[0], &second = body.reference[1];
  const MatrixXd K = body.reduced_stiffness().topLeftCorner(dim, dim);
  const double euler = euler_load(first, second, K.inverse().topLeftCorner(sd, sd));
  if (euler == 0) return;
  const Eigen::Matrix<double, sd, 1> span = second.x - first.x;
  const VectorXd d = first.R.transpose() * span.normalized();
  const VectorXd pull = d.transpose() * (K * e.topRows(dim)).topRows(sd);
  range.euler = std::max(0., -pull.minCoeff() / euler);
  const double spin = turn_across<G>(d, omega),
               centrifugal = body.total_mass() * spin * spin * span.norm() / 6;
  range.pull = std::max(0., (pull.maxCoeff() + centrifugal) / euler);
}

/// Turn and spin of a part of one interface, whose coordinates are amplitudes alone.
template <FrameGroup G>
void measure_blade(const SolidBody<G>& body, const MatrixXd& e, const MatrixXd& omega,
                   PartRange& range) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  const int n = body.modes();
  if (n == 0) return;
  const MatrixXd& M = body.mass().dense;
  const MatrixXd J = M.block(sd, sd, rd, rd);
  const double r2 = J.trace() / (rd == 1 ? 1 : 2),
               most = linalg::symmetric_eigenvalues(J).maxCoeff();
  const VectorXd spun = omega.cwiseProduct(J * omega).colwise().sum();
  if (most > 0) range.spin = spun.maxCoeff() / most / body.omega2().minCoeff();
  const MatrixXd u = e.topRows(n);
  const VectorXd u2 = u.cwiseProduct(M.block(dim, dim, n, n) * u).colwise().sum();
  if (r2 > 0) range.bend = kEndTurn * std::sqrt(std::max(0., u2.maxCoeff()) / r2);
}

template <FrameGroup G>
struct MeasuredBeam {
  int index;  ///< of the body
  const ModalBody<G>* body;
  double euler;
};

/// Euler load from the softness of the end, held at the start. @pre it has amplitudes
template <FrameGroup G>
double euler_load(const ModalBody<G>& body) {
  const int last = body.nodes() - 1;
  const Eigen::Index n = body.basis().cols() - body.padding();
  const MatrixXd end = body.basis().block(G::dim * last, 0, G::space_dim, n);
  const MatrixXd C =
      end * linalg::LDLT(body.reduced_stiffness().topLeftCorner(n, n)).solve(end.transpose());
  return euler_load(body.reference[0], body.reference[last], C);
}

/// Widens the range by one record.
template <FrameGroup G>
void measure_beam(const MeasuredBeam<G>& beam, const BodyState<G>& state, PartRange& range) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  const VectorXd u = beam.body->displacements(state.H);
  for (int k = 1; k < beam.body->nodes(); ++k)
    range.bend = std::max(range.bend, u.segment(dim * k + sd, rd).norm());
  for (int e = 0; beam.euler > 0 && e < beam.body->elements(); ++e) {
    const double N = beam.body->section_force(state, e, ElementPlace::Middle)[0];
    range.euler = std::max(range.euler, -N / beam.euler);
    range.pull = std::max(range.pull, N / beam.euler);
  }
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
PartRange part_range(const SolidBody<G>& body, const MatrixXd& e, const MatrixXd& omega) {
  constexpr int sd = G::space_dim, rd = G::rotation_dim, dim = G::dim;
  PartRange range;
  if (e.cols() == 0) return range;
  for (int i = 0; i + 1 < body.points(); ++i)
    range.bend = std::max(range.bend, e.middleRows(dim * i + sd, rd).colwise().norm().maxCoeff());
  if (body.points() == 2) measure_pull(body, e, omega, range);
  if (body.points() == 1) measure_blade(body, e, omega, range);
  return range;
}

template <FrameGroup G>
std::map<int, PartRange> beam_ranges(const Mechanism& mechanism, const Model<G>& model,
                                     const Trajectory<G>& trajectory) {
  std::map<int, PartRange> ranges;
  std::vector<MeasuredBeam<G>> beams;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    const auto* beam = std::get_if<BeamSpec>(&mechanism.bodies[b].kind);
    if (!beam || model_of(*beam, mechanism.formalism) != BeamModel::Modal) continue;
    const auto* body = static_cast<const ModalBody<G>*>(model.bodies.at(b).get());
    if (body->basis().cols() == body->padding()) continue;
    beams.push_back({static_cast<int>(b), body, euler_load(*body)});
  }
  if (beams.empty()) return ranges;
  State<G> s = model.initial_state();
  for (int record = 0; record < trajectory.size(); ++record) {
    trajectory.read(record, s);
    model.complete(s);
    for (const MeasuredBeam<G>& beam : beams)
      measure_beam(beam, model.body_state(s, beam.index), ranges[beam.index]);
  }
  return ranges;
}

std::vector<std::string> range_warnings(const std::string& part, int interfaces,
                                        const PartRange& range) {
  return passed("the part '" + part + "'", range, interfaces > 1 ? " between its interfaces" : "",
                "divide it into several parts in a row",
                "divide it into several parts in a row, or use a beam");
}

std::vector<std::string> beam_range_warnings(const BodySpec& body, Formalism formalism,
                                             const PartRange& range) {
  BeamSpec plain = std::get<BeamSpec>(body.kind);
  std::string other;  // what makes it a beam that is not linear
  if (plain.as != BeamModel::AsFormalism)
    other = fmt::format("leave out bodies.{}.beam.as", body.name);
  plain.as = BeamModel::AsFormalism;
  if (const BeamModel left = model_of(plain, formalism);
      left == BeamModel::Modal || left == BeamModel::Rigid)
    other += std::string(other.empty() ? "" : " and ") + "use formalism se3";
  const std::string remedy = "divide it into several beams in a row, or " + other;
  return passed("the beam '" + body.name + "' in a floating frame", range, "", remedy.c_str(),
                remedy.c_str());
}

template PartRange part_range(const SolidBody<SE2>&, const MatrixXd&, const MatrixXd&);
template PartRange part_range(const SolidBody<SE3>&, const MatrixXd&, const MatrixXd&);
template std::map<int, PartRange> beam_ranges(const Mechanism&, const Model<SE2>&,
                                              const Trajectory<SE2>&);
template std::map<int, PartRange> beam_ranges(const Mechanism&, const Model<SE3>&,
                                              const Trajectory<SE3>&);

}  // namespace liesl
