#include "optim/cycle/motion_task.hpp"

#include <fmt/format.h>

#include "mbs/system/response_value.hpp"

namespace liesl {

template <FrameGroup G>
SolidTask motion_task(const StudySpec& study, const DesignSimulator<G>& simulator,
                      const DesignRun<G>& run) {
  SolidTask task = solid_task(study, *simulator.part());
  const SolidLoadSet& loads = run.solid_loads.front();
  task.loads = loads.shapes;
  task.mix = loads.e;
  for (const double t : loads.t) task.cases.push_back(fmt::format("t = {:.6g} s", t));

  const ResponseValues<G> values(run.mechanism, *run.model);
  State<G> s = run.model->initial_state();
  task.measured.resize(task.outputs.cols(), loads.e.cols());
  for (int n = 0; n < loads.e.cols(); ++n) {
    run.simulation.trajectory.read(n, s);
    int first = 0;
    for (const ConstraintSpec& c : study.constraints) {
      const Eigen::VectorXd v = values(c.response, s);
      task.measured.col(n).segment(first, v.size()) = v;
      first += static_cast<int>(v.size());
    }
  }
  return task;
}

template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE2>&,
                               const DesignRun<SE2>&);
template SolidTask motion_task(const StudySpec&, const DesignSimulator<SE3>&,
                               const DesignRun<SE3>&);

}  // namespace liesl
