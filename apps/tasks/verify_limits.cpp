#ifdef LIESL_OPTIM

#include "apps/tasks/verify_limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "apps/input/problem.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/tasks/final_scene.hpp"
#include "apps/tasks/run.hpp"
#include "mbs/linalg/stop_request.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {
namespace {

/// Of the largest value of a response.
bool is_peak(const ConstraintSpec& c) {
  return c.treatment != Treatment::Functional && c.treatment != Treatment::PNorm;
}

/// A term of the objective instead of a limit.
bool is_term(const ConstraintSpec& c) { return c.weight > 0; }

/// A limit, or a term of the objective, in a scenario.
struct LimitedPeak {
  const ConstraintSpec* limit;
  std::string name;
};

/// Under a name that no response of the scene has.
std::string response_name(const LimitedPeak& p) {
  return (is_term(*p.limit) ? "term " : "limit ") + p.name;
}

std::vector<LimitedPeak> peaks(const StudySpec& spec, std::size_t scenario) {
  std::vector<LimitedPeak> out;
  for (std::size_t i = 0; i < spec.constraints.size(); ++i)
    if (const ConstraintSpec& c = spec.constraints[i]; is_peak(c))
      out.push_back(
          {&c, limit_name(spec, {static_cast<int>(i), c.response, static_cast<int>(scenario)})});
  return out;
}

/// The same response of another reading of a mechanism, whose bodies and joints have the same
/// names: their numbers may be others.
ResponseSpec by_name(ResponseSpec r, const Mechanism& from, const Mechanism& to) {
  for (int* body : {&r.at.body, &r.to.body, &r.body})
    if (*body >= 0) *body = to.body(from.bodies[static_cast<std::size_t>(*body)].name);
  if (r.joint < 0) return r;
  const std::string& name = from.joints[static_cast<std::size_t>(r.joint)].name;
  const auto found = std::find_if(to.joints.begin(), to.joints.end(),
                                  [&](const JointSpec& j) { return j.name == name; });
  r.joint = static_cast<int>(found - to.joints.begin());
  return r;
}

/// Limits that are no largest value of a response of the scene.
std::vector<std::string> other_limits(const StudySpec& spec) {
  std::vector<std::string> names;
  for (const ConstraintSpec& c : spec.constraints)
    if (!is_peak(c) && !is_term(c)) names.push_back(c.response.name);
  for (const auto& f : spec.frequencies)
    if (!(f.weight > 0)) names.push_back(f.name);
  for (const auto& p : spec.part_limits)
    if (!(p.weight > 0)) names.push_back(p.name);
  return names;
}

/// Terms of the objective whose errors no run on another mesh tells.
std::vector<std::string> other_terms(const StudySpec& spec) {
  std::vector<std::string> names;
  for (const ConstraintSpec& c : spec.constraints)
    if (is_term(c) && !is_peak(c)) names.push_back(c.response.name);
  for (const auto& f : spec.frequencies)
    if (f.weight > 0) names.push_back(f.name);
  for (const auto& p : spec.part_limits)
    if (p.weight > 0) names.push_back(p.name);
  if (spec.motion_objective.effort > 0) names.emplace_back("effort");
  return names;
}

/// The final design in its scenarios, each run as a scene on finer meshes and steps.
class LimitVerification {
 public:
  LimitVerification(OptimizeOutcome& out, const Study& study, const Progress& progress)
      : out_(out), study_(study), progress_(progress) {}

  std::vector<VerifiedLimit> run() {
    for (std::size_t s = 0; s < study_.scene_texts.size(); ++s)
      if (!run_scenario(s)) return {};
    add_others();
    if (!json_.empty()) out_.summary.more["verification"] = json_;
    describe_objective();
    return std::move(limits_);
  }

 private:
  /// False: a run did not reach its end, and nothing is known.
  bool run_scenario(std::size_t s) {
    const std::vector<LimitedPeak> limits = peaks(study_.spec, s);
    if (limits.empty()) return true;
    VerifiedScene source{final_scene(out_, study_, s), "design.toml", {}, {}};
    Scene scene = read_scene(source.text, source.file, {});
    for (const LimitedPeak& p : limits) {
      source.responses.push_back(
          by_name(p.limit->response, study_.scene.mechanism, scene.mechanism));
      source.responses.back().name = response_name(p);
    }
    scene.responses = source.responses;
    RunOutcome given = run_task(scene, choose_space(scene), progress_);
    auto& warnings = out_.summary.warnings;
    if (given.status != SolveStatus::Converged) {
      not_verified(out_, given.summary.reason);
      return false;
    }
    given.summary.warnings.clear();
    joints_ = given.summary.more.contains("penalty")
                  ? given.summary.more["penalty"]["share"].get<double>()
                  : 0;
    verify(source, scene, given.summary, progress_);
    for (std::string& w : given.summary.warnings)
      if (std::find(warnings.begin(), warnings.end(), w) == warnings.end())
        warnings.push_back(std::move(w));  // of all scenarios alike: once
    const auto& verified = given.summary.more["verification"];
    if (verified.contains("mesh") && verified["mesh"].contains("left_out"))
      json_["mesh"]["left_out"] = verified["mesh"]["left_out"];
    json_["runs"] = json_.value("runs", 0) + verified["runs"].get<int>();
    for (std::size_t i = 0; i < limits.size(); ++i)
      take(limits[i], given.summary.responses[i], verified);
    return true;
  }

  /// Limits without a verification, whose errors are not known.
  void add_others() {
    const std::vector<std::string> names = other_limits(study_.spec);
    if (names.empty()) return;
    out_.summary.warnings.push_back(fmt::format(
        "not verified, being no largest value of a response: limit {}", fmt::join(names, ", ")));
    for (const auto& figure : out_.summary.constraints)
      for (const std::string& name : names)
        if (figure.name == name || figure.name.starts_with(name + " ("))
          limits_.push_back({.name = figure.name, .violation = figure.violation, .known = false});
  }

  /// Order that was observed of a limit, also into the summary.
  std::optional<double> order(const LimitedPeak& p, const char* of,
                              const nlohmann::ordered_json& verified) {
    if (!verified.contains(of) || !verified[of].contains("order")) return {};
    json_[of]["order"] = verified[of]["order"];
    const std::string name = response_name(p);
    if (!verified[of].contains("observed") || !verified[of]["observed"].contains(name)) return {};
    json_[of]["observed"][p.name] = verified[of]["observed"][name];
    return verified[of]["observed"][name].get<double>();
  }

  /// Of the terms of all scenarios the largest counts.
  void take_term(const LimitedPeak& p, const output::ResponseFigure& found,
                 const nlohmann::ordered_json& verified) {
    for (const char* of : {"mesh", "step"}) order(p, of, verified);
    TermError& term = terms_[p.limit->response.name];
    if (term.weight > 0 && term.value >= found.max_abs) return;
    const bool steps = study_.scene.simulation.type == SimulationType::Dynamic;
    const bool whole = !json_.contains("mesh") || !json_["mesh"].contains("left_out");
    term = {p.limit->weight, found.max_abs, found.error_mesh.value_or(0),
            found.error_step.value_or(0),
            found.error_mesh && whole && (found.error_step || !steps)};
  }

  /// Errors of the terms and, where those of all are known, of the objective, which weighs them.
  void describe_objective() {
    auto& more = out_.summary.more;
    std::vector<std::string> unknown = other_terms(study_.spec);
    if (terms_.empty() && unknown.empty()) return;
    double mesh = 0, step = 0;
    for (const auto& [name, term] : terms_) {
      if (!more.contains("terms")) return;
      auto& figure = more["terms"][name];
      const double value = figure["final"].get<double>();
      if (!term.known || std::abs(term.value - value) > kAlike * value) {
        unknown.push_back(name);
        continue;
      }
      figure["error"] = {{"mesh", term.mesh}, {"step", term.step}};
      mesh += term.weight * term.mesh;
      step += term.weight * term.step;
    }
    if (unknown.empty())
      more["objective"]["error"] = {{"mesh", mesh}, {"step", step}};
    else
      out_.summary.warnings.push_back(
          fmt::format("the error of the objective is not known, as that of {} is not",
                      fmt::join(unknown, ", ")));
  }

  void take(const LimitedPeak& p, const output::ResponseFigure& found,
            const nlohmann::ordered_json& verified) {
    if (is_term(*p.limit)) return take_term(p, found, verified);
    auto& all = out_.summary.constraints;
    const auto figure =
        std::find_if(all.begin(), all.end(), [&](const auto& l) { return l.name == p.name; });
    if (figure == all.end()) return;
    if (std::abs(found.max_abs - figure->max_abs_final) > kAlike * p.limit->limit) {
      out_.summary.warnings.push_back(fmt::format(
          "limit {} was not verified: the final design run as a scene has {:.6g} instead "
          "of {:.6g}",
          p.name, found.max_abs, figure->max_abs_final));
      limits_.push_back({.name = p.name, .violation = figure->violation, .known = false});
      return;
    }
    figure->error_mesh = found.error_mesh;
    figure->error_step = found.error_step;
    const bool whole = !json_.contains("mesh") || !json_["mesh"].contains("left_out"),
               steps = study_.scene.simulation.type == SimulationType::Dynamic,
               mesh = found.error_mesh && whole, step = found.error_step || !steps;
    for (const auto& [part, known] : {std::pair("mesh", mesh), std::pair("step", step)})
      if (!known)
        out_.summary.warnings.push_back(
            fmt::format("limit {}: its error by the {} is not known", p.name, part));
    limits_.push_back({p.name, figure->violation, found.error_mesh.value_or(0) / p.limit->limit,
                       found.error_step.value_or(0) / p.limit->limit, order(p, "mesh", verified),
                       order(p, "step", verified), mesh && step, joints_});
  }

  OptimizeOutcome& out_;
  const Study& study_;
  const Progress& progress_;
  /// A term of the objective in the scenario where it is largest.
  struct TermError {
    double weight = 0, value = 0, mesh = 0, step = 0;
    bool known = false;
  };

  std::vector<VerifiedLimit> limits_;
  std::map<std::string, TermError> terms_;
  double joints_ = 0;  ///< of the scenario: share by which penalties let them open
  nlohmann::ordered_json json_ = nlohmann::ordered_json::object();
};

}  // namespace

const VerifiedLimit& nearest_limit(const std::vector<VerifiedLimit>& limits) {
  return *std::max_element(limits.begin(), limits.end(),
                           [](const VerifiedLimit& a, const VerifiedLimit& b) {
                             return a.violation + a.error() < b.violation + b.error();
                           });
}

std::string VerifiedLimit::text() const {
  const auto percent = [](double share) {
    return share < 0.995 ? fmt::format("{:.2g} %", 100 * share)
                         : fmt::format("{:.0f} %", 100 * share);
  };
  return fmt::format("limit {} is known to {} only: mesh {}{}{}", name, percent(error()),
                     known || mesh > 0 ? percent(mesh) : "not known",
                     step > 0 ? ", step " + percent(step) : "",
                     joints > 0 ? ", joints that open " + percent(joints) : "");
}

std::vector<VerifiedLimit> not_verified(OptimizeOutcome& out, const std::string& why) {
  out.summary.warnings.push_back("the limits were not verified: " + why);
  return {};
}

std::vector<VerifiedLimit> verified_limits(
    OptimizeOutcome& out, const std::function<std::vector<VerifiedLimit>()>& verification) {
  std::vector<VerifiedLimit> limits;
  try {
    limits = verification();
  } catch (const InputError& error) {
    return not_verified(
        out, "the final design cannot be read as a scene: " + error.problems.front().what);
  } catch (const Stopped&) {
    stop_is_heard();
    return not_verified(out, "stopped on request");
  } catch (const std::exception& error) {
    return not_verified(out, error.what());
  }
  if (limits.empty()) return limits;
  if (const VerifiedLimit& nearest = nearest_limit(limits); nearest.known)
    out.summary.more["worst_constraint_error"] = nearest.error();
  return limits;
}

std::vector<VerifiedLimit> verify_limits(OptimizeOutcome& out, const Study& study,
                                         const Progress& progress) {
  return verified_limits(out, [&] { return LimitVerification(out, study, progress).run(); });
}

namespace {

/// What a finer mesh of these bodies is.
std::string finer_mesh(const Mechanism& mechanism) {
  bool order_2 = false, beams = false, cells = false;
  for (const BodySpec& body : mechanism.bodies) {
    if (const auto* beam = std::get_if<BeamSpec>(&body.kind)) {
      beams = true;
      order_2 = order_2 || beam->order == 2;
    }
    cells = cells || std::holds_alternative<SolidSpec>(body.kind);
  }
  const std::string more = beams && cells ? "elements or cells" : cells ? "cells" : "elements";
  return order_2 ? "beams of order = 4, or more " + more + ", make" : "more " + more + " make";
}

}  // namespace

std::string VerifiedLimit::remedy(const Mechanism& mechanism) const {
  if (mesh > step) return finer_mesh(mechanism) + " it certain";
  if (step > 0) return "a smaller step makes it certain";
  return "joints by multipliers, or a larger penalty, make it certain";
}

void warn_of_errors(const std::vector<VerifiedLimit>& limits, double feasibility,
                    const Mechanism& mechanism, const std::string& way,
                    std::vector<std::string>& warnings) {
  for (const VerifiedLimit& l : limits) {
    const std::string text = l.text();
    const bool told = std::ranges::any_of(
        warnings, [&](const std::string& w) { return w.find(text) != std::string::npos; });
    if (l.error() > feasibility && !l.certain(feasibility) && !told)
      warnings.push_back(
          fmt::format("{}; {}{}", text, l.remedy(mechanism), way.empty() ? "" : " (" + way + ")"));
  }
}

}  // namespace liesl

#endif
