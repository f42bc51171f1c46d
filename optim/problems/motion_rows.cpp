#include "optim/problems/motion_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "mbs/model/beam_ends.hpp"
#include "optim/problems/part_outputs.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {
namespace {

using Eigen::VectorXd;

/// The records that become rows of a limit. An optimiser that is given the motion itself has the
/// same rows at every design.
std::set<int> records_of(const ConstraintSpec& limit, CycleMethod method, bool many,
                         const std::vector<int>& screened, const std::vector<double>& v) {
  if (method == CycleMethod::Direct && limit.treatment == Treatment::Auto) {
    std::set<int> every;
    for (std::size_t n = 0; n < v.size(); ++n) every.insert(every.end(), static_cast<int>(n));
    return every;
  }
  if (limit.treatment != Treatment::Auto) return treated_records(limit.treatment, v);
  if (many) return {screened.begin(), screened.end()};
  return treated_records(Treatment::Maxima, v);
}

bool joined_by_neighbours(Treatment t) {
  return t == Treatment::Auto || t == Treatment::Neighbours;
}

}  // namespace

MotionRows::MotionRows(const MotionGradients& motion, int first, int count, const StudySpec& study,
                       const std::vector<NlpVariable>& variables)
    : CaselessProblem(variables) {
  std::vector<ScreenedLimit> limits;
  ValuesByLimit values;
  std::vector<int> of_constraint(study.constraints.size(), 0);
  for (int r = first; r < first + count; ++r) ++of_constraint[motion.response(r).constraint];
  for (int r = first; r < first + count; ++r) {
    const int c = motion.response(r).constraint;
    const ConstraintSpec& limit = study.constraints[c];
    responses_.push_back(motion.response(r));
    limits.push_back({c, 0, of_constraint[c] > 1, limit.limit});
    const bool term = limit.weight > 0;
    Series& s =
        series_.emplace_back(Series{limit.response.name,
                                    limit.limit,
                                    joined_by_neighbours(limit.treatment),
                                    ObjectiveTerm{term ? c : -1, limit.weight * limit.limit},
                                    {},
                                    {}});
    for (int n = 0; n < motion.records(r); ++n) {
      s.times.push_back(motion.time(r, n));
      s.values.push_back(motion.value(r, n));
    }
    values.push_back(s.values);
  }
  const CasesByLimit screened = near_largest(values, limits, study.cycle);
  for (int l = 0; l < count; ++l)
    for (const int n : records_of(study.constraints[limits[l].constraint], study.cycle.method,
                                  limits[l].many, screened[l], values[l]))
      add_row(l, n);
}

void MotionRows::add_row(int response, int record) {
  const Series& s = series_[static_cast<std::size_t>(response)];
  const auto n = static_cast<std::size_t>(record);
  constraints_.push_back(
      {(static_cast<ConstraintId>(response) << 32) | static_cast<ConstraintId>(n),
       fmt::format("{} at t = {:.6g} s", s.name, s.times[n]), 1});
  images_.push_back({response, record});
  terms_.push_back(s.term);
  g_.push_back(s.values[n] / s.limit - 1);
}

int MotionRows::add_records(const std::vector<std::set<int>>& records) {
  const std::size_t before = images_.size();
  for (std::size_t l = 0; l < series_.size(); ++l)
    for (const int n : records[l]) {
      if (!series_[l].joined || n >= static_cast<int>(series_[l].values.size()))
        continue;  // a motion whose steps are chosen may have had more records
      const bool there = std::ranges::any_of(images_, [&](const RowImage& i) {
        return i.response == static_cast<int>(l) && i.record == n;
      });
      if (!there) add_row(static_cast<int>(l), n);
    }
  return static_cast<int>(images_.size() - before);
}

std::vector<ObjectiveTerm> MotionRows::objective_terms() const {
  const bool any =
      std::ranges::any_of(terms_, [](const ObjectiveTerm& o) { return o.number >= 0; });
  return any ? terms_ : std::vector<ObjectiveTerm>();
}

void MotionRows::values(const VectorXd&, double& f, VectorXd& g) {
  f = 0;
  g = Eigen::Map<const VectorXd>(g_.data(), static_cast<Eigen::Index>(g_.size()));
}

void MotionRows::gradients(const VectorXd&, VectorXd& df, RowMatrix& dg) {
  df.setZero();
  dg.setZero();
}

std::vector<ResponseSpec> at_every_point(const ResponseSpec& response, const Mechanism& mechanism) {
  std::vector<ResponseSpec> out;
  const auto* beam =
      response.body < 0 ? nullptr
                        : std::get_if<BeamSpec>(&mechanism.bodies[std::size_t(response.body)].kind);
  if (!beam) return {response};
  const int elements = static_cast<int>(beam->sections.size());
  Limit at;
  if (response.kind == ResponseKind::Deflection && response.everywhere)
    for (at.node = 1; at.node < elements; ++at.node)
      out.push_back(response_of(at, response, elements));
  if (response.kind == ResponseKind::Stress && response.point < 0)
    for (at.element = 0; at.element < elements; ++at.element) {
      const auto points = element_stress_points(*beam, std::size_t(at.element));
      for (at.point = 0; at.point < static_cast<int>(points.size()); ++at.point)
        out.push_back(response_of(at, response, elements));
    }
  return out.empty() ? std::vector<ResponseSpec>{response} : out;
}

}  // namespace liesl
