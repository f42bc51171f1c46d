#include "esl/solid_loads.hpp"

#include <limits>
#include <stdexcept>

#include "mbs/solids/solid_statics.hpp"
#include "mbs/solvers/part_motion.hpp"

namespace liesl {

template <FrameGroup G>
SolidLoadSet extract_solid_loads(const Model<G>& model, const Trajectory<G>& trajectory,
                                 int index) {
  SolidLoadSet set;
  set.body = index;
  const auto* body = SolidBody<G>::of(*model.bodies.at(index));
  if (!body)
    throw std::invalid_argument("'" + model.bodies[index]->name + "' is no flexible meshed part");
  set.e = part_coordinates(*body, model.first_node(index), trajectory);
  set.shapes = body->loads();
  set.basis = body->basis();
  for (int n = 0; n < trajectory.size(); ++n) set.t.push_back(trajectory.time(n));
  return set;
}

double load_change(const SolidLoadSet& f, const SolidLoadSet& before) {
  double change = 0, size = 0;
  for (int n = 0; n < f.e.cols(); ++n) {
    const Eigen::VectorXd old = before.load(n);
    change += (f.load(n) - old).norm();
    size += old.norm();
  }
  if (size > 0) return change / size;
  return change > 0 ? std::numeric_limits<double>::infinity() : 0;
}

Identity check_identity(const SolidModel& model, const Eigen::VectorXd& fractions,
                        const SolidLoadSet& loads, int count) {
  Identity identity;
  const std::set<int> cases = spread_cases(loads.e, count);
  identity.cases = static_cast<int>(cases.size());
  if (cases.empty()) return identity;
  const std::vector<int> columns(cases.begin(), cases.end());
  const Eigen::MatrixXd e = loads.e(Eigen::all, columns), dynamic = loads.basis * e;
  SolidSupport support;
  fix_port(support, model, 0, model.mesh().dim == 2 ? "xyr" : "xyzr");
  SolidStatics statics(model, support, {});
  statics.set_loads(loads.shapes * e);
  const double largest = dynamic.cwiseAbs().maxCoeff();
  if (statics.solve(fractions) != SolidStatus::Solved)
    identity.linear = std::numeric_limits<double>::infinity();
  else if (largest > 0)
    identity.linear = (statics.q() - dynamic).cwiseAbs().maxCoeff() / largest;
  identity.nonlinear = identity.linear;  // the part is linear in its frame
  return identity;
}

template SolidLoadSet extract_solid_loads(const Model<SE2>&, const Trajectory<SE2>&, int);
template SolidLoadSet extract_solid_loads(const Model<SE3>&, const Trajectory<SE3>&, int);

}  // namespace liesl
