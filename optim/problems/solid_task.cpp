#include "optim/problems/solid_task.hpp"

#include <algorithm>
#include <stdexcept>

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// "big_end", "big_end:xy", "x_min:x", "inertia_relief".
void add_support(const std::string& text, const SolidModel& model, SolidSupport& support) {
  if (text == "inertia_relief") {
    support = SolidSupport::relief();
    return;
  }
  const auto colon = text.find(':');
  const std::string place = text.substr(0, colon);
  const bool plane = model.mesh().dim == 2;
  const auto& ports = model.interfaces();
  for (std::size_t k = 0; k < ports.size(); ++k)
    if (ports[k].name == place) {
      const std::string all = plane ? "xyr" : "xyzr";
      fix_port(support, model, static_cast<int>(k),
               colon == std::string::npos ? all : text.substr(colon + 1));
      return;
    }
  const auto set = model.mesh().sets.find(place);
  if (set == model.mesh().sets.end())
    throw std::invalid_argument("support '" + text + "': there is no interface or set '" + place +
                                "'");
  fix_nodes(support, model, set->second,
            colon == std::string::npos ? (plane ? "xy" : "xyz") : text.substr(colon + 1));
}

/// The outputs of a response of the motion.
MatrixXd outputs_of(const ResponseSpec& r, const SolidModel& model) {
  const int dim = model.mesh().dim;
  if (r.kind == ResponseKind::Elongation) return elongation_output(model, r.at.node, r.to.node);
  if (r.at.node == 0)
    throw std::invalid_argument("'" + r.name +
                                "': the displacement of the first interface is seen from itself");
  MatrixXd all(model.size(), dim);
  for (int i = 0; i < dim; ++i) all.col(i) = relative_output(model, 0, r.at.node, i);
  return r.axis ? MatrixXd(all * r.axis->head(dim)) : all;
}

/// Adds the fixed loads of a part, a column a case.
void add_loads(const StudySpec& study, const SolidModel& model, int body, SolidTask& task) {
  for (const FixedLoad& load : study.loads) {
    if (load.body != body) continue;
    auto at = std::find(task.cases.begin(), task.cases.end(), load.load_case);
    if (at == task.cases.end()) {
      at = task.cases.insert(at, load.load_case);
      task.loads.conservativeResize(Eigen::NoChange, task.loads.cols() + 1);
      task.loads.rightCols(1).setZero();
    }
    auto f = task.loads.col(at - task.cases.begin());
    if (load.interface < 0) {
      f += traction_load(model, load.nodes, load.traction);
      continue;
    }
    const int dim = model.mesh().dim, port = model.port(load.interface);
    f.segment(port, dim) += load.force.head(dim);
    if (dim == 2)
      f[port + 2] += load.moment[2];
    else
      f.segment<3>(port + 3) += load.moment;
  }
}

}  // namespace

SolidTask solid_task(const StudySpec& study, PartShape& part) {
  SolidTask task;
  task.design = &part.design;
  task.shape = part.shape.get();
  task.model = &part.model;
  const auto support = study.supports.find(part.body);
  for (const auto& text : support == study.supports.end()
                              ? Support{part.model.interfaces().front().name}
                              : support->second)
    add_support(text, part.model, task.support);
  task.outputs.resize(part.model.size(), 0);
  const bool moves = study.loads.empty();
  for (std::size_t i = 0; i < study.constraints.size(); ++i) {
    const ConstraintSpec& c = study.constraints[i];
    if (!c.has_image || deformed_body(c.response) != part.body) continue;
    const MatrixXd C = outputs_of(c.response, part.model);
    const auto first = task.outputs.cols();
    task.outputs.conservativeResize(Eigen::NoChange, first + C.cols());
    task.outputs.rightCols(C.cols()) = C;
    task.limits.push_back({c.response.name, SolidResponse::Output, static_cast<int>(first),
                           static_cast<int>(C.cols()), c.limit,
                           moves ? std::optional(LimitedResponse{.constraint = static_cast<int>(i),
                                                                 .response = c.response,
                                                                 .treatment = c.treatment})
                                 : std::nullopt,
                           moves ? 0 : c.weight});
  }
  for (std::size_t i = 0; i < study.part_limits.size(); ++i) {
    const PartLimitSpec& l = study.part_limits[i];
    if (l.body != part.body) continue;
    SolidLimit limit{l.name, l.quantity, 0, l.count, l.limit, {}, l.weight, static_cast<int>(i)};
    if (moves && follows_loads(l.quantity)) {
      LimitedResponse& of = limit.motion.emplace();
      of.constraint = -1;
      of.part_limit = static_cast<int>(i);
      of.response.name = l.name;
      of.response.body = l.body;
    }
    task.limits.push_back(std::move(limit));
  }
  task.objective = study.objective;
  if (!moves) task.mass_weight = study.motion_objective.mass;
  task.stress = {study.stress.p, study.stress.relaxation};
  task.cycle = study.cycle;
  task.loads.resize(part.model.size(), 0);
  add_loads(study, part.model, part.body, task);
  return task;
}

}  // namespace liesl
