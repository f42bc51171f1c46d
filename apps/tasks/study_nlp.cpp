#ifdef LIESL_OPTIM

#include "apps/tasks/study_nlp.hpp"

#include <limits>

#include "apps/tasks/study_motions.hpp"
#include "optim/cycle/study_program.hpp"
#include "optim/problems/esl_problem.hpp"
#include "optim/problems/mesh_statics.hpp"
#include "optim/study/study_errors.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

[[noreturn]] void refuse_start(const std::string& reason) {
  throw std::runtime_error("the start cannot be analysed: " + reason);
}

/// A meshed part under fixed loads, in all load cases.
class LoadedPart final : public Problem {
 public:
  explicit LoadedPart(const Study& study)
      : part_(study.scene.mechanism, study.spec.shapes.begin()->first,
              study.spec.shapes.begin()->second),
        task_(solid_task(study.spec, part_)),
        problem_(std::make_unique<MeshStatics>(task_), task_.cycle, part_.design.start()) {
    if (task_.weighted())
      throw std::invalid_argument(
          "the study minimises a weighted sum of largest values, which is no smooth function");
    if (!problem_.undefined_reason().empty()) refuse_start(problem_.undefined_reason());
    problem_.add_violated(part_.design.start(), -std::numeric_limits<double>::infinity());
  }

  const std::vector<NlpVariable>& variables() const override { return part_.design.variables(); }
  const std::vector<NlpConstraint>& constraints() const override { return problem_.constraints(); }
  void values(const VectorXd& x, double& f, VectorXd& g) override { problem_.values(x, f, g); }
  void gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) override {
    problem_.gradients(x, df, dg);
  }

 private:
  PartShape part_;
  SolidTask task_;
  EslProblem problem_;
};

/// The motions of a design.
template <FrameGroup G>
class MovedDesign final : public Problem {
 public:
  MovedDesign(const Study& study, const Space<G>& space)
      : scenarios_(motions_of(study, space)),
        model_(scenarios_, direct(study.spec)),
        program_(model_, study.spec.cycle.move_limit) {
    if (!program_.begin(model_.start())) refuse_start(program_.failure());
  }

  const std::vector<NlpVariable>& variables() const override { return program_.variables(); }
  const std::vector<NlpConstraint>& constraints() const override { return program_.constraints(); }
  void values(const VectorXd& x, double& f, VectorXd& g) override { program_.values(x, f, g); }
  void gradients(const VectorXd& x, VectorXd& df, RowMatrix& dg) override {
    program_.gradients(x, df, dg);
  }

 private:
  static StudySpec direct(StudySpec study) {
    study.cycle.method = CycleMethod::Direct;
    return study;
  }

  const std::vector<Scenario<G>> scenarios_;
  MotionModel<G> model_;
  StudyProgram program_;
};

}  // namespace

std::unique_ptr<Problem> study_nlp(const Study& study, const ChosenSpace& space) {
  if (!study.spec.loads.empty()) {
    checked(study.spec, study.scene.mechanism);
    return std::make_unique<LoadedPart>(study);
  }
  return std::visit(
      [&]<FrameGroup G>(const Space<G>& s) -> std::unique_ptr<Problem> {
        return std::make_unique<MovedDesign<G>>(study, s);
      },
      space.space);
}

}  // namespace liesl

#endif
