#pragma once
/// @file
/// Which parts of the designs a search for sizes of catalogues looks at, and what it has proven.

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "optim/cycle/cycle_rules.hpp"

namespace liesl {

/// A part of the designs: bounds of the variables, and where a search in it starts.
struct DesignBox {
  Eigen::VectorXd lower, upper, start;
  std::string branch;  ///< what it is cut off by: "diameter <= 0.012"; empty: nothing
};

/// A variable that takes values of a catalogue; without values: any within its bounds.
struct CatalogueVariable {
  std::string name;
  std::vector<double> values;  ///< increasing
};

/// How the optimisation within a box ended, with all sizes between the values of catalogues
/// allowed.
struct BoxAnswer {
  Eigen::VectorXd x;     ///< its best design; empty: none could be simulated
  double objective = 0;  ///< of x
  bool feasible = false;
  /// Optimal, so that the objective bounds those of all designs of the box; or no design near was
  /// feasible. Both are local: of the best optimum of the box only if there is one alone.
  bool closed = false;
};

/// The answer that the cycles of a box tell.
/// @param feasibility allowed relative violation of a limit
BoxAnswer box_answer(const History& history, double feasibility);

/// Branch and bound (Land, Doig 1960, Econometrica 28; Dakin 1965, Comput. J. 8) over boxes whose
/// continuous optima are found by others: `next`, then `tell`, until there is no next. The
/// continuous optimum of a box bounds every design of catalogues in it from below, as far as it is
/// the best one of its box. Boxes are looked at in the order of their bounds; a box is left out
/// when its bound is within `gap` of the best design found. First come the continuous optimum and
/// the catalogue designs around it.
class CatalogueTree {
 public:
  /// @param gap relative, >= 0: a design this near to the least objective possible will do
  /// @throws std::invalid_argument where a variable has no value in the box
  CatalogueTree(std::vector<CatalogueVariable> variables, const DesignBox& all, double gap);

  /// The box to be searched; none: the best design is proven to be within the gap, or that no
  /// design is feasible.
  std::optional<DesignBox> next();
  /// How the search of that box ended. @returns whether it brought the best design so far
  bool tell(const BoxAnswer& answer);

  bool found() const { return std::isfinite(best_); }
  double best() const { return best_; }  ///< objective; infinite: no design yet
  /// Objective that no design of the catalogues is below; infinite: there is no feasible design.
  double bound() const;
  /// best/bound - 1, of the size of the bound; 0: the best design is the optimum.
  double gap() const;
  int infeasible() const { return infeasible_; }  ///< boxes without a feasible design
  /// Boxes whose search did not end by its own rules: the bound of the box around them stands in.
  int undecided() const { return undecided_; }

 private:
  struct Node {
    DesignBox box;
    double bound = -std::numeric_limits<double>::infinity();
  };
  bool is_design(const DesignBox& box) const;  ///< of catalogues: no size is left to choose
  bool good_enough(double bound) const;
  void branch(const Node& node, const Eigen::VectorXd& x, double bound);
  void add(const Node& node, int variable, double lower, double upper, const Eigen::VectorXd& x,
           double bound);
  /// The designs of catalogues nearest to x, and next above it.
  void add_around(const Node& node, const Eigen::VectorXd& x, double bound);
  bool tried(const DesignBox& box) const;

  const std::vector<CatalogueVariable> variables_;
  const double gap_;
  std::vector<Node> open_;
  std::vector<Node> first_;  ///< before the open ones, the last one first
  std::optional<Node> current_;
  std::vector<Eigen::VectorXd> designs_;  ///< of catalogues that were told of, lower bounds
  bool root_ = true;                      ///< the next answer is of all designs
  double best_ = std::numeric_limits<double>::infinity();
  double unclosed_ = best_;  ///< least bound of designs of catalogues whose search did not close
  int infeasible_ = 0, undecided_ = 0;
};

}  // namespace liesl
