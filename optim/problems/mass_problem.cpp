#include "optim/problems/mass_problem.hpp"

#include <algorithm>

namespace liesl {
namespace {

using Eigen::VectorXd;

/// d(mass)/dp of what a part of a parameter changes; 0: no mass.
struct MassSlope {
  const Mechanism& designed;
  const std::vector<int>& bodies;

  double by(const BeamDerivative& d) const {
    const auto& beam = std::get<BeamSpec>(designed.bodies[std::size_t(d.body)].kind);
    double sum = 0;
    for (std::size_t e = 0; e < d.laws.size(); ++e)
      sum += d.laws[e].M(0, 0) * element_length(beam, static_cast<int>(e));
    return sum;
  }
  double by(const RigidDerivative& d) const { return d.mass; }
  double by(const SolidDerivative& d) const {
    const auto& solid = std::get<SolidSpec>(designed.bodies[std::size_t(d.body)].kind);
    return solid.model->total_mass(d.fractions);
  }
  double by(const SolidScale& d) const { return d.mass() * mass_of(designed, {d.body}); }

  template <class Part>
  double operator()(const Part& part) const {
    if constexpr (requires { part.body; }) {
      const bool counts = std::find(bodies.begin(), bodies.end(), part.body) != bodies.end();
      return counts ? by(part) : 0;
    }
    return 0;
  }
};

}  // namespace

VectorXd mass_gradient(const std::vector<Parameter>& parameters, const Mechanism& designed,
                       const std::vector<int>& bodies) {
  VectorXd sum = VectorXd::Zero(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t j = 0; j < parameters.size(); ++j)
    for (const auto& part : parameters[j].parts)
      sum[static_cast<Eigen::Index>(j)] += std::visit(MassSlope{designed, bodies}, part);
  return sum;
}

MassProblem::MassProblem(const Mechanism& mechanism, const Design& design,
                         const std::vector<MassLimitSpec>& limits, const VectorXd& x)
    : CaselessProblem(design.variables()), design_(design), limits_(limits), designed_(mechanism) {
  for (Eigen::Index i = 0; i < x.size(); ++i) variables_[static_cast<std::size_t>(i)].start = x[i];
  for (const MassLimitSpec& limit : limits_)
    constraints_.push_back({static_cast<ConstraintId>(constraints_.size()), limit.name, 1});
}

std::vector<RowImage> MassProblem::images() const {
  std::vector<RowImage> out;
  for (std::size_t m = 0; m < limits_.size(); ++m)
    out.push_back({-1, -1, OwnLimits::Masses, static_cast<int>(m)});
  return out;
}

void MassProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  f = 0;
  design_.apply(x, designed_);
  for (std::size_t i = 0; i < limits_.size(); ++i)
    g[static_cast<Eigen::Index>(i)] = mass_of(designed_, limits_[i].bodies) / limits_[i].limit - 1;
}

void MassProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  const std::vector<Parameter> parameters = design_.parameters(designed_, x);
  for (std::size_t i = 0; i < limits_.size(); ++i)
    dg.row(static_cast<Eigen::Index>(i)) =
        mass_gradient(parameters, designed_, limits_[i].bodies).transpose() / limits_[i].limit;
}

}  // namespace liesl
