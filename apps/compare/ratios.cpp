#include "apps/compare/ratios.hpp"

#include <algorithm>

namespace liesl {

namespace {

/// Empty if there are none.
std::optional<double> median(std::vector<double> x) {
  if (x.empty()) return std::nullopt;
  std::sort(x.begin(), x.end());
  const std::size_t half = x.size() / 2;
  return x.size() % 2 ? x[half] : 0.5 * (x[half - 1] + x[half]);
}

/// Has a row values of its own, such as the meshes of a model? They are others than those of the
/// grid, even if they read the same.
bool has_own_values(const CaseList::Row& row, std::size_t formalism) {
  for (std::size_t c = 0; c < row.values.size(); ++c)
    if (c != formalism && row.values[c].instead) return true;
  return false;
}

/// The rows of a formalism by their values in all other columns.
std::map<std::vector<std::string>, std::string> rows_of(const CaseList& runs, std::size_t column,
                                                        const std::string& formalism) {
  std::map<std::vector<std::string>, std::string> rows;
  for (const CaseList::Row& row : runs.rows) {
    if (plain(row.values[column].text) != formalism || has_own_values(row, column)) continue;
    std::vector<std::string> others;
    for (std::size_t c = 0; c < row.values.size(); ++c)
      if (c != column) others.push_back(row.values[c].text);
    rows[others] = row.name;
  }
  return rows;
}

}  // namespace

std::vector<output::FormalismRatio> formalism_ratios(const CaseList& runs, const RowTable& table) {
  const auto at = std::find_if(runs.columns.begin(), runs.columns.end(),
                               [](const CaseColumn& c) { return c.name == "formalism"; });
  if (at == runs.columns.end()) return {};
  const auto column = static_cast<std::size_t>(at - runs.columns.begin());
  std::vector<std::string> formalisms;
  for (const CaseList::Row& row : runs.rows) {
    const std::string name = plain(row.values[column].text);
    if (!std::count(formalisms.begin(), formalisms.end(), name)) formalisms.push_back(name);
  }
  std::vector<output::FormalismRatio> ratios;
  const auto first = rows_of(runs, column, formalisms[0]);
  for (std::size_t f = 1; f < formalisms.size(); ++f) {
    std::vector<double> error, time;
    bool compared = false;  // a model has meshes of its own
    for (const auto& other : rows_of(runs, column, formalisms[f])) {
      const auto same = first.find(other.first);
      if (same == first.end()) continue;
      compared = true;
      const auto ratio = [&](const char* figure, std::vector<double>& into) {
        const auto a = table.figure(other.second, figure), b = table.figure(same->second, figure);
        if (a && b && *b > 0) into.push_back(*a / *b);
      };
      ratio("error", error);
      ratio("cpu_s", time);
    }
    if (!compared) continue;
    ratios.push_back(
        {formalisms[f], formalisms[0], static_cast<int>(time.size()), median(error), median(time)});
  }
  return ratios;
}

}  // namespace liesl
