#include "optim/cycle/catalogue_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace liesl {

using Eigen::VectorXd;

namespace {

constexpr double kOnValue = 1e-6;  // of the distance between two values: on one of them

/// The values within [lower, upper].
std::vector<double> within(const std::vector<double>& values, double lower, double upper) {
  std::vector<double> inside;
  for (const double v : values)
    if (v >= lower && v <= upper) inside.push_back(v);
  return inside;
}

/// Largest value <= x and least value >= x, of those inside; the same where x is on one.
struct Neighbours {
  std::size_t below = 0, above = 0;
  double share = 0;  ///< of the way from one to the other

  Neighbours(const std::vector<double>& inside, double x) {
    const auto up = std::lower_bound(inside.begin(), inside.end(), x);
    above = std::min<std::size_t>(static_cast<std::size_t>(up - inside.begin()), inside.size() - 1);
    below = inside[above] > x && above > 0 ? above - 1 : above;
    if (above == below) return;
    share = (x - inside[below]) / (inside[above] - inside[below]);
    if (share < kOnValue) above = below;
    if (share > 1 - kOnValue) below = above;
    if (above == below) share = 0;
  }
  double distance() const { return std::min(share, 1 - share); }
  std::size_t nearest() const { return share > 0.5 ? above : below; }
};

}  // namespace

BoxAnswer box_answer(const History& history, double feasibility) {
  BoxAnswer out;
  if (history.empty()) return out;
  const Cycle* best = nullptr;
  const auto meets = [&](const Cycle& c) { return c.worst <= feasibility; };
  for (const Cycle& c : history) {
    const bool better = !best || (meets(c) != meets(*best) ? meets(c)
                                  : meets(c)               ? c.objective < best->objective
                                                           : c.worst < best->worst);
    if (better) best = &c;
  }
  out.x = best->x;
  out.objective = best->objective;
  out.feasible = meets(*best);
  const auto end = history.back().end;
  out.closed = end == (out.feasible ? CycleStatus::Optimal : CycleStatus::Infeasible);
  return out;
}

CatalogueTree::CatalogueTree(std::vector<CatalogueVariable> variables, const DesignBox& all,
                             double gap)
    : variables_(std::move(variables)), gap_(gap) {
  Node root{all};
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (variables_[i].values.empty()) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const auto inside = within(variables_[i].values, all.lower[j], all.upper[j]);
    if (inside.empty())
      throw std::invalid_argument(fmt::format("catalogue of '{}': no value within [{:g}, {:g}]",
                                              variables_[i].name, all.lower[j], all.upper[j]));
    root.box.lower[j] = inside.front();
    root.box.upper[j] = inside.back();
  }
  root.box.start = all.start.cwiseMax(root.box.lower).cwiseMin(root.box.upper);
  open_.push_back(std::move(root));
}

bool CatalogueTree::is_design(const DesignBox& box) const {
  for (std::size_t i = 0; i < variables_.size(); ++i)
    if (const auto j = static_cast<Eigen::Index>(i);
        !variables_[i].values.empty() && box.lower[j] < box.upper[j])
      return false;
  return true;
}

bool CatalogueTree::good_enough(double bound) const {
  return best_ <= bound + gap_ * std::abs(bound);
}

bool CatalogueTree::tried(const DesignBox& box) const {
  return is_design(box) && std::any_of(designs_.begin(), designs_.end(),
                                       [&](const VectorXd& d) { return d == box.lower; });
}

std::optional<DesignBox> CatalogueTree::next() {
  const auto take = [this](std::vector<Node>& from, std::vector<Node>::iterator at) {
    current_ = std::move(*at);
    from.erase(at);
    return current_->box;
  };
  while (!first_.empty()) {
    if (tried(first_.back().box))
      first_.pop_back();
    else
      return take(first_, first_.end() - 1);
  }
  while (!open_.empty()) {
    const auto lowest = std::min_element(
        open_.begin(), open_.end(), [](const Node& a, const Node& b) { return a.bound < b.bound; });
    if (good_enough(lowest->bound)) return {};  // so are all others
    if (!tried(lowest->box)) return take(open_, lowest);
    open_.erase(lowest);
  }
  return {};
}

bool CatalogueTree::tell(const BoxAnswer& answer) {
  const Node node = std::move(*current_);
  current_.reset();
  const bool root = root_, design = is_design(node.box);
  root_ = false;
  if (design) designs_.push_back(node.box.lower);
  const bool simulated = answer.x.size() > 0 && node.box.lower == node.box.upper;
  if (!answer.feasible && (answer.closed || simulated)) {
    ++infeasible_;
    return false;
  }
  if (design) {
    if (!answer.closed && !simulated) {
      ++undecided_;
      unclosed_ = std::min(unclosed_, node.bound);
    }
    if (!answer.feasible || !(answer.objective < best_)) return false;
    best_ = answer.objective;
    return true;
  }
  if (!answer.closed) ++undecided_;
  const double bound = answer.closed ? std::max(answer.objective, node.bound) : node.bound;
  const VectorXd& x = answer.x.size() > 0 ? answer.x : node.box.start;
  branch(node, x, bound);
  if (root) add_around(node, x, bound);
  return false;
}

/// Cuts the box between the values about x of the variable that is farthest from its values; where
/// all are on values, into that value of a variable and what lies on either side.
void CatalogueTree::branch(const Node& node, const VectorXd& x, double bound) {
  int farthest = -1;
  double most = -1;
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    const auto j = static_cast<Eigen::Index>(i);
    if (variables_[i].values.empty() || node.box.lower[j] == node.box.upper[j]) continue;
    const auto inside = within(variables_[i].values, node.box.lower[j], node.box.upper[j]);
    if (const double d = Neighbours(inside, x[j]).distance(); d > most) {
      most = d;
      farthest = static_cast<int>(i);
    }
  }
  const auto inside = within(variables_[std::size_t(farthest)].values, node.box.lower[farthest],
                             node.box.upper[farthest]);
  const Neighbours at(inside, x[farthest]);
  if (at.below != at.above) {
    add(node, farthest, inside.front(), inside[at.below], x, bound);
    add(node, farthest, inside[at.above], inside.back(), x, bound);
    return;
  }
  add(node, farthest, inside[at.below], inside[at.below], x, bound);
  if (at.below > 0) add(node, farthest, inside.front(), inside[at.below - 1], x, bound);
  if (at.above + 1 < inside.size())
    add(node, farthest, inside[at.above + 1], inside.back(), x, bound);
}

void CatalogueTree::add(const Node& node, int variable, double lower, double upper,
                        const VectorXd& x, double bound) {
  Node part{node.box, bound};
  const std::string& name = variables_[std::size_t(variable)].name;
  const bool from_below = lower == part.box.lower[variable];
  part.box.branch = lower == upper ? fmt::format("{} = {:g}", name, lower)
                    : from_below   ? fmt::format("{} <= {:g}", name, upper)
                                   : fmt::format("{} >= {:g}", name, lower);
  part.box.lower[variable] = lower;
  part.box.upper[variable] = upper;
  part.box.start = x.cwiseMax(part.box.lower).cwiseMin(part.box.upper);
  open_.push_back(std::move(part));
}

void CatalogueTree::add_around(const Node& node, const VectorXd& x, double bound) {
  Node up = node, nearest = node;
  up.bound = nearest.bound = bound;
  up.box.branch = "the next sizes above";
  nearest.box.branch = "the nearest sizes";
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (variables_[i].values.empty()) continue;
    const auto j = static_cast<Eigen::Index>(i);
    const auto inside = within(variables_[i].values, node.box.lower[j], node.box.upper[j]);
    const Neighbours at(inside, x[j]);
    up.box.lower[j] = up.box.upper[j] = inside[at.above];
    nearest.box.lower[j] = nearest.box.upper[j] = inside[at.nearest()];
  }
  for (Node* n : {&nearest, &up}) n->box.start = x.cwiseMax(n->box.lower).cwiseMin(n->box.upper);
  first_ = {nearest, up};
}

double CatalogueTree::bound() const {
  double least = std::min(best_, unclosed_);
  for (const Node& n : open_) least = std::min(least, n.bound);
  if (current_) least = std::min(least, current_->bound);
  return least;
}

double CatalogueTree::gap() const {
  const double least = bound();
  if (best_ == least) return 0;
  return least == 0 ? std::numeric_limits<double>::infinity() : (best_ - least) / std::abs(least);
}

}  // namespace liesl
