#include "apps/tasks/sensitivity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <sstream>

#include "apps/scene/load_scene.hpp"
#include "apps/study/study.hpp"
#include "apps/tasks/collect.hpp"
#include "apps/tasks/mechanism_derivative.hpp"
#include "apps/tasks/motion_gradient.hpp"
#include "apps/tasks/outline_kinks.hpp"
#include "apps/tasks/run_summary.hpp"
#include "mbs/solvers/stretched.hpp"

#ifdef LIESL_OPTIM
#include "optim/design/design.hpp"
#endif

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr const char* kWithDerivative = "a parameter with a derivative";
constexpr const char* kList = "docs/sensitivities.md lists them";
constexpr const char* kDuration = "simulation.duration";
constexpr double kDifference = 1. / 1024;  // of a number of the scene, or of 1 where it is 0

[[noreturn]] void refuse(const std::string& file, std::string what, std::string expected,
                         std::string hint) {
  throw InputError({{file, 0, 0, std::move(what), std::move(expected), std::move(hint)}});
}

void require_motion(const Scene& scene) {
  if (scene.simulation.type != SimulationType::Dynamic)
    refuse(scene.file, "sensitivities are those of a motion, this scene has none",
           "simulation.type = \"dynamic\"", "");
  if (scene.responses.empty())
    refuse(scene.file, "the scene has no responses to differentiate", "[responses]",
           "as in bend = { response = \"deflection\", of = \"rod\" }");
}

/// Numbers of a scene that change by the same amount: the end of a rod and the place of what it
/// carries.
struct Numbers {
  std::vector<std::string> keys;
  std::vector<double> values;
  std::string unit;
};

/// As number_at, with the option as the place of what is wrong with the key.
SceneNumber number_named(const SceneText& text, const std::string& key) {
  try {
    return number_at(text, key);
  } catch (const InputError& error) {
    std::vector<InputProblem> problems = error.problems;
    for (InputProblem& p : problems)
      if (p.file.starts_with("--set " + key)) p.file = "--by " + key;
    throw InputError(std::move(problems));
  }
}

/// @param keys "KEY" or "KEY+KEY"  @throws InputError as number_at, and for numbers of two units
Numbers numbers_at(const SceneText& text, const std::string& keys) {
  Numbers numbers;
  std::istringstream list(keys);
  if (keys.empty() || keys.back() == '+')
    refuse(text.file, fmt::format("--by {}: a key is missing", keys), "KEY, or KEY+KEY", "");
  for (std::string key; std::getline(list, key, '+');) {
    if (std::find(numbers.keys.begin(), numbers.keys.end(), key) != numbers.keys.end())
      refuse(text.file, fmt::format("--by {}: {} is named twice", keys, key), "each number once",
             "");
    const SceneNumber number = number_named(text, key);
    if (keys != key && (key == kDuration || numbers.keys == std::vector<std::string>{kDuration}))
      refuse(text.file,
             fmt::format("--by {}: the duration changes together with {}", keys,
                         key == kDuration ? "another number" : key),
             "the duration by itself", "a comma between parameters");
    if (!numbers.keys.empty() && number.unit != numbers.unit)
      refuse(text.file,
             fmt::format("--by {}: {} is in {}, {} in {}", keys, numbers.keys[0], numbers.unit, key,
                         number.unit),
             "numbers of one unit, which change by the same amount", "a comma between parameters");
    numbers.keys.push_back(key);
    numbers.values.push_back(number.value);
    numbers.unit = number.unit;
  }
  return numbers;
}

/// The motion in another duration, its drives stretched with it.
/// @throws InputError where something else follows time
Parameter by_duration(const Scene& scene) {
  const std::vector<std::string> others = follows_time(scene.mechanism);
  if (!others.empty())
    refuse(scene.file,
           fmt::format("--by {}: {} follows time, and not the duration", kDuration,
                       fmt::join(others, ", ")),
           "what does not follow time", "drives are stretched with the duration");
  return {kDuration, {StepDerivative{1 / scene.simulation.duration}}};
}

/// The changes, and those to the values p; a number may belong to several parameters.
std::vector<std::string> with(std::vector<std::string> changes, const std::vector<Numbers>& numbers,
                              const VectorXd& p) {
  std::map<std::string, double> values;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double by = p[static_cast<Eigen::Index>(i)] - numbers[i].values[0];
    for (std::size_t k = 0; k < numbers[i].keys.size(); ++k)
      values.try_emplace(numbers[i].keys[k], numbers[i].values[k]).first->second += by;
  }
  for (const auto& [key, value] : values) changes.push_back(fmt::format("{}={}", key, value));
  return changes;
}

/// The responses over the records.
template <FrameGroup G>
void add_histories(const TapedMotion<G>& motion, const SensitivityProblem& problem,
                   output::Sensitivities& out) {
  out.times = motion.recorded;
  out.responses = collect_responses(problem.scene.responses, motion.mechanism, motion.model,
                                    motion.simulation.trajectory);
}

/// What `run` says of such a motion: ranges of parts, strains and energy, at its records.
template <FrameGroup G>
void doubt_motion(const TapedMotion<G>& motion, const Scene& scene, SensitivityOutcome& out) {
  const Trajectory<G>& records = motion.simulation.trajectory;
  PartRanges<G> ranges(motion.mechanism, motion.model);
  ranges.add(records);
  out.status = describe_ranges(out.summary, scene.simulation, ranges, out.status);
  out.status = describe_doubts(out.summary, scene, motion.mechanism,
                               collect(scene, motion.mechanism, motion.model, records), out.status);
}

template <FrameGroup G>
void run_on(const SensitivityProblem& problem, const Space<G>& space,
            const SensitivityRequest& request, const Progress& progress, SensitivityOutcome& out) {
  SimulationOptions options = problem.scene.simulation;
  options.tolerance = std::min(options.tolerance, kSensitivityTolerance);
  const TapedMotion<G> motion(problem.scene.mechanism, space, options, problem.scene.responses,
                              progress);
  out.status = motion.simulation.report.status;
  describe(out.summary, motion.simulation.report, motion.simulation.start, motion.mechanism,
           options.type);
  out.summary.more["tolerance"] = options.tolerance;
  if (!motion.good()) return;
  out.result.parameters = problem.names;
  add_histories(motion, problem, out.result);
  for (const auto& r : out.result.responses)
    out.summary.responses.push_back(output::response_figure(r, out.result.times));
  doubt_motion(motion, problem.scene, out);
  const auto begin = std::chrono::steady_clock::now();
  const SensitivityEnd end = differentiate(motion, problem, request, out.method, out.result);
  out.summary.more["sensitivity_s"] =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (end.complete()) return;
  out.status = SolveStatus::Singular;
  out.summary.status = status_word(out.status);
  out.summary.reason = end.reason;
}

}  // namespace

VectorXd SensitivityProblem::values() const {
  VectorXd p(static_cast<Eigen::Index>(names.size()));
  for (std::size_t i = 0; i < names.size(); ++i) p[static_cast<Eigen::Index>(i)] = names[i].value;
  return p;
}

SensitivityProblem scene_problem(const SceneText& text, const std::vector<std::string>& keys) {
  const std::string& file = text.file;
  SensitivityProblem problem;
  problem.scene = read_scene(text.text, file, text.changes);
  require_motion(problem.scene);
  if (keys.empty())
    refuse(file, "by which parameters? The scene is no study", "--by KEY[,KEY]",
           "as in --by sections.rod.diameter,materials.steel.rho; a study has its variables");
  std::vector<Numbers> numbers;
  for (const std::string& key : keys) {
    numbers.push_back(numbers_at(text, key));
    problem.names.push_back({key, numbers.back().unit, numbers.back().values.at(0)});
  }
  const VectorXd p = problem.values();
  const auto named = std::find(keys.begin(), keys.end(), kDuration) - keys.begin();
  const auto stretch = [p, named](const VectorXd& at) {
    return named < p.size() ? at[named] / p[named] : 1;
  };
  problem.mechanism_at = [text, numbers, stretch](const VectorXd& at) {
    return stretched(read_scene(text.text, text.file, with(text.changes, numbers, at)).mechanism,
                     stretch(at));
  };
  problem.options_at = [options = problem.scene.simulation, stretch](const VectorXd& at) {
    return stretched(options, stretch(at));
  };
  std::vector<NearbyOutlines> nearby;
  for (int i = 0; i < p.size(); ++i) {
    const std::string& key = keys[static_cast<std::size_t>(i)];
    NearbyOutlines& latest = nearby.emplace_back();
    if (key == kDuration) {
      problem.parameters.push_back(by_duration(problem.scene));
      continue;
    }
    const auto changed = [&](double by) {
      VectorXd at = p;
      at[i] += by;
      Mechanism mechanism = problem.mechanism_at(at);
      latest = nearby_outlines(mechanism, by);
      return mechanism;
    };
    const double step = kDifference * (p[i] == 0 ? 1 : std::abs(p[i]));
    try {
      problem.parameters.push_back(
          parameter_of(key, problem.scene.mechanism, changed, step, problem.scene.simulation));
    } catch (const std::invalid_argument& error) {
      refuse(file, fmt::format("--by {}: {}", key, error.what()), kWithDerivative, kList);
    } catch (const InputError& error) {
      const InputProblem& first = error.problems.front();
      refuse(file,
             fmt::format("--by {}: values next to its own are refused: {}{}{}", key, first.what,
                         first.expected.empty() ? "" : ", not ", first.expected),
             kWithDerivative, kList);
    }
  }
  for (auto& note : kink_warnings(problem, nearby))
    problem.scene.warnings.push_back(std::move(note));
  return problem;
}

#ifdef LIESL_OPTIM

std::vector<ResponseSpec> study_responses(const Study& study, const Scene& scene) {
  std::vector<ResponseSpec> out;
  for (const ConstraintSpec& c : study.spec.constraints) out.push_back(c.response);
  for (const ResponseSpec& r : scene.responses)
    if (std::none_of(out.begin(), out.end(),
                     [&](const ResponseSpec& other) { return other.name == r.name; }))
      out.push_back(r);
  return out;
}

SensitivityProblem study_problem(const Study& study, const Scene& scene,
                                 const std::shared_ptr<const Design>& design, const VectorXd& x) {
  SensitivityProblem problem;
  problem.scene = scene;
  problem.scene.input = study.input;
  problem.scene.responses = study_responses(study, scene);
  require_motion(problem.scene);
  if (!study.spec.loads.empty())
    refuse(study.file, "sensitivities are those of a motion, this study has fixed loads",
           "a motion", "");
  for (std::size_t i = 0; i < design->variables().size(); ++i)
    problem.names.push_back(
        {design->variables()[i].name, design->units()[i], x[static_cast<Eigen::Index>(i)]});
  problem.mechanism_at = [design, mechanism = scene.mechanism](const VectorXd& p) {
    return design->apply(mechanism, p);
  };
  const auto options_at = [design, options = scene.simulation](const VectorXd& p) {
    return design->simulation(options, p);
  };
  problem.scene.simulation = options_at(x);
  problem.options_at = options_at;
  problem.scene.mechanism = problem.mechanism_at(x);
  problem.scene.mechanism.name = study.spec.name;
  problem.parameters = design->parameters(problem.scene.mechanism, x);
  return problem;
}

SensitivityProblem study_problem(const Study& study) {
  const auto design = std::make_shared<const Design>(study.spec, study.scene.mechanism);
  SensitivityProblem problem = study_problem(study, study.scene, design, design->start());
  for (auto& text : start_warnings(*design, study.scene.mechanism))
    problem.scene.warnings.push_back(std::move(text));
  return problem;
}

#else

SensitivityProblem study_problem(const Study& study) {
  refuse(study.file, "this build differentiates no studies", "a scene with --by",
         "configure with -DLIESL_OPTIM=ON");
}

#endif

SensitivityMethod faster_method(std::size_t parameters, std::size_t functionals) {
  return adjoint_is_faster(static_cast<int>(parameters), static_cast<int>(functionals))
             ? SensitivityMethod::Adjoint
             : SensitivityMethod::Direct;
}

SensitivityOutcome sensitivity_task(const SensitivityProblem& problem, const ChosenSpace& space,
                                    const SensitivityRequest& request, const Progress& progress) {
  SensitivityOutcome out;
  out.method = request.method;
  if (out.method == SensitivityMethod::Auto)
    out.method = faster_method(problem.parameters.size(),
                               problem.scene.responses.size() * request.functionals.size());
  out.summary.command = "sensitivity";
  describe(out.summary, problem.scene, space);
  out.summary.more["method"] = out.method == SensitivityMethod::Direct ? "direct" : "adjoint";
  std::visit([&](const auto& s) { run_on(problem, s, request, progress, out); }, space.space);
  auto& parameters = out.summary.more["parameters"] = nlohmann::ordered_json::object();
  for (const auto& p : problem.names) parameters[p.name] = {{"value", p.value}, {"unit", p.unit}};
  auto& gradients = out.summary.more["gradients"] = nlohmann::ordered_json::object();
  for (const auto& g : out.result.gradients) {
    auto& entry = gradients[g.response][g.functional];
    entry["value"] = g.value;
    entry["unit"] = g.unit;
    entry["at_time"] = g.at_time;
    for (std::size_t p = 0; p < problem.names.size(); ++p)
      entry["by"][problem.names[p].name] = g.by_parameter[p];
  }
  return out;
}

}  // namespace liesl
