#include "optim/cycle/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace liesl {
namespace {

constexpr double kMet = 1e-6;  // relative violation of a limit that round-off and solvers leave

/// Bounds of an entry: the next numbers of a box.
void narrow(DesignSpec& d, const DesignBox& box, Eigen::Index& j) {
  d.group_bounds.clear();
  for (int g = 0; g < d.groups; ++g, ++j) d.group_bounds.push_back({box.lower[j], box.upper[j]});
}
template <class Entry>
void narrow(Entry& v, const DesignBox& box, Eigen::Index& j) {
  v.lower = box.lower[j];
  v.upper = box.upper[j++];
}

}  // namespace

std::vector<CatalogueVariable> catalogue_variables(const StudySpec& study,
                                                   const std::vector<NlpVariable>& variables) {
  std::vector<CatalogueVariable> out;
  each_entry(study, [&](const auto& entry) {
    for (int i = 0; i < variables_of(entry); ++i)
      out.push_back({variables[out.size()].name, entry.values});
  });
  return out;
}

StudySpec without_catalogues(StudySpec study) {
  each_entry(study, [](auto& entry) { entry.values.clear(); });
  return study;
}

StudySpec with_catalogues(StudySpec study, const StudySpec& of) {
  std::map<std::string, std::vector<double>> values;
  each_entry(of, [&values](const auto& entry) { values[entry.name] = entry.values; });
  each_entry(study, [&values](auto& entry) {
    if (const auto found = values.find(entry.name); found != values.end())
      entry.values = found->second;
  });
  return study;
}

SimulationEffort effort_of(const History& round) {
  SimulationEffort sum;
  for (std::size_t c = 0; c < round.size(); ++c)
    if (c + 1 == round.size() || round[c + 1].start != round[c].start) sum += round[c].effort;
  return sum;
}

DesignBox all_designs(const std::vector<NlpVariable>& variables) {
  const auto n = static_cast<Eigen::Index>(variables.size());
  DesignBox all{Eigen::VectorXd(n), Eigen::VectorXd(n), Eigen::VectorXd(n), ""};
  for (Eigen::Index i = 0; i < n; ++i) {
    const NlpVariable& v = variables[static_cast<std::size_t>(i)];
    all.lower[i] = v.lower;
    all.upper[i] = v.upper;
    all.start[i] = v.start;
  }
  return all;
}

StudySpec within_box(StudySpec study, const DesignBox& box) {
  study = starting_at(std::move(study), box.start);
  Eigen::Index j = 0;
  each_entry(study, [&](auto& entry) { narrow(entry, box, j); });
  return study;
}

double allowed_in(const DesignBox& box, const CycleOptions& options) {
  return box.lower == box.upper ? std::min(options.feasibility, kMet) : options.feasibility;
}

namespace {

constexpr double kNegligible = 1e-6;  // a share of the objective that optimisers leave

std::string above(double share) {
  return share > kNegligible ? fmt::format("{:.3g} % above", 100 * share) : "no worse than";
}

/// What was proven, and how sure it is.
std::string verdict(const CatalogueTree& tree, const CatalogueReport& r) {
  std::string text = fmt::format(
      "the best design of the catalogues found is {} the continuous optimum, and {}{} the bound "
      "{:.7g} of all of them ({} designs in {} boxes, {} of them infeasible)",
      above(r.above_continuous), r.gap > kNegligible ? "at most " : "", above(r.gap), r.bound,
      r.designs, r.boxes, r.infeasible);
  if (tree.undecided() > 0)
    text += fmt::format(
        "; the optimisation of {} boxes did not end optimal, the bounds around them count",
        tree.undecided());
  return text + "; bounds are local optima of boxes, which may have better ones";
}

}  // namespace

void conclude(const CatalogueTree& tree, const CycleOptions& options, const LoopResult& continuous,
              const CycleEnd& stopped, bool all_of_catalogues, CatalogueReport& report,
              LoopResult& end) {
  report.found = tree.found();
  report.bound = tree.bound();
  report.gap = tree.gap();
  report.infeasible = tree.infeasible();
  report.undecided = tree.undecided();
  report.above_continuous = (tree.best() - report.continuous) / std::abs(report.continuous);
  if (continuous.optimality && continuous.optimality->residual)
    report.kkt_residual = continuous.optimality->residual->stationarity;
  const std::string why = stopped.reason.empty() ? "" : stopped.reason + "; ";
  if (!tree.found()) {
    end.status = stopped.reason.empty() ? CycleStatus::Infeasible : stopped.status;
    end.reason = why + fmt::format(
                           "no design of the catalogues was found that meets all limits{}, "
                           "where boxes are given up by their local optima; this is the "
                           "continuous optimum ({})",
                           stopped.reason.empty() ? "" : " so far", continuous.reason);
    return;
  }
  end.status = !stopped.reason.empty()                            ? stopped.status
               : report.gap > options.gap || tree.undecided() > 0 ? CycleStatus::Converged
                                                                  : continuous.status;
  end.reason = why + verdict(tree, report) + "; the continuous optimum: " + continuous.reason;
  if (!all_of_catalogues || !continuous.optimality) return;
  end.optimality = continuous.optimality;
  end.optimality->reason =
      "all sizes are of catalogues; of the continuous optimum: " + continuous.optimality->brief();
  end.optimality->residual.reset();
}

}  // namespace liesl
