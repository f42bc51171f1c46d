#include "mbs/solvers/modes.hpp"

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/linalg/constrained_modes.hpp"
#include "mbs/solvers/static_newton.hpp"

namespace liesl {
namespace {

constexpr double kUnsymmetric = 1e-8;  // of the tangent, worth a word

/// Block diagonal of the bodies' constant mass matrices.
template <FrameGroup G>
Eigen::SparseMatrix<double> mass_matrix(const Model<G>& model) {
  SparseAssembly assembly(model.size());
  assembly.begin();
  for (size_t b = 0; b < model.bodies.size(); ++b)
    add_body(model.bodies[b]->mass(), G::dim * model.first_node(static_cast<int>(b)), assembly);
  return assembly.finish();
}

/// Columns of the identity of the nodes' components, and of the constraints, that are unknowns:
/// those that pad the amplitudes of a body would be modes of their own, and so would the rotations
/// of nodes that are positions.
template <FrameGroup G>
Eigen::SparseMatrix<double> unknowns(const Model<G>& model, int rows) {
  std::vector<bool> real(rows, true);
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const Body<G>& body = *model.bodies[b];
    const int end = G::dim * model.first_node(static_cast<int>(b)) + body.size();
    std::fill(real.begin() + end - body.padding(), real.begin() + end, false);
  }
  for (const int k : model.positions())
    std::fill_n(real.begin() + G::dim * k + G::space_dim, G::rotation_dim, false);
  Eigen::SparseMatrix<double> chosen(rows, std::count(real.begin(), real.end(), true));
  for (int i = 0, column = 0; i < rows; ++i)
    if (real[i]) chosen.insert(i, column++) = 1;
  return chosen;
}

/// The scene as given if it is an equilibrium, else the static one. @returns false if there is
/// none.
template <FrameGroup G>
bool find_equilibrium(const Model<G>& model, const SimulationOptions& options,
                      ModesResult<G>& out) {
  State<G>& s = out.equilibrium;
  s = model.initial_state();
  s.v.setZero();
  out.start = take_pose(model, options, s);
  out.report.warnings = out.start.redundant;
  out.report.status = out.start.status;
  out.report.reason = out.start.reason;
  if (out.start.status != SolveStatus::Converged) return false;
  if (StaticNewton<G>(model, options).in_equilibrium(s, options.max_load)) {
    s.t = options.max_load;
    return true;
  }
  SimulationOptions statics = options;
  statics.arc_length = statics.critical = false;
  const StaticResult<G> found = solve_static(model, statics);
  out.report = found.report;
  if (found.report.status != SolveStatus::Converged) return false;
  found.trajectory.read(found.trajectory.size() - 1, s);
  return true;
}

}  // namespace

template <FrameGroup G>
ModesResult<G> solve_modes(const Model<G>& model, const SimulationOptions& options) {
  options.require_valid();
  ModesResult<G> out;
  if (!find_equilibrium(model, options, out)) return out;
  StaticNewton<G> newton(model, options);
  const Eigen::SparseMatrix<double> A = newton.tangent(out.equilibrium);
  const Eigen::SparseMatrix<double> skew = A - Eigen::SparseMatrix<double>(A.transpose());
  if (skew.norm() > kUnsymmetric * A.norm())
    out.report.warnings.push_back(
        "loads that follow the motion, or are spread over a beam that bends, make the tangent "
        "unsymmetric: modes are of its symmetric part");
  const Eigen::SparseMatrix<double> P = unknowns(model, static_cast<int>(A.rows())),
                                    N = unknowns(model, model.size());
  const ConstrainedModes modes = constrained_modes(
      P.transpose() * A * P, N.transpose() * mass_matrix(model) * N, options.modes);
  if (!modes.converged) {
    out.report.status = SolveStatus::Singular;
    out.report.reason =
        "the modes did not converge; is there a motion without inertia? Give every body that "
        "can turn a moment of inertia";
    return out;
  }
  out.shapes = N * modes.phi;
  out.residuals = modes.residuals;
  for (int j = 0; j < modes.lambda.size(); ++j) {
    out.eigenvalue.push_back(modes.lambda[j]);
    out.omega.push_back(std::sqrt(std::max(0.0, modes.lambda[j])));
    out.frequency.push_back(out.omega.back() / (2 * M_PI));
  }
  if (!out.eigenvalue.empty() && out.eigenvalue.front() < 0)
    out.report.warnings.push_back("the equilibrium is unstable: modes with negative omega^2");
  return out;
}

template ModesResult<SE2> solve_modes(const Model<SE2>&, const SimulationOptions&);
template ModesResult<SE3> solve_modes(const Model<SE3>&, const SimulationOptions&);

}  // namespace liesl
