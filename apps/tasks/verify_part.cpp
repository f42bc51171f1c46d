#ifdef LIESL_OPTIM

#include "apps/tasks/verify_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/input/problem.hpp"
#include "apps/tasks/error_estimate.hpp"
#include "apps/tasks/part_grids.hpp"

namespace liesl {
namespace {

using Analysis = std::shared_ptr<const PartAnalysis>;

/// The final outline of one part on other grids.
class PartVerification {
 public:
  PartVerification(OptimizeOutcome& out, const Study& study, const ReadStudy& read)
      : out_(out),
        read_(read),
        final_(out.parts.front()),
        grids_(
            part_grids({study.scene_texts.front(), study.scene.file, {}}, study.scene.mechanism)) {
    std::erase_if(grids_, [this](const PartGrid& g) { return g.name != final_.name; });
  }

  std::vector<VerifiedLimit> run() {
    const PartGrid& grid = grids_.front();
    if (grid.cells.empty())
      return not_verified(out_, of_part("its mesh is not a grid of the scene"));
    if (!grid.has_room()) return not_verified(out_, of_part("it has no room for twice its cells"));
    std::string missing;
    given_ = analysed(1, missing);
    finer_ = analysed(2, missing);
    if (!missing.empty()) return not_verified(out_, missing);
    if (!grid_changes(grids_, 0.5).empty()) coarser_ = analysed(0.5, missing);
    json_ = {{"runs", coarser_ ? 3 : 2}, {"mesh", {{"order", grid.order}}}};
    std::vector<VerifiedLimit> limits = of_limits();
    of_objective();
    out_.summary.more["verification"] = json_;
    return limits;
  }

 private:
  std::string of_part(const char* why) const {
    return fmt::format("part '{}': {}", final_.name, why);
  }

  /// @param missing takes why there is no analysis; else as it was
  Analysis analysed(double factor, std::string& missing) const {
    const auto changes = factor == 1 ? std::vector<std::string>() : grid_changes(grids_, factor);
    try {
      Study study = read_(changes);
      Mechanism& mechanism = study.scene.mechanism;
      const int body = mechanism.body(final_.name);
      std::get<SolidSpec>(mechanism.bodies[static_cast<std::size_t>(body)].kind).outline =
          final_.outline;
      PartShape part(mechanism, body, {});
      const SolidTask task = solid_task(study.spec, part);
      const auto found = PartModel(task).analyse(part.design.start(), {});
      if (found->status == SolveStatus::Converged)
        return std::dynamic_pointer_cast<const PartAnalysis>(found);
      missing = found->reason;
    } catch (const InputError& error) {
      missing = error.problems.front().what;
    } catch (const std::invalid_argument& error) {
      missing = error.what();
    }
    if (!changes.empty()) missing = changes.front() + ": " + missing;
    return nullptr;
  }

  /// Of a value of the three analyses.
  template <class Value>
  ErrorEstimate estimate(const std::string& name, const Value& value) {
    Refinement r{value(*given_), value(*finer_)};
    if (coarser_) r.coarser = value(*coarser_);
    const int order = grids_.front().order;
    const ErrorEstimate e = estimate_error(r, order, kResolution * std::abs(r.given));
    if (e.observed) json_["mesh"]["observed"][name] = *e.observed;
    if (!e.as_expected && *e.observed < kLeastOrder)
      out_.summary.warnings.push_back(
          fmt::format("{}: order {:.2g} of the mesh observed, {} expected: it does not converge "
                      "yet, and the error is the largest difference seen",
                      name, *e.observed, order));
    return e;
  }

  std::vector<VerifiedLimit> of_limits() {
    std::vector<VerifiedLimit> limits;
    for (std::size_t i = 0; i < given_->check.limits.size(); ++i) {
      const LimitCheck& limit = given_->check.limits[i];
      const auto value = [i](const PartAnalysis& a) { return a.check.limits[i].value; };
      if (limit.weight > 0) {
        auto& term = out_.summary.more["terms"][limit.name];
        term["error"] = {{"mesh", estimate("term " + limit.name, value).error}};
        continue;
      }
      auto& all = out_.summary.constraints;
      const auto figure =
          std::find_if(all.begin(), all.end(), [&](const auto& l) { return l.name == limit.name; });
      if (figure == all.end()) continue;
      limits.push_back({.name = limit.name, .violation = figure->violation});
      VerifiedLimit& verified = limits.back();
      verified.known = std::abs(limit.value - figure->max_abs_final) <= kAlike * limit.limit;
      if (!verified.known) continue;
      const ErrorEstimate e = estimate("limit " + limit.name, value);
      figure->error_mesh = e.error;
      verified.mesh = e.error / limit.limit;
      verified.mesh_order = e.observed;
    }
    return limits;
  }

  void of_objective() {
    const ErrorEstimate e =
        estimate("objective", [](const PartAnalysis& a) { return a.check.objective; });
    out_.summary.more["objective"]["error"] = {{"mesh", e.error}};
  }

  OptimizeOutcome& out_;
  const ReadStudy& read_;
  const PartOutcome& final_;
  std::vector<PartGrid> grids_;  ///< of the part alone
  Analysis given_, finer_, coarser_;
  nlohmann::ordered_json json_;
};

}  // namespace

std::vector<VerifiedLimit> verify_part(OptimizeOutcome& out, const Study& study,
                                       const ReadStudy& read) {
  return verified_limits(out, [&] { return PartVerification(out, study, read).run(); });
}

}  // namespace liesl

#endif
