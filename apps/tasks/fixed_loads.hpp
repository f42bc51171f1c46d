#pragma once
/// @file
/// What a study of fixed loads does to its part, for whoever looks at the result.

#include "apps/output/summary.hpp"
#include "mbs/model/mechanism.hpp"
#include "optim/study/study.hpp"

namespace liesl {

/// The keys `supports` and `fixed_loads`: where the part is held and what acts on it, with some
/// points of each place that are material. @param part number of the body  @param body as it ends
void describe_fixed_loads(output::OptimizeSummary& summary, const StudySpec& study, int part,
                          const BodySpec& body);

}  // namespace liesl
