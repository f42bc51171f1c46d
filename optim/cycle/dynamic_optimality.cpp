#include "optim/cycle/dynamic_optimality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace liesl {
namespace {

using Eigen::VectorXd;

constexpr double kStep = 1e-3;         // of a variable: round-off and truncation below 1e-3
constexpr double kActiveBound = 1e-4;  // of a variable's range: optimisers stop that close
constexpr double kPaid = 1e-6;         // of the largest price: what counts as none

/// A peak over time of a limited response that is near its limit.
struct Peak {
  std::string limit;
  double time = 0, g = 0;   ///< g = value/limit - 1
  VectorXd dg;              ///< by the variables
  double by_limit = 1;      ///< -dg/d(ln limit)
  ObjectiveTerm term = {};  ///< where it is no limit
};

bool is_peak(const std::vector<double>& v, std::size_t n) {
  return (n == 0 || v[n] >= v[n - 1]) && (n + 1 == v.size() || v[n] > v[n + 1]);
}

/// Or the record beside one: where two records share a peak, the optimum has it between them.
bool touches_peak(const std::vector<double>& v, std::size_t n) {
  return is_peak(v, n) || (n > 0 && is_peak(v, n - 1)) || (n + 1 < v.size() && is_peak(v, n + 1));
}

std::vector<double> values_of(const MotionGradients& motion, int r) {
  std::vector<double> v;
  for (int n = 0; n < motion.records(r); ++n) v.push_back(motion.value(r, n));
  return v;
}

/// Peaks at records, and the records beside them.
void add_peaks_of_records(const MotionGradients& motion, int r, const std::string& name,
                          double limit, double active, std::vector<Peak>& peaks) {
  const std::vector<double> v = values_of(motion, r);
  for (std::size_t n = 0; n < v.size(); ++n) {
    const int record = static_cast<int>(n);
    if (v[n] < (1 - active) * limit || !touches_peak(v, n)) continue;
    if (const VectorXd* dv = motion.gradient(r, record))
      peaks.push_back({name, motion.time(r, record), v[n] / limit - 1, *dv / limit,
                       motion.by_limit(r, record)});
  }
}

/// Peaks where the parabola through three records has its own, with the gradient there: that of the
/// largest value, whose time moves with the design.
void add_peaks_between(const MotionGradients& motion, int r, const std::string& name, double limit,
                       double active, std::vector<Peak>& peaks) {
  const std::vector<double> v = values_of(motion, r);
  for (std::size_t n = 0; n < v.size(); ++n) {
    const int record = static_cast<int>(n);
    if (v[n] < (1 - active) * limit || !is_peak(v, n)) continue;
    const VectorXd* dv = motion.gradient(r, record);
    if (!dv) continue;
    VectorXd dg = *dv / limit;
    const bool inner = n > 0 && n + 1 < v.size();
    const double bend = inner ? v[n - 1] - 2 * v[n] + v[n + 1] : 0;
    const VectorXd* before = inner ? motion.gradient(r, record - 1) : nullptr;
    const VectorXd* after = inner ? motion.gradient(r, record + 1) : nullptr;
    if (bend < 0 && before && after) {
      const double s = (v[n - 1] - v[n + 1]) / (2 * bend);  // in steps from the record
      dg = (s * (s - 1) / 2 * *before + (1 - s * s) * *dv + s * (s + 1) / 2 * *after) / limit;
    }
    peaks.push_back({name, motion.time(r, record), v[n] / limit - 1, std::move(dg),
                     motion.by_limit(r, record)});
  }
}

/// Peaks and what is not of the motion as one problem for kkt_residual; values come with the point.
class RowProblem final : public Problem {
 public:
  explicit RowProblem(std::vector<NlpVariable> variables) : variables_(std::move(variables)) {}

  void add(NlpPoint& point, const std::string& name, double g, const VectorXd& dg) {
    const auto row = point.g.size();
    constraints_.push_back({static_cast<ConstraintId>(row), name, 1});
    point.g.conservativeResize(row + 1);
    point.g[row] = g;
    point.dg.conservativeResize(row + 1, dg.size());
    point.dg.row(row) = dg;
  }
  const std::vector<NlpVariable>& variables() const override { return variables_; }
  const std::vector<NlpConstraint>& constraints() const override { return constraints_; }
  void values(const VectorXd&, double&, VectorXd&) override { refuse(); }
  void gradients(const VectorXd&, VectorXd&, RowMatrix&) override { refuse(); }

 private:
  [[noreturn]] static void refuse() { throw std::logic_error("RowProblem is not evaluated"); }
  std::vector<NlpVariable> variables_;
  std::vector<NlpConstraint> constraints_;
};

/// The bounds s_k of terms of the objective as further variables: minimise f + sum_k w_k s_k, g_j
/// <= s_k.
class TermBounds {
 public:
  TermBounds(const std::vector<ObjectiveTerm>& rows, const std::vector<Peak>& peaks) {
    for (const ObjectiveTerm& r : rows) add(r);
    for (const Peak& p : peaks) add(p.term);
  }
  int count() const { return static_cast<int>(weights_.size()); }
  void extend(std::vector<NlpVariable>& variables, NlpPoint& point) const {
    const auto n = point.x.size();
    point.x.conservativeResizeLike(VectorXd::Zero(n + count()));
    point.df.conservativeResizeLike(VectorXd::Zero(n + count()));
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const auto& [number, weight] : weights_) {
      point.df[n + place(number)] = weight;
      variables.push_back({fmt::format("term {}", number), -kInfinity, kInfinity, 0});
    }
  }
  VectorXd row(const VectorXd& dg, const ObjectiveTerm& term) const {
    VectorXd out = VectorXd::Zero(dg.size() + count());
    out.head(dg.size()) = dg;
    if (term.number >= 0) out[dg.size() + place(term.number)] = -1;
    return out;
  }

 private:
  void add(const ObjectiveTerm& r) {
    if (r.number >= 0) weights_[r.number] = r.weight;
  }
  Eigen::Index place(int number) const {
    return std::distance(weights_.begin(), weights_.find(number));
  }
  std::map<int, double> weights_;  ///< by the number of the term
};

/// What a row is a part of, and what its multiplier counts there; no name: a term of the objective.
struct Share {
  std::string limit;
  double by_limit = 1;
};

/// Sums of the multipliers of what has one name, largest first.
std::vector<LimitPrice> prices(const std::vector<Share>& shares, const KktResidual& kkt) {
  std::map<std::string, double> sum;
  double most = 0;
  for (const auto& [id, multiplier] : kkt.multipliers)
    most = std::max(most, sum[shares[id].limit] += multiplier * shares[id].by_limit);
  std::vector<LimitPrice> out;
  for (const auto& [name, price] : sum)
    if (!name.empty() && price > kPaid * most) out.push_back({name, price});
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.price > b.price; });
  return out;
}

void evaluate(const std::vector<NlpVariable>& variables, const VectorXd& x,
              const std::vector<Peak>& peaks, StaticProblem& statics, double active,
              DynamicOptimality& out) {
  const auto n = x.size(), m = static_cast<Eigen::Index>(statics.constraints().size());
  NlpPoint point{x, 0, VectorXd(0), true, VectorXd::Zero(n), RowMatrix(0, n)};
  VectorXd g(m);
  RowMatrix dg(m, n);
  statics.values(x, point.f, g);
  statics.gradients(x, point.df, dg);
  const std::vector<ObjectiveTerm> terms = statics.objective_terms();
  const TermBounds bounds(terms, peaks);
  std::vector<NlpVariable> extended = variables;
  bounds.extend(extended, point);
  RowProblem problem(extended);
  point.dg.resize(0, point.x.size());
  std::vector<Share> shares;
  for (const Peak& p : peaks) {
    shares.push_back({p.term.number >= 0 ? "" : p.limit, p.by_limit});
    problem.add(point, fmt::format("{} at t = {:.6g} s", p.limit, p.time), p.g,
                bounds.row(p.dg, p.term));
  }
  const std::vector<RowImage> image = statics.images();
  for (Eigen::Index i = 0; i < m; ++i) {
    if (image[static_cast<std::size_t>(i)].response >= 0) continue;
    const std::string& name = statics.constraints()[static_cast<std::size_t>(i)].name;
    const ObjectiveTerm term = terms.empty() ? ObjectiveTerm() : terms[static_cast<std::size_t>(i)];
    shares.push_back({term.number >= 0 ? "" : name});
    problem.add(point, name, g[i], bounds.row(dg.row(i), term));
  }
  KktOptions options;
  options.active = active;
  options.active_bound = kActiveBound;
  out.residual = kkt_residual(problem, point, options);
  out.prices = prices(shares, *out.residual);
}

/// Of all limited responses, by the names of their limits.
struct MotionPeaks {
  std::vector<Peak> between, records;
};

/// @param active share of a limit that a peak may be below it
MotionPeaks peaks_of(const StudySpec& study, const MotionGradients& motion, double active) {
  MotionPeaks out;
  for (int r = 0; r < motion.responses(); ++r) {
    const std::string name = limit_name(study, motion.response(r));
    const double limit = limit_value(study, motion.response(r));
    const std::size_t before[] = {out.between.size(), out.records.size()};
    add_peaks_between(motion, r, name, limit, active, out.between);
    add_peaks_of_records(motion, r, name, limit, active, out.records);
    if (motion.response(r).part_limit >= 0) continue;
    const int c = motion.response(r).constraint;
    const ConstraintSpec& spec = study.constraints[static_cast<std::size_t>(c)];
    if (!(spec.weight > 0)) continue;
    const ObjectiveTerm term{c, spec.weight * spec.limit};
    for (std::size_t k = before[0]; k < out.between.size(); ++k) out.between[k].term = term;
    for (std::size_t k = before[1]; k < out.records.size(); ++k) out.records[k].term = term;
  }
  return out;
}

/// Peaks of limits, and rows that are not of the motion, as far as they are exceeded by t within
/// `active`.
void add_exceeded(const std::vector<Peak>& peaks, const std::vector<NlpVariable>& variables,
                  const VectorXd& x, StaticProblem& statics, double least, std::vector<Peak>& out) {
  for (const Peak& p : peaks)
    if (p.term.number < 0 && p.g >= least) out.push_back(p);
  const auto m = static_cast<Eigen::Index>(statics.constraints().size());
  double f = 0;
  VectorXd g(m), df(static_cast<Eigen::Index>(variables.size()));
  RowMatrix dg(m, df.size());
  statics.values(x, f, g);
  statics.gradients(x, df, dg);
  const std::vector<RowImage> image = statics.images();
  const std::vector<ObjectiveTerm> terms = statics.objective_terms();
  for (Eigen::Index i = 0; i < m; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (image[row].response >= 0 || g[i] < least || (!terms.empty() && terms[row].number >= 0))
      continue;
    out.push_back({statics.constraints()[row].name, 0, g[i], dg.row(i)});
  }
}

/// The sum of the multipliers is one, by a row that outweighs the others.
ViolationCertificate stationary_violation(const std::vector<Peak>& exceeded,
                                          const std::vector<NlpVariable>& variables,
                                          const VectorXd& x, double violation) {
  constexpr double kOutweighs = 1e3;
  const RowProblem problem(variables);
  const VectorXd range = NlpScaling::of_variables(problem);
  const auto n = x.size();
  std::vector<VectorXd> columns;
  double largest = 0;
  for (const Peak& p : exceeded) {
    columns.push_back(p.dg.cwiseProduct(range));
    largest = std::max(largest, columns.back().cwiseAbs().maxCoeff());
  }
  ViolationCertificate out;
  out.violation = violation;
  if (!(largest > 0)) return out;
  for (VectorXd& c : columns) c /= largest;
  const auto limits = columns.size();
  for (Eigen::Index j = 0; j < n; ++j) {
    const NlpVariable& v = variables[static_cast<std::size_t>(j)];
    const double margin = kActiveBound * range[j];
    if (x[j] - v.lower <= margin) columns.push_back(-VectorXd::Unit(n, j));
    if (v.upper - x[j] <= margin) columns.push_back(VectorXd::Unit(n, j));
  }
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 1, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    A.col(static_cast<Eigen::Index>(k)) << columns[k], k < limits ? kOutweighs : 0;
  const VectorXd z = nonnegative_least_squares(A, kOutweighs * VectorXd::Unit(n + 1, n));
  const double sum = z.head(static_cast<Eigen::Index>(limits)).sum();
  if (!(sum > 0)) return out;
  const VectorXd r = A.topRows(n) * z / sum;
  int worst = 0;
  out.residual = r.cwiseAbs().maxCoeff(&worst);
  out.worst_variable = variables[static_cast<std::size_t>(worst)].name;
  out.worst_slope = r[worst];
  std::vector<Share> shares;
  KktResidual of_violation;
  for (std::size_t k = 0; k < limits; ++k) {
    shares.push_back({exceeded[k].limit});
    of_violation.multipliers[static_cast<ConstraintId>(k)] = z[static_cast<Eigen::Index>(k)] / sum;
  }
  out.held_by = prices(shares, of_violation);
  return out;
}

/// What is wrong with a neighbouring run; empty: it can be compared with the design's.
template <FrameGroup G>
std::string not_comparable(const DesignRun<G>& run, const std::vector<double>& times) {
  if (!run.good()) return "the simulation of a neighbouring design failed: " + run.reason();
  if (run.times() != times)
    return "the simulations of neighbouring designs have other time steps; use a fixed step that "
           "is not halved";
  return "";
}

}  // namespace

std::string DynamicOptimality::brief() const {
  if (!residual) return reason;
  if (holds()) return fmt::format("residual {:.2g}", residual->stationarity);
  return fmt::format("residual {:.2g}, '{}' should {}", residual->stationarity,
                     residual->worst_variable, residual->worst_slope < 0 ? "grow" : "shrink");
}

bool ViolationCertificate::stationary() const { return residual <= kOptimalResidual; }

std::string ViolationCertificate::brief() const {
  if (!stationary() && worst_variable.empty())
    return fmt::format("not shown to be a stationary point of the violation (residual {:.2g})",
                       residual);
  if (!stationary())
    return fmt::format(
        "not shown to be a stationary point of the violation (residual {:.2g}, '{}' should {})",
        residual, worst_variable, worst_slope < 0 ? "grow" : "shrink");
  std::string names;
  for (const LimitPrice& p : held_by)
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", p.name);
  return fmt::format("a stationary point of the violation (residual {:.2g}), held by {}", residual,
                     names);
}

DynamicOptimality check_optimality(const StudySpec& study,
                                   const std::vector<NlpVariable>& variables, const VectorXd& x,
                                   const MotionGradients& motion, StaticProblem& statics,
                                   double active) {
  DynamicOptimality out;
  out.reason = motion.reason();
  if (!out.reason.empty()) return out;
  MotionPeaks peaks = peaks_of(study, motion, active);
  evaluate(variables, x, peaks.between, statics, active, out);
  if (out.holds()) return out;
  DynamicOptimality at_records;
  evaluate(variables, x, peaks.records, statics, active, at_records);
  return at_records.residual->stationarity < out.residual->stationarity ? at_records : out;
}

ViolationCertificate check_violation(const StudySpec& study,
                                     const std::vector<NlpVariable>& variables, const VectorXd& x,
                                     const MotionGradients& motion, StaticProblem& statics,
                                     double violation, double active) {
  const double least = (1 + violation) * (1 - active) - 1;
  const MotionPeaks peaks = peaks_of(study, motion, -least);
  ViolationCertificate best;
  best.violation = violation;
  for (const auto* of : {&peaks.between, &peaks.records}) {
    std::vector<Peak> exceeded;
    add_exceeded(*of, variables, x, statics, least, exceeded);
    auto found = stationary_violation(exceeded, variables, x, violation);
    if (found.residual < best.residual) best = std::move(found);
  }
  return best;
}

template <FrameGroup G>
DynamicOptimality check_optimality_by_differences(const DesignSimulator<G>& simulator,
                                                  const DesignRun<G>& at, const VectorXd& x,
                                                  StaticProblem& statics, double active,
                                                  const Progress& progress) {
  DynamicOptimality out;
  const std::vector<double> times = at.times();
  std::vector<Peak> peaks;
  std::vector<std::size_t> record, limit_of;  // by peak
  for (std::size_t c = 0; c < at.limits.size(); ++c) {
    const auto& v = at.limits[c].values;
    for (std::size_t n = 0; n < v.size(); ++n) {
      if (v[n] < (1 - active) * at.limits[c].limit || !is_peak(v, n)) continue;
      peaks.push_back(
          {at.limits[c].name, times[n], v[n] / at.limits[c].limit - 1, VectorXd::Zero(x.size())});
      limit_of.push_back(c);
      record.push_back(n);
    }
  }
  const std::vector<NlpVariable>& variables = simulator.design().variables();
  const VectorXd unit = simulator.design().unit(x);
  for (int j = 0; j < x.size(); ++j) {
    const double step = kStep * (unit.size() > 0 ? unit[j] : x[j]);
    double place[2] = {x[j], x[j]};  // below, above
    std::vector<double> g[2];
    for (const int side : {0, 1}) {
      for (const Peak& p : peaks) g[side].push_back(p.g);
      VectorXd moved = x;
      moved[j] += side ? step : -step;
      if (moved[j] < variables[j].lower || moved[j] > variables[j].upper) continue;
      const DesignRun<G> run = simulator.run(moved, progress);
      ++out.simulations;
      out.reason = not_comparable(run, times);
      if (!out.reason.empty()) return out;
      place[side] = moved[j];
      for (std::size_t i = 0; i < peaks.size(); ++i) {
        const LimitSeries& series = run.limits[limit_of[i]];
        g[side][i] = series.values[record[i]] / series.limit - 1;
      }
    }
    if (place[1] == place[0]) continue;  // a variable without room has no say
    for (std::size_t i = 0; i < peaks.size(); ++i)
      peaks[i].dg[j] = (g[1][i] - g[0][i]) / (place[1] - place[0]);
  }
  evaluate(variables, x, peaks, statics, active, out);
  return out;
}

template DynamicOptimality check_optimality_by_differences(const DesignSimulator<SE2>&,
                                                           const DesignRun<SE2>&, const VectorXd&,
                                                           StaticProblem&, double, const Progress&);
template DynamicOptimality check_optimality_by_differences(const DesignSimulator<SE3>&,
                                                           const DesignRun<SE3>&, const VectorXd&,
                                                           StaticProblem&, double, const Progress&);

}  // namespace liesl
