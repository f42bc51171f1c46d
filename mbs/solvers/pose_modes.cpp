#include "mbs/solvers/pose_modes.hpp"

#include <algorithm>

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/linalg/constrained_modes.hpp"
#include "mbs/solvers/iteration_matrix.hpp"
#include "mbs/solvers/statics.hpp"
#include "mbs/system/constraint_rank.hpp"

namespace liesl {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Block diagonal of one matrix of each body; bodies without one are left out.
template <class Get>
Sparse of_bodies(const Model<SE3>& model, Get get) {
  SparseAssembly assembly(model.size());
  assembly.begin();
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (const BodyMatrix<6>* matrix = get(static_cast<int>(b)))
      add_body(*matrix, 6 * model.first_node(static_cast<int>(b)), assembly);
  return assembly.finish();
}

/// phi^T (d/dp of the stiffness of springs on this row) phi.
double of_springs(const Model<SE3>& model, const State<SE3>& s, const ForceDerivative& by,
                  const Eigen::VectorXd& phi) {
  double sum = 0;
  for (const auto& c : model.couplings) {
    const RelativeMotion<SE3> motion(c.a.frame(s.H), c.b.frame(s.H));
    for (const auto& row : c.rows) {
      if (row.force != by.force) continue;
      Row<SE3>::Gradient g;
      row.row.gradient(motion, g);
      double stretch = 0;
      if (c.a.body >= 0) stretch += g.head<6>().dot(c.a.J * phi.segment<6>(6 * c.a.node));
      if (c.b.body >= 0) stretch += g.tail<6>().dot(c.b.J * phi.segment<6>(6 * c.b.node));
      sum += by.stiffness * stretch * stretch;
    }
  }
  return sum;
}

/// Columns of the identity that are unknowns, those of padded amplitudes left out.
Sparse unknowns(const Model<SE3>& model, int rows) {
  std::vector<bool> real(static_cast<std::size_t>(rows), true);
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Body<SE3>& body = *model.bodies[b];
    const int end = 6 * model.first_node(static_cast<int>(b)) + body.size();
    for (int i = end - body.padding(); i < end; ++i) real[static_cast<std::size_t>(i)] = false;
  }
  Sparse chosen(rows, std::count(real.begin(), real.end(), true));
  for (int i = 0, column = 0; i < rows; ++i)
    if (real[static_cast<std::size_t>(i)]) chosen.insert(i, column++) = 1;
  return chosen;
}

}  // namespace

PoseModes pose_modes(const Model<SE3>& model, const SimulationOptions& options, double at,
                     int count) {
  PoseModes out;
  State<SE3>& s = out.pose;
  s = model.initial_state();
  s.v.setZero();
  SimulationOptions o = options;
  o.at = at;
  const InitialState start = take_pose(model, o, s);
  if (start.status != SolveStatus::Converged) {
    out.reason = start.reason;
    return out;
  }
  const LoadLevel unloaded{at, 0};
  Equations<SE3> equations(model);
  IterationMatrix<SE3> matrix(model);
  s.lambda.setZero();
  equations.evaluate(s, s.rows, unloaded);
  const Sparse A = matrix.assemble(equations, s, unloaded);
  const Sparse M =
      of_bodies(model, [&](int b) { return &model.bodies[static_cast<std::size_t>(b)]->mass(); });
  const Sparse P = unknowns(model, static_cast<int>(A.rows())), N = unknowns(model, model.size());
  const int free = mobility(model, s).free;
  const ConstrainedModes modes =
      constrained_modes(P.transpose() * A * P, N.transpose() * M * N, count + free);
  if (!modes.converged) {
    out.reason = "the frequencies did not converge; is there a motion without inertia?";
    return out;
  }
  const Eigen::MatrixXd phi = N * modes.phi;
  Eigen::Index first = 0;
  while (first < modes.lambda.size() && modes.lambda[first] <= 0) ++first;
  const Eigen::Index found = std::min<Eigen::Index>(count, modes.lambda.size() - first);
  if (found <= 0) out.reason = "no part of the mechanism vibrates";
  out.lambda = modes.lambda.segment(first, std::max<Eigen::Index>(found, 0));
  out.shapes = phi.middleCols(first, std::max<Eigen::Index>(found, 0));
  return out;
}

Eigen::VectorXd lambda_derivative(const Mechanism& mechanism, const Model<SE3>& model,
                                  const PoseModes& modes, const Parameter& parameter) {
  const ParameterResidual<SE3> by(mechanism, model, parameter);
  const Sparse K = of_bodies(
                   model, [&](int b) { return by.body(b) ? &by.body(b)->stiffness() : nullptr; }),
               M = of_bodies(model,
                             [&](int b) { return by.body(b) ? &by.body(b)->mass() : nullptr; });
  Eigen::VectorXd derivative(modes.lambda.size());
  for (Eigen::Index i = 0; i < derivative.size(); ++i) {
    const Eigen::VectorXd phi = modes.shapes.col(i);
    derivative[i] = phi.dot(K * phi) - modes.lambda[i] * phi.dot(M * phi);
    for (const auto& part : parameter.parts)
      if (const auto* force = std::get_if<ForceDerivative>(&part))
        derivative[i] += of_springs(model, modes.pose, *force, phi);
  }
  return derivative;
}

}  // namespace liesl
