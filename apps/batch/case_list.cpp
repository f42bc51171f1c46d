#include "apps/batch/case_list.hpp"

namespace liesl {

std::vector<std::string> overrides(const CaseList& list, std::size_t row) {
  std::vector<std::string> changes;
  for (std::size_t c = 0; c < list.columns.size(); ++c)
    for (const std::string& key : list.columns[c].keys)
      changes.push_back(key + "=" + list.rows[row].values[c].text);
  return changes;
}

}  // namespace liesl
