#include "mbs/solvers/modes.hpp"

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
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const auto& M = model.bodies[b]->mass();
    const int first = G::dim * model.first_node(static_cast<int>(b));
    for (int k = 0; k < M.blocks(); ++k) {
      const int at = first + G::dim * k;
      assembly.add_block(at, at, M.D[k]);
      if (k + 1 == M.blocks()) continue;
      assembly.add_block(at, at + G::dim, M.U[k]);
      assembly.add_block(at + G::dim, at, M.L[k]);
    }
  }
  return assembly.finish();
}

/// The scene as given if it is an equilibrium, else the static one. @returns false if there is
/// none.
template <FrameGroup G>
bool find_equilibrium(Model<G>& model, const SimulationOptions& options, ModesResult<G>& out) {
  State<G>& s = out.equilibrium;
  s = model.initial_state();
  s.v.setZero();
  out.start = assemble(model, options.step, s);
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
  out.report.warnings.insert(out.report.warnings.begin(), out.start.redundant.begin(),
                             out.start.redundant.end());
  if (found.report.status != SolveStatus::Converged) return false;
  found.trajectory.read(found.trajectory.size() - 1, s);
  return true;
}

}  // namespace

template <FrameGroup G>
ModesResult<G> solve_modes(Model<G>& model, const SimulationOptions& options) {
  ModesResult<G> out;
  if (!find_equilibrium(model, options, out)) return out;
  StaticNewton<G> newton(model, options);
  const Eigen::SparseMatrix<double> A = newton.tangent(out.equilibrium);
  const Eigen::SparseMatrix<double> skew = A - Eigen::SparseMatrix<double>(A.transpose());
  if (skew.norm() > kUnsymmetric * A.norm())
    out.report.warnings.push_back(
        "loads that follow the motion make the tangent unsymmetric: modes are of its symmetric "
        "part");
  const ConstrainedModes modes = constrained_modes(A, mass_matrix(model), options.modes);
  if (!modes.converged) {
    out.report.status = SolveStatus::Singular;
    out.report.reason =
        "the modes did not converge; is there a motion without inertia? Give every body that "
        "can turn a moment of inertia";
    return out;
  }
  out.shapes = modes.phi;
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

template ModesResult<SE2> solve_modes(Model<SE2>&, const SimulationOptions&);
template ModesResult<SE3> solve_modes(Model<SE3>&, const SimulationOptions&);

}  // namespace liesl
