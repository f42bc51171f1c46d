#include "apps/batch/case_list.hpp"

namespace liesl {

std::vector<std::string> overrides(const CaseList& list, std::size_t row) {
  std::vector<std::string> changes;
  for (std::size_t c = 0; c < list.columns.size(); ++c) {
    const CaseValue& value = list.rows[row].values[c];
    if (value.instead)
      changes.insert(changes.end(), value.instead->begin(), value.instead->end());
    else
      for (const std::string& key : list.columns[c].keys) changes.push_back(key + "=" + value.text);
  }
  return changes;
}

}  // namespace liesl
