#include "optim/design/design.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "optim/study/study_errors.hpp"

namespace liesl {

/// A group behind those that there are.
template <class Group, class... Arguments>
Group& Design::add(Arguments&&... arguments) {
  auto made = std::make_unique<Group>(std::forward<Arguments>(arguments)...);
  Group& group = *made;
  groups_.push_back({std::move(made), static_cast<int>(variables_.size())});
  variables_.insert(variables_.end(), group.variables().begin(), group.variables().end());
  units_.insert(units_.end(), group.units().begin(), group.units().end());
  return group;
}

Design::Design(const StudySpec& study, const Mechanism& mechanism) {
  sizing_ = &add<Sizing>(checked(study, mechanism).design, mechanism);
  for (const auto& [body, spec] : study.shapes) {
    parts_.push_back(&add<PartShape>(mechanism, body, spec));
    first_.push_back(groups_.back().first);
  }
  const int duration = add<Constants>(study, mechanism).duration();
  if (duration >= 0) duration_ = groups_.back().first + duration;
}

Eigen::VectorXd Design::start() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(variables_.size()));
  for (int i = 0; i < x.size(); ++i) x[i] = variables_[i].start;
  return x;
}

Eigen::VectorXd Design::unit(const Eigen::VectorXd& x) const {
  const auto by_range = [](const Share& s) { return s.group->measured_by_range(); };
  if (std::none_of(groups_.begin(), groups_.end(), by_range)) return {};
  Eigen::VectorXd unit = x;
  for (const Share& s : groups_)
    for (int i = 0; by_range(s) && i < s.group->size(); ++i)
      unit[s.first + i] = range_of(s.group->variables()[static_cast<std::size_t>(i)]);
  return unit;
}

std::vector<Parameter> Design::parameters(const Mechanism& designed,
                                          const Eigen::VectorXd& x) const {
  std::vector<Parameter> all;
  for (const Share& s : groups_) {
    std::vector<Parameter> own = s.group->parameters(designed, s.of(x));
    std::move(own.begin(), own.end(), std::back_inserter(all));
  }
  return all;
}

void Design::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  for (const Share& s : groups_) s.group->apply(s.of(x), mechanism);
}

SimulationOptions Design::simulation(SimulationOptions options, const Eigen::VectorXd& x) const {
  for (const Share& s : groups_) options = s.group->simulation(std::move(options), s.of(x));
  return options;
}

}  // namespace liesl
