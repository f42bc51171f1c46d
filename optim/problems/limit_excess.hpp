#pragma once
/// @file
/// How far a design is from its limits.

#include <string>
#include <utility>
#include <vector>

namespace liesl {

struct LimitExcess {
  std::string name;
  double excess = 0;  ///< largest |r|/limit - 1, negative inside
  std::string at;     ///< where: "t = 0.1 s", a load case; empty: everywhere
};

/// Of all limits of a design, and the worst of them.
struct LimitExcesses {
  std::vector<LimitExcess> excesses;  ///< of walls the largest one
  double worst = -1;                  ///< largest |r|/limit - 1 over all records and limits
  std::string worst_constraint;       ///< its name
  std::string worst_at;               ///< where it is

  /// A limit that is known already keeps the larger of both.
  void add(LimitExcess limit) {
    if (limit.excess > worst) {
      worst = limit.excess;
      worst_constraint = limit.name;
      worst_at = limit.at;
    }
    for (LimitExcess& known : excesses)
      if (known.name == limit.name) {
        if (limit.excess > known.excess) known = std::move(limit);
        return;
      }
    excesses.push_back(std::move(limit));
  }
};

}  // namespace liesl
