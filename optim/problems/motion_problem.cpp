#include "optim/problems/motion_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mbs/system/response_value.hpp"
#include "optim/problems/beam_statics.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/frequency_problem.hpp"
#include "optim/problems/mass_problem.hpp"
#include "optim/problems/mesh_statics.hpp"
#include "optim/problems/variables_without_statics.hpp"

namespace liesl {
namespace {

const SolidLoadSet& loads_of(const std::vector<SolidLoadSet>& sets, int body) {
  return *std::find_if(sets.begin(), sets.end(),
                       [body](const SolidLoadSet& set) { return set.body == body; });
}

}  // namespace

template <FrameGroup G>
SolidTask motion_task(const StudySpec& study, const DesignSimulator<G>& simulator, int k,
                      const DesignRun<G>& run) {
  PartShape& part = simulator.design().part(k);
  SolidTask task = solid_task(study, part);
  const SolidLoadSet& loads = loads_of(run.solid_loads, part.body);
  task.loads = loads.shapes;
  task.combination = loads.e;
  task.basis = loads.basis;
  for (const double t : loads.t) task.cases.push_back(run.instant(t));

  const ResponseValues<G> values(run.mechanism, *run.model);
  State<G> s = run.model->initial_state();
  task.measured.resize(task.outputs.cols(), loads.e.cols());
  for (int n = 0; n < loads.e.cols(); ++n) {
    run.simulation.trajectory.read(n, s);
    int first = 0;
    for (const ConstraintSpec& c : study.constraints) {
      if (!c.has_image || deformed_body(c.response) != part.body) continue;
      const Eigen::VectorXd v = values(c.response, s);
      task.measured.col(n).segment(first, v.size()) = v;
      first += static_cast<int>(v.size());
    }
  }
  return task;
}

template <FrameGroup G>
std::vector<CombinedProblem::Member> static_parts(
    const StudySpec& study, const DesignSimulator<G>& simulator, const DesignRun<G>& run,
    const Eigen::VectorXd& x, double move, const std::vector<FrequencyLimitSpec>& frequencies) {
  const Design& design = simulator.design();
  std::vector<CombinedProblem::Member> members;
  const auto add = [&](std::unique_ptr<PartStatics> parts, const Eigen::VectorXd& own,
                       double weight, int first) {
    members.push_back(
        {std::make_unique<EslProblem>(std::move(parts), study.cycle, own), weight, first});
  };
  if (const int n = design.sizing().size(); n > 0) {
    const Analysis<G> at{run.mechanism, run.model.get(), &run.simulation.trajectory, &run.loads};
    add(std::make_unique<BeamStatics<G>>(at, design.sizing(), study, move), x.head(n), 1, 0);
  }
  const double cells = study.cycle.move_cells * move / study.cycle.move_limit;
  for (int k = 0; k < design.parts(); ++k) {
    const auto counted =
        std::count(study.mass_of.begin(), study.mass_of.end(), design.part(k).body);
    add(std::make_unique<MeshStatics>(motion_task(study, simulator, k, run), cells, move),
        design.of_part(k, x), counted > 0 ? 1.0 : 0.0, design.first(k));
  }
  for (const Design::Share& s : design.groups()) {
    if (s.group->has_statics() || s.group->size() == 0) continue;
    const Eigen::VectorXd own = s.of(x);
    const Eigen::VectorXd by =
        mass_gradient(s.group->parameters(run.mechanism, own), run.mechanism, study.mass_of);
    members.push_back(
        {std::make_unique<VariablesWithoutStatics>(s.group->variables(), by, own, move), 1,
         s.first});
  }
  if (!frequencies.empty())
    members.push_back({std::make_unique<FrequencyProblem>(
                           simulator.mechanism(), design, simulator.options(), frequencies, x,
                           static_cast<int>(study.constraints.size())),
                       0, 0});
  if (!study.mass_limits.empty())
    members.push_back(
        {std::make_unique<MassProblem>(simulator.mechanism(), design, study.mass_limits, x), 0, 0});
  return members;
}

template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE2>&, int,
                               const DesignRun<SE2>&);
template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE3>&, int,
                               const DesignRun<SE3>&);
template std::vector<CombinedProblem::Member> static_parts(const StudySpec&,
                                                           const DesignSimulator<SE2>&,
                                                           const DesignRun<SE2>&,
                                                           const Eigen::VectorXd&, double,
                                                           const std::vector<FrequencyLimitSpec>&);
template std::vector<CombinedProblem::Member> static_parts(const StudySpec&,
                                                           const DesignSimulator<SE3>&,
                                                           const DesignRun<SE3>&,
                                                           const Eigen::VectorXd&, double,
                                                           const std::vector<FrequencyLimitSpec>&);

}  // namespace liesl
