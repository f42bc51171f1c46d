/// @file
/// Comparisons of methods: rows that optimise one study.
#include <fmt/format.h>

#include <algorithm>

#include "apps/compare/comparison.hpp"
#include "apps/compare/row_table.hpp"
#include "apps/input/document.hpp"
#include "apps/input/values.hpp"
#include "apps/study/load_study.hpp"

namespace liesl {
namespace {

/// What only simulations have.
void refuse_keys_of_scenes(const toml::table& root, Problems& problems) {
  for (const char* name : {"quantity", "reference", "beams", "models"})
    if (const toml::node* node = root.get(name))
      problems.add(*node, fmt::format("a study has no {}", name), "a comparison of methods",
                   fmt::format("leave '{}' out, or give a 'scene' instead of the study", name));
  for (const char* name : {"formalism", "elements", "step", "tolerance", "rho_inf", "tangent"})
    if (const toml::node* node = root["grid"].as_table()->get(name))
      problems.add(*node, fmt::format("a study has no {}", name),
                   "method, optimizer, approximation or treatment",
                   fmt::format("name it in 'vary', with key = \"simulation.{}\"", name));
}

/// The study as it is for messages; problems are said at the name of its file.
Study study_of(const toml::table& root, const Comparison& comparison, Problems& problems) {
  try {
    return load_study(comparison.rows.of, comparison.rows.set);
  } catch (const InputError& error) {
    for (InputProblem problem : error.problems) {
      if (problem.line == 0) {
        const InputPlace place = place_of(*root.get("study"));
        problem.what = problem.file + ": " + problem.what;
        problem.file = place.file, problem.line = place.line, problem.column = place.column;
      }
      problems.add(problem);
    }
  }
  problems.throw_if_any();
  return {};
}

std::vector<std::string> keys_of_axis(std::string_view name, const Study& study) {
  if (name != "treatment") return {"cycle." + std::string(name)};
  std::vector<std::string> keys;
  for (const ConstraintSpec& c : study.spec.constraints)
    keys.push_back("constraints." + c.response.name + ".treatment");
  return keys;
}

/// The plain cycle ends at one static optimum whatever load cases it begins with: it gets one row.
/// An optimiser of the motion itself has those whose number of constraints stays; "all" is its
/// "auto".
bool has_treatment(const std::string& method, const std::string& treatment) {
  if (treatment == "auto") return true;
  if (method == "direct")
    return treatment == "worst" || treatment == "functional" || treatment == "p_norm";
  return method != "esl";
}

/// An aggregate over time has no static problem of a part, so "esl1" takes the steps of "full":
/// where both are rows, those of "full" stand for both.
void leave_out_treatments(CaseList& cases) {
  const auto column = [&](const char* name) {
    return std::find_if(cases.columns.begin(), cases.columns.end(),
                        [&](const CaseColumn& c) { return c.name == name; }) -
           cases.columns.begin();
  };
  const auto method = column("method"), treatment = column("treatment"),
             end = static_cast<std::ptrdiff_t>(cases.columns.size());
  if (method == end || treatment == end) return;
  const auto value = [](const CaseList::Row& row, std::ptrdiff_t of) {
    return plain(row.values[static_cast<std::size_t>(of)].text);
  };
  const bool full = std::any_of(cases.rows.begin(), cases.rows.end(),
                                [&](const auto& row) { return value(row, method) == "full"; });
  std::erase_if(cases.rows, [&](const CaseList::Row& row) {
    const std::string of = value(row, method), treated = value(row, treatment);
    const bool aggregate = treated == "ks" || treated == "functional" || treated == "p_norm";
    return !has_treatment(of, treated) || (full && of == "esl1" && aggregate);
  });
}

/// Methods are compared on one model.
void refuse_refinement(const std::vector<Axis>& axes, Problems& problems) {
  for (const Axis& axis : axes)
    for (const std::string& key : axis.column.keys)
      if (key == "cycle.refine")
        problems.add({axis.column.place.file, axis.column.place.line, axis.column.place.column,
                      "methods are compared on one model", "an axis other than cycle.refine", ""});
}

}  // namespace

void read_methods(const toml::table& root, const std::filesystem::path& path,
                  Comparison& comparison, Problems& problems) {
  Batch& rows = comparison.rows;
  rows.optimize = true;
  rows.of = (path.parent_path() / text(root, "study")).lexically_normal();
  refuse_keys_of_scenes(root, problems);
  problems.throw_if_any();
  read_changes(root, comparison);
  const Study study = study_of(root, comparison, problems);
  if (study.scene.simulation.type != SimulationType::Dynamic || !study.spec.loads.empty())
    problems.add(*root.get("study"), "the study has no motion", "a study of a motion",
                 "under fixed loads all methods are the same");
  comparison.response = "mass";
  const std::vector<Axis> axes = axes_of(
      root, [&](std::string_view name) { return keys_of_axis(name, study); }, problems);
  refuse_refinement(axes, problems);
  problems.throw_if_any();
  rows.cases = expand(axes);
  leave_out_treatments(rows.cases);
  check_changes(root, rows, problems);
  problems.throw_if_any();
  check_cases(rows, problems);
}

}  // namespace liesl
