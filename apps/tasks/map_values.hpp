#pragma once
/// @file
/// The objective and the limits of a study at any design, whether its loads follow from motions or
/// stay.

#include <functional>
#include <limits>
#include <memory>

#include "apps/scene/space.hpp"
#include "apps/study/study.hpp"
#include "optim/cycle/design_model.hpp"

namespace liesl {

/// A quantity that is not there.
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// What a study minimises (first) and limits.
struct MappedQuantity {
  std::string name, unit;
  std::optional<double> limit;
};

/// Values in the order of `quantities`. One for each thread: a model keeps its outline.
class StudyValues {
 public:
  virtual ~StudyValues() = default;
  virtual DesignModel& model() = 0;
  virtual std::vector<double> of(const DesignAnalysis& analysis) const = 0;
  /// Rows of a problem that approximates the study, and their objective, in the same order; NaN
  /// where it has none.
  virtual std::vector<double> of(StaticProblem& problem, const Eigen::VectorXd& x) const = 0;
};

std::vector<MappedQuantity> quantities(const Study& study);
using MakeValues = std::function<std::unique_ptr<StudyValues>()>;
MakeValues values_of(const Study& study, const ChosenSpace& space);

}  // namespace liesl
