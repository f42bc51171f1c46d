#include "apps/tasks/error_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/solvers/richardson.hpp"

namespace liesl {
namespace {

constexpr double kHalf = 0.5;  // an observed order this close to the expected one is it

}  // namespace

ErrorEstimate estimate_error(const Refinement& r, double order, double resolution) {
  const double fine = std::abs(r.finer - r.given);
  const auto by_order = [fine](double p) { return error_of_coarser(fine, p); };
  ErrorEstimate e{by_order(order), r.given < r.finer};
  if (!r.coarser || fine <= resolution) return e;
  const double coarse = std::abs(*r.coarser - r.given);
  if (coarse <= resolution) return e;
  e.observed = observed_order(coarse, fine);
  e.as_expected = std::abs(*e.observed - order) <= kHalf;
  if (e.as_expected) return e;
  if (*e.observed < kLeastOrder)
    e.error = std::max(coarse, e.error);
  else
    e.error = by_order(std::min(order, *e.observed));
  return e;
}

}  // namespace liesl
