#ifdef LIESL_OPTIM

#include "apps/tasks/part_fields.hpp"

#include <fmt/format.h>

#include "esl/solid_loads.hpp"
#include "optim/problems/mesh_statics.hpp"

namespace liesl {
namespace {

constexpr int kCases = 8;  // of a motion whose stress is looked at

}  // namespace

template <FrameGroup G>
PartFields fields_of_motion(const StudySpec& study, PartShape& part, const Eigen::VectorXd& x,
                            const Model<G>& model, const Trajectory<G>& trajectory) {
  const SolidLoadSet loads = extract_solid_loads(model, trajectory, part.body);
  const std::set<int> chosen = spread_cases(loads.e, kCases);
  SolidTask task = solid_task(study, part);
  task.loads = loads.shapes;
  task.combination = loads.e(Eigen::all, std::vector<int>(chosen.begin(), chosen.end()));
  for (const int n : chosen) task.cases.push_back(fmt::format("t = {:.6g} s", loads.t[n]));
  MeshStatics statics(task);
  if (!statics.show_all(x)) return {};
  return {statics.statics().fractions(), statics.statics().u(),
          von_mises(statics.statics(), study.stress.relaxation)};
}

template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                     const Model<SE2>&, const Trajectory<SE2>&);
template PartFields fields_of_motion(const StudySpec&, PartShape&, const Eigen::VectorXd&,
                                     const Model<SE3>&, const Trajectory<SE3>&);

}  // namespace liesl

#endif
