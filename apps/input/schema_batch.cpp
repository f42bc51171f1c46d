/// @file
/// Table of the keys of a batch. Rows: path, type, unit, preset, range, doc, size, options, when.
#include "apps/input/schema.hpp"

namespace liesl {

// clang-format off
std::vector<Key> batch_keys() {
  return {
    {"name", Type::Text, "", "\"batch\"", kAny, "Title of the batch; without it the name of its file."},
    {"study", Type::Text, "", kOneOf, kAny, "File of a study, relative to the batch: each case is an optimisation."},
    {"scene", Type::Text, "", kOneOf, kAny, "File of a scene, relative to the batch: each case is a simulation."},
    {"table", Type::Text, "", kOptional, kAny, "CSV file of the cases, relative to the batch: a row a case, a column a key of the study or scene. A column `case` names them. Either this or `grid`."},

    {"grid", Type::Named, "", kOptional, kAny, "Axes by name; the cases are all combinations, the last axis varies fastest."},
    {"grid.*", Type::Table, "", kOptional, kAny, "One axis."},
    {"grid.*.key", Type::Texts, "", kRequired, kAny, "Key of the study or scene, as for --set, or several that share the value."},
    {"grid.*.values", Type::List, "", kRequired, kAny, "Values of the key."},

    {"limits", Type::Table, "", kOptional, kAny, "What one case may use; a case that needs more is a failed row."},
    {"limits.time", Type::Number, "s", kOptional, kPositive, "Wall time. Default: no limit."},
    {"limits.memory", Type::Number, "MB", kOptional, kPositive, "Address space of the process, of which libraries take 100 MB and linear algebra 128 MB a thread. Default: no limit."},
  };
}
// clang-format on

}  // namespace liesl
