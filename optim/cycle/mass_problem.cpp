#include "optim/cycle/mass_problem.hpp"

#include <algorithm>

namespace liesl {
namespace {

using Eigen::VectorXd;

/// d(mass)/dp of what a part of a parameter changes; 0: no mass.
double by_part(const Mechanism& designed, const BeamDerivative& by) {
  const auto& beam = std::get<BeamSpec>(designed.bodies[std::size_t(by.body)].kind);
  double sum = 0;
  for (std::size_t e = 0; e < by.laws.size(); ++e)
    sum += by.laws[e].M(0, 0) * element_length(beam, static_cast<int>(e));
  return sum;
}
double by_part(const Mechanism&, const RigidDerivative& by) { return by.mass; }
double by_part(const Mechanism& designed, const SolidDerivative& by) {
  const auto& solid = std::get<SolidSpec>(designed.bodies[std::size_t(by.body)].kind);
  return solid_model(solid).total_mass(by.fractions);
}

struct Slope {
  const Mechanism& designed;
  const std::vector<int>& bodies;

  template <class Part>
  double operator()(const Part& part) const {
    if constexpr (requires { part.body; }) {
      const bool counts = std::find(bodies.begin(), bodies.end(), part.body) != bodies.end();
      return counts ? by_part(designed, part) : 0;
    }
    return 0;
  }
};

}  // namespace

MassProblem::MassProblem(const Mechanism& mechanism, const Design& design,
                         const std::vector<MassLimitSpec>& limits, const VectorXd& x)
    : CaselessProblem(design.variables()), mechanism_(mechanism), design_(design), limits_(limits) {
  for (Eigen::Index i = 0; i < x.size(); ++i) variables_[static_cast<std::size_t>(i)].start = x[i];
  for (const MassLimitSpec& limit : limits_)
    constraints_.push_back({static_cast<ConstraintId>(constraints_.size()), limit.name, 1});
}

void MassProblem::values(const VectorXd& x, double& f, VectorXd& g) {
  f = 0;
  const Mechanism designed = design_.apply(mechanism_, x);
  for (std::size_t i = 0; i < limits_.size(); ++i)
    g[static_cast<Eigen::Index>(i)] = mass_of(designed, limits_[i].bodies) / limits_[i].limit - 1;
}

void MassProblem::gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  const Mechanism designed = design_.apply(mechanism_, x);
  const std::vector<Parameter> parameters = design_.parameters(designed, x);
  for (std::size_t i = 0; i < limits_.size(); ++i)
    for (std::size_t j = 0; j < parameters.size(); ++j) {
      double sum = 0;
      for (const auto& part : parameters[j].parts)
        sum += std::visit(Slope{designed, limits_[i].bodies}, part);
      dg(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = sum / limits_[i].limit;
    }
}

}  // namespace liesl
