#ifdef LIESL_OPTIM

#include "apps/tasks/map_values.hpp"

#include <cmath>

#include "apps/tasks/optimize.hpp"
#include "apps/tasks/study_motions.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/cycle/part_model.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

template <FrameGroup G>
class MotionValues final : public StudyValues {
 public:
  MotionValues(const Study& study, const Space<G>& space)
      : spec_(study.spec), motions_(motions_of(study, space)), model_(motions_, spec_) {}

  DesignModel& model() override { return model_; }

  /// The largest over the scenarios, of frequencies the least.
  std::vector<double> of(const DesignAnalysis& analysis) const override {
    std::vector<double> out(size(), kNoValue);
    out[0] = analysis.objective;
    for (const MotionLimits& motion : dynamic_cast<const MotionAnalysis<G>&>(analysis).limits) {
      for (std::size_t c = 0; c < motion.limits.size(); ++c)
        take(out, c + 1, motion.limits[c].measure, false);
      for (const PartCheck& part : motion.parts)
        for (std::size_t l = 0; l < spec_.part_limits.size(); ++l)
          if (spec_.part_limits[l].name == part.limit.name)
            take(out, part_limits() + l, part.value.value,
                 part.limit.quantity == SolidResponse::Frequency);
      for (std::size_t f = 0; f < motion.frequencies.size(); ++f)
        take(out, frequencies() + f, motion.frequencies[f].value, true);
      for (std::size_t m = 0; m < motion.masses.size(); ++m)
        take(out, masses() + m, motion.masses[m].value, false);
    }
    return out;
  }

  std::vector<double> of(StaticProblem& problem, const VectorXd& x) const override {
    std::vector<double> out(size(), kNoValue);
    VectorXd g(static_cast<Eigen::Index>(problem.constraints().size()));
    problem.values(x, out[0], g);
    if (!problem.undefined_reason().empty()) return std::vector<double>(out.size(), kNoValue);
    const auto responses = problem.responses();
    const auto images = problem.images();
    for (std::size_t i = 0; i < images.size(); ++i) {
      const double by = g[static_cast<Eigen::Index>(i)];
      if (images[i].response < 0) {
        take_own(images[i], by, out);
        continue;
      }
      const LimitedResponse& of = responses[static_cast<std::size_t>(images[i].response)];
      if (of.constraint < 0 && of.part_limit < 0) continue;
      take(out,
           of.part_limit < 0 ? static_cast<std::size_t>(of.constraint) + 1
                             : part_limits() + static_cast<std::size_t>(of.part_limit),
           limit_value(spec_, of) * (1 + by), false);
    }
    return out;
  }

 private:
  /// The largest, or the least of all that a quantity is given.
  static void take(std::vector<double>& out, std::size_t at, double value, bool least) {
    if (!(least ? value >= out[at] : value <= out[at])) out[at] = value;
  }

  /// A row g of the design alone: v/limit - 1, of a frequency 1 - v/limit.
  void take_own(const RowImage& row, double g, std::vector<double>& out) const {
    const auto l = static_cast<std::size_t>(row.limit);
    if (row.limit < 0) return;  // a wall
    if (row.of == OwnLimits::Frequencies)
      take(out, frequencies() + l, spec_.frequencies[l].least * (1 - g), true);
    if (row.of == OwnLimits::Masses)
      take(out, masses() + l, spec_.mass_limits[l].limit * (1 + g), false);
    if (row.of != OwnLimits::Parts) return;
    const PartLimitSpec& limit = spec_.part_limits[l];
    const bool least = limit.quantity == SolidResponse::Frequency;
    take(out, part_limits() + l, limit.limit * (least ? 1 - g : 1 + g), least);
  }

  // Where they begin in the order of `quantities`.
  std::size_t part_limits() const { return 1 + spec_.constraints.size(); }
  std::size_t frequencies() const { return part_limits() + spec_.part_limits.size(); }
  std::size_t masses() const { return frequencies() + spec_.frequencies.size(); }
  std::size_t size() const { return masses() + spec_.mass_limits.size(); }

  const StudySpec& spec_;
  const std::vector<Scenario<G>> motions_;
  MotionModel<G> model_;
};

/// Under fixed loads the problem of a step is the study itself.
class PartValues final : public StudyValues {
 public:
  explicit PartValues(const Study& study)
      : part_(study.scene.mechanism, study.spec.shapes.begin()->first,
              study.spec.shapes.begin()->second),
        task_(solid_task(study.spec, part_)),
        model_(task_) {}

  DesignModel& model() override { return model_; }
  std::vector<double> of(const DesignAnalysis& analysis) const override {
    const StaticCheck& check = dynamic_cast<const PartAnalysis&>(analysis).check;
    std::vector<double> out{check.objective};
    for (std::size_t i = 0; i < task_.limits.size(); ++i) out.push_back(check.limits[i].value);
    return out;
  }
  std::vector<double> of(StaticProblem&, const VectorXd&) const override { return {}; }

 private:
  PartShape part_;
  SolidTask task_;
  PartModel model_;
};

}  // namespace

std::vector<MappedQuantity> quantities(const Study& study) {
  const Quantity objective = quantity(study.spec.objective);
  std::vector<MappedQuantity> out{{objective.name, objective.unit, {}}};
  if (!study.spec.motion_objective.only_mass()) out.front() = {"objective", "-", {}};
  if (study.spec.loads.empty()) {
    for (const ConstraintSpec& c : study.spec.constraints)
      out.push_back({c.response.name, unit(c.response, study.scene.mechanism), c.limit});
  } else {
    for (const ConstraintSpec& c : study.spec.constraints)
      if (c.has_image) out.push_back({c.response.name, "m", c.limit});
  }
  for (const PartLimitSpec& l : study.spec.part_limits)
    out.push_back({l.name, quantity(l.quantity).unit, l.limit});
  if (!study.spec.loads.empty()) return out;
  for (const FrequencyLimitSpec& f : study.spec.frequencies) out.push_back({f.name, "Hz", f.least});
  for (const MassLimitSpec& m : study.spec.mass_limits) out.push_back({m.name, "kg", m.limit});
  return out;
}

MakeValues values_of(const Study& study, const ChosenSpace& space) {
  if (!study.spec.loads.empty()) return [&study] { return std::make_unique<PartValues>(study); };
  return std::visit(
      [&study]<FrameGroup G>(const Space<G>& s) -> MakeValues {
        return [&study, s] { return std::make_unique<MotionValues<G>>(study, s); };
      },
      space.space);
}

}  // namespace liesl

#endif
