#pragma once
/// @file
/// The static problem of a cycle, whatever its parts are made of, and its solution.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "optim/nlp/elastic.hpp"
#include "optim/nlp/result.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// Stress or compliance of a meshed part over its motion, a function of its fractions and of its
/// coordinates e (SolidBody): dv_n/dx = own_n + by_coordinates_n . de_n/dx at record n.
struct PartSlopes {
  int body = 0;
  int first = 0;                                  ///< of the part's variables in x
  Eigen::VectorXd value;                          ///< v_n at every record
  std::map<int, Eigen::VectorXd> own;             ///< by the part's variables, where kept
  std::map<int, Eigen::VectorXd> by_coordinates;  ///< for the same records
};

/// A response of the motion that rows of a static problem are images of.
struct LimitedResponse {
  int constraint = 0;  ///< of the study; -1: of its objective, gradients are kept at every record
  ResponseSpec response;
  int scenario = 0;   ///< of the study: which motion
  double kept = 0.5;  ///< gradients are kept where it is at least this share of its largest value
  /// Whose records are rows at first and have gradients in any case; Auto: those near the largest,
  /// and none but the maxima.
  Treatment treatment = Treatment::Auto;
  /// Of the study: the limit of a meshed part itself, in place of `constraint`; -1: it is none.
  int part_limit = -1;
  std::shared_ptr<const PartSlopes> slopes = {};  ///< of a part limit; null: not asked for
};

/// What a limit is called in reports: its name, and the scenario if there are several.
std::string limit_name(const StudySpec& study, const LimitedResponse& response);
/// What it is limited to.
double limit_value(const StudySpec& study, const LimitedResponse& response);

/// Lists of a study with limits that follow from the design alone.
enum class OwnLimits { Walls, Parts, Frequencies, Masses };

/// Where a row comes from: response number `response` of the problem at a record of the motion;
/// -1: from the design alone, limit number `limit` of the list `of` (-1: a wall).
struct RowImage {
  int response = -1, record = -1;
  OwnLimits of = OwnLimits::Walls;
  int limit = -1;
};

/// A row that is no limit: the objective has `weight` times the largest g of all rows of its
/// term.
struct ObjectiveTerm {
  int number = -1;  ///< of the term; -1: the row is a limit
  double weight = 0;
};

/// Minimise a quantity of the parts subject to limits in retained load cases.
class StaticProblem : public Problem {
 public:
  /// Checks all load cases at x and adds those that violate a limit by more than `tolerance`.
  /// @returns how many were added
  virtual int add_violated(const Eigen::VectorXd& x, double tolerance) = 0;
  /// Adds rows for records of responses, by response, where it has none; none in problems that find
  /// their cases themselves. @returns how many were added
  virtual int add_records(const std::vector<std::set<int>>&) { return 0; }
  virtual int load_cases() const = 0;  ///< retained
  /// Of a problem whose load cases are the records of a motion: what its rows are images of.
  virtual std::vector<LimitedResponse> responses() const { return {}; }
  /// The same, those of meshed parts with their slopes at the analysed design.
  virtual std::vector<LimitedResponse> responses_with_slopes() { return responses(); }
  /// One a row.
  virtual std::vector<RowImage> images() const {
    return std::vector<RowImage>(constraints().size());
  }
  /// One a row; empty: all rows are limits. The value of the objective leaves these terms out.
  virtual std::vector<ObjectiveTerm> objective_terms() const { return {}; }
  /// Why the latest x has no value ("interface 'pin' is cut off ..."); empty if it has one.
  virtual std::string undefined_reason() const { return {}; }
};

/// One without load cases: of the design alone, or of values of the motion. Second derivatives are
/// zero unless a problem has its own.
class CaselessProblem : public StaticProblem {
 public:
  explicit CaselessProblem(std::vector<NlpVariable> variables) : variables_(std::move(variables)) {}

  int add_violated(const Eigen::VectorXd&, double) override { return 0; }
  int load_cases() const override { return 0; }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  HessianShape hessian_shape() const override { return HessianShape::Dense; }
  void hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&, Eigen::MatrixXd&) override {}

 protected:
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;  ///< filled by the constructors of those that have rows
};

/// By the optimiser that cycle.optimizer and cycle.model name.
NlpResult solve_by(Problem& problem, const CycleOptions& cycle, NlpOptions options,
                   const NlpWarmStart& warm = {});

/// The answer of an optimiser with all load cases met that the problem knows.
struct StaticAnswer {
  NlpResult result;    ///< of the last round
  int iterations = 0;  ///< of all rounds
};

/// Optimises with the retained cases, looks at all of them, adds those that are violated, again.
/// @param warm multipliers to start from (Ipopt only) and those at the end
/// @param keep_going asked at every iteration; null: yes
/// @param max_iterations of the optimiser in a round; the best point found is the answer
StaticAnswer solve_static(StaticProblem& problem, const CycleOptions& options, NlpWarmStart& warm,
                          const std::function<bool()>& keep_going,
                          int max_iterations = NlpOptions().max_iterations);

/// The answer of an elastic problem (optim/nlp/elastic.hpp).
struct ElasticAnswer {
  Eigen::VectorXd x;
  double violation = 0;    ///< t
  double merit = 0;        ///< w f + sigma t
  double multipliers = 0;  ///< sum of those of the constraints; 0 if the optimiser gives none
  int iterations = 0;      ///< of all rounds
  std::string reason;      ///< why there is no answer: the start has no value; empty: there is one
};

/// As solve_static, with constraints that may be exceeded at a price. A round whose start has no
/// value with the cases that were added starts where the problem does.
ElasticAnswer solve_elastic(StaticProblem& problem, ElasticProblem::Weights weights,
                            const CycleOptions& options, NlpWarmStart& warm,
                            const std::function<bool()>& keep_going);

}  // namespace liesl
