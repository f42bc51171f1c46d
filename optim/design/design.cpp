#include "optim/design/design.hpp"

#include "optim/study/study_errors.hpp"

namespace liesl {

Design::Design(const StudySpec& study, const Mechanism& mechanism)
    : sizing_(checked(study, mechanism).design, mechanism),
      constants_(study, mechanism),
      variables_(sizing_.variables()) {
  units_.assign(variables_.size(), "m");
  for (const auto& [body, spec] : study.shapes) {
    const auto& added = parts_.emplace_back(std::make_unique<PartShape>(mechanism, body, spec));
    const auto& variables = added->design.variables();
    const auto& units = added->design.units();
    first_.push_back(static_cast<int>(variables_.size()));
    variables_.insert(variables_.end(), variables.begin(), variables.end());
    units_.insert(units_.end(), units.begin(), units.end());
  }
  for (int i = 0; i < constants_.size(); ++i) {
    variables_.push_back(constants_.variables()[static_cast<std::size_t>(i)]);
    units_.push_back(constants_.unit(i));
  }
}

Eigen::VectorXd Design::start() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(variables_.size()));
  for (int i = 0; i < x.size(); ++i) x[i] = variables_[i].start;
  return x;
}

Eigen::VectorXd Design::unit(const Eigen::VectorXd& x) const {
  if (parts_.empty() && constants_.size() == 0) return {};
  Eigen::VectorXd unit = x;
  for (int i = sizing_.size(); i < x.size(); ++i)
    if (variables_[i].upper > variables_[i].lower)
      unit[i] = variables_[i].upper - variables_[i].lower;
    else
      unit[i] = 1;  // one value of a catalogue
  return unit;
}

std::vector<Parameter> Design::parameters(const Mechanism& designed,
                                          const Eigen::VectorXd& x) const {
  std::vector<Parameter> all;
  for (int i = 0; i < sizing_.size(); ++i) all.push_back(sizing_.parameter(designed, i));
  for (int k = 0; k < parts(); ++k) {
    PartShape& p = part(k);
    const Eigen::MatrixXd by = p.fraction_gradient(of_part(k, x));
    for (int j = 0; j < by.cols(); ++j)
      all.push_back({p.design.variables()[j].name, {SolidDerivative{p.body, by.col(j)}}});
  }
  for (int i = 0; i < constants_.size(); ++i)
    all.push_back(constants_.parameter(i, x.tail(constants_.size())));
  return all;
}

void Design::apply(const Eigen::VectorXd& x, Mechanism& mechanism) const {
  sizing_.apply(x, mechanism);
  for (int k = 0; k < parts(); ++k) part(k).apply(of_part(k, x), mechanism);
  constants_.apply(x.tail(constants_.size()), mechanism);
}

}  // namespace liesl
