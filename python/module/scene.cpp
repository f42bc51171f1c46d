#include <pybind11/stl.h>

#include "apps/cli/terminal.hpp"
#include "apps/input/rewrite.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/sensitivity.hpp"
#include "python/module/job.hpp"
#include "python/module/outcome.hpp"

namespace liesl::python {
namespace {

/// A scene that was read, and its text. Of one that is no file, its own problems have no
/// lines, those of meshes do.
class SceneInput : public std::enable_shared_from_this<SceneInput> {
 public:
  SceneInput(const std::string& text, const std::string& file,
             const std::vector<std::string>& changes)
      : text_{text, file.empty() ? kNoFile : file, changes},
        scene_(placed([&] { return read_scene(text_.text, text_.file, text_.changes); })) {}

  const SceneText& text() const { return text_; }
  bool is_file() const { return text_.file != kNoFile; }
  const std::vector<std::string>& warnings() const { return scene_.warnings; }
  /// The scene with its changes written into it.
  std::string rewritten() const { return rewrite_scene(text_.text, text_.changes); }

  std::shared_ptr<Outcome> run() const {
    return run_job([self = shared_from_this()](const Stop& stop) -> std::shared_ptr<Outcome> {
      const Stopwatch clock;
      RunOutcome out = run_task(self->scene_, choose_space(self->scene_), stop.progress());
      out.summary.overrides = self->text_.changes;
      if (self->is_file()) out.summary.more["input"] = self->text_.file;
      out.summary.wall_s = clock.seconds();
      return std::make_shared<RunResult>(std::move(out));
    });
  }

  /// Simulates to differentiate by keys.
  std::shared_ptr<MotionResult> differentiable(const std::vector<std::string>& by) const {
    return run_job([self = shared_from_this(), by](const Stop& stop) {
      SensitivityProblem problem = self->placed([&] { return scene_problem(self->text_, by); });
      const ChosenSpace space = choose_space(problem.scene);
      return std::make_shared<MotionResult>(
          std::make_unique<DifferentiableMotion>(std::move(problem), space, stop.progress()));
    });
  }

 private:
  static constexpr const char* kNoFile = "Scene";

  template <class Read>
  std::invoke_result_t<Read> placed(const Read& read) const try {
    return read();
  } catch (InputError& error) {
    if (is_file()) throw;
    for (InputProblem& problem : error.problems)
      if (problem.file == kNoFile) problem.line = problem.column = 0;
    throw InputError(error.problems);
  }
  SceneText text_;
  Scene scene_;
};

}  // namespace

void bind_scenes(py::module_& module) {
  using Texts = std::vector<std::string>;
  py::class_<SceneInput, std::shared_ptr<SceneInput>>(module, "Scene")
      .def(py::init<const std::string&, const std::string&, const Texts&>())
      .def("warnings", &SceneInput::warnings)
      .def("rewritten", &SceneInput::rewritten)
      .def("run", &SceneInput::run)
      .def("differentiable", &SceneInput::differentiable);
}

}  // namespace liesl::python
