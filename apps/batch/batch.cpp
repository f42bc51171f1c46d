#include "apps/batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "apps/batch/case_table.hpp"
#include "apps/batch/grid.hpp"
#include "apps/input/document.hpp"
#include "apps/input/schema.hpp"
#include "apps/input/title.hpp"
#include "apps/input/validate.hpp"
#include "apps/output/file.hpp"
#include "apps/output/io_error.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/study/load_study.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

fs::path relative_to(const fs::path& file, const std::string& name) {
  return (file.parent_path() / name).lexically_normal();
}

/// Keys of the batch itself; what is left goes to the cases.
bool is_of_batch(const std::string& change) {
  const std::string path = change.substr(0, change.find('='));
  const std::string top = path.substr(0, path.find('.'));
  const bool whole = top == path;
  return find_key(FileKind::Batch, top) && (whole || (top != "scene" && top != "study"));
}

CaseList read_table(const toml::node& name, const fs::path& file, Problems& problems) {
  const fs::path path = relative_to(file, *name.value<std::string>());
  try {
    return read_cases(output::read_file(path), path.string(), problems);
  } catch (const output::IoError& error) {
    problems.add(name, fmt::format("table {}: {}", path.string(), error.reason()),
                 "a CSV file of the cases");
    return {};
  }
}

CaseList read_grid(const toml::table& root, Problems& problems) {
  const toml::table& grid = *root["grid"].as_table();
  const std::vector<Axis> axes = read_axes(grid);
  if (axes.empty())
    problems.add(grid, "the grid is empty", "one axis or more",
                 "as in speed = { key = \"joints.motor.drive.rate\", values = [100, 150] }");
  if (combinations(axes) > kMostCases) {
    problems.add(grid, "the grid has very many cases", fmt::format("at most {}", kMostCases));
    return {};
  }
  return expand(axes);
}

CaseList read_case_list(const Document& document, Problems& problems) {
  const toml::node* table = document.root.get("table");
  const toml::node* grid = document.root.get("grid");
  if (table && grid)
    problems.add(*grid, "the batch has both 'table' and 'grid'", "exactly one of table, grid",
                 "leave out all but one");
  else if (!table && !grid)
    problems.add(document.root, "the batch has no cases", "exactly one of table, grid");
  else if (table)
    return read_table(*table, document.file, problems);
  else
    return read_grid(document.root, problems);
  return {};
}

/// Path of a change of a study, of its scene or of a scene: "scene.KEY" is the KEY of the scene.
std::string path_of(const Batch& batch, std::string change) {
  change.erase(std::min(change.find('='), change.size()));
  std::erase(change, ' ');
  if (!batch.optimize) return change;
  const SplitOverrides parts = split_overrides({change});
  return parts.scene.empty() ? "study." + change : "scene." + without_scene(parts.scene.front());
}

/// Are the columns keys, with names that the results do not use otherwise?
void check_columns(const Batch& batch, Problems& problems) {
  std::set<std::string> keys;
  const auto add = [&](const InputPlace& at, std::string what, std::string expected,
                       std::string hint) {
    problems.add(
        {at.file, at.line, at.column, std::move(what), std::move(expected), std::move(hint)});
  };
  for (const CaseColumn& column : batch.cases.columns) {
    if (reserved(column.name))
      add(column.place, fmt::format("'{}' is the name of a column of the results", column.name),
          "another name", "");
    for (const std::string& key : column.keys) {
      if (!keys.insert(path_of(batch, key)).second)
        add(column.place, fmt::format("key '{}' is there twice", key), "every key once", "");
      if (key.empty() || key.find('=') != std::string::npos)
        add(column.place, fmt::format("'{}' is not a key", key), "a key of the study or scene",
            "as in joints.motor.drive.rate");
      else if (const auto wrong = key_problem(batch.of, key))
        add(column.place, wrong->what, wrong->expected, wrong->hint);
    }
  }
}

/// Where the value of a change "--set key=text" stands.
const InputPlace* place_of(const Batch& batch, std::size_t row, const std::string& source) {
  for (std::size_t c = 0; c < batch.cases.columns.size(); ++c) {
    const CaseValue& value = batch.cases.rows[row].values[c];
    for (const std::string& change : value.instead.value_or(std::vector<std::string>()))
      if (source == "--set " + change) return &value.place;
    for (const std::string& key : batch.cases.columns[c].keys)
      if (source == "--set " + key + "=" + value.text) return &value.place;
  }
  return nullptr;
}

/// Reads every case; a problem that many cases share is told once.
void read_every_case(Batch& batch, Problems& problems) {
  constexpr int kEnough = 50;
  std::set<std::string> told;
  for (std::size_t row = 0; row < batch.cases.rows.size() && problems.count() < kEnough; ++row)
    try {
      const auto changes = batch.changes(row);
      const std::string input = batch.optimize ? load_study(batch.of, changes).input
                                               : load_scene(batch.of, changes).input;
      if (row == 0) batch.input = input;
      batch.input += "\ncase " + batch.cases.rows[row].name;
      for (const std::string& change : changes) batch.input += "\n--set " + change;
    } catch (const InputError& error) {
      for (InputProblem problem : error.problems) {
        if (const InputPlace* at = place_of(batch, row, problem.file)) {
          problem.file = at->file;
          problem.line = at->line;
          problem.column = at->column;
        }
        if (told.insert(problem.text()).second) problems.add(problem);
      }
    }
}

}  // namespace

std::vector<std::string> Batch::changes(std::size_t row) const {
  std::vector<std::string> all = defaults;
  all.insert(all.end(), set.begin(), set.end());
  for (std::string& change : overrides(cases, row)) all.push_back(std::move(change));
  return all;
}

namespace {

/// Unit of a key of the study or scene; empty if the key alone does not tell it.
std::string unit_of_key(const Batch& batch, const std::string& key) {
  FileKind kind = batch.optimize ? FileKind::Study : FileKind::Scene;
  std::string path = key;
  if (const SplitOverrides parts = split_overrides({key}); batch.optimize && !parts.scene.empty()) {
    kind = FileKind::Scene;
    path = without_scene(parts.scene.front());
  }
  const std::string unit(unit_at(kind, path));
  const bool known = unit.find(" or ") == std::string::npos && !unit.starts_with("of ");
  return known ? unit : "";  // not "rad/s or m/s", "of the response"
}

}  // namespace

std::string unit_of(const Batch& batch, const CaseColumn& column) {
  if (column.keys.empty()) return "";
  const std::string unit = unit_of_key(batch, column.keys.front());
  const bool shared = std::all_of(column.keys.begin(), column.keys.end(),
                                  [&](const auto& key) { return unit_of_key(batch, key) == unit; });
  return shared ? unit : "";
}

std::optional<RowKey> set_by_rows(const Batch& batch, const std::string& path) {
  const std::string wanted = path_of(batch, path);
  const auto meets = [&](const std::string& change) {
    const std::string key = path_of(batch, change);
    return key == wanted || key.starts_with(wanted + ".") || wanted.starts_with(key + ".");
  };
  const auto& columns = batch.cases.columns;
  for (const CaseColumn& column : columns)
    for (const std::string& key : column.keys)
      if (meets(key)) return RowKey{column.name, key};
  for (const CaseList::Row& row : batch.cases.rows)
    for (const CaseValue& value : row.values)
      for (const std::string& change : value.instead.value_or(std::vector<std::string>()))
        if (meets(change)) return RowKey{value.text, change.substr(0, change.find('='))};
  return std::nullopt;
}

void refuse_changes_of_rows(const Batch& batch, const std::vector<std::string>& changes,
                            Problems& problems) {
  for (const std::string& change : changes)
    if (const auto own = set_by_rows(batch, change))
      problems.add({"--set " + change, 0, 0,
                    fmt::format("'{}' sets '{}' in each of its cases", own->by, own->key),
                    "a key that no axis and no column sets",
                    fmt::format("change its values, or leave '{}' out", own->by)});
}

void check_cases(Batch& batch, Problems& problems) {
  check_columns(batch, problems);
  problems.throw_if_any();
  read_every_case(batch, problems);
  problems.throw_if_any();
}

Batch load_batch(const fs::path& path, const std::vector<std::string>& changes) {
  Document document = load_document(path);
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Batch, problems);
  Batch batch;
  std::vector<std::string> own;
  for (const std::string& change : changes)
    (is_of_batch(change) ? own : batch.set).push_back(change);
  apply_overrides(document.root, FileKind::Batch, own, problems);
  validate(document.root, FileKind::Batch, problems);
  problems.throw_if_any();

  const toml::table& root = document.root;
  batch.file = document.file;
  batch.name = title(root, batch.file);
  batch.optimize = root.contains("study");
  const toml::node& of = *root.get(batch.optimize ? "study" : "scene");
  batch.of = relative_to(path, *of.value<std::string>());
  std::error_code error;
  if (!fs::exists(batch.of, error))
    problems.add(of, "there is no file " + batch.of.string(), "a scene or study in TOML",
                 "paths are relative to the batch");
  batch.time = root["limits"]["time"].value<double>();
  batch.memory = root["limits"]["memory"].value<double>();
  batch.cases = read_case_list(document, problems);
  refuse_changes_of_rows(batch, batch.set, problems);
  problems.throw_if_any();
  check_cases(batch, problems);
  return batch;
}

Shard read_shard(const std::string& text) {
  if (text.empty()) return {};
  Shard shard{0, 0};
  const char* const end = text.data() + text.size();
  auto part = std::from_chars(text.data(), end, shard.number);
  const bool slash = part.ec == std::errc{} && part.ptr != end && *part.ptr == '/';
  if (slash) part = std::from_chars(part.ptr + 1, end, shard.of);
  const bool whole = slash && part.ec == std::errc{} && part.ptr == end;
  if (!whole || shard.number < 1 || shard.number > shard.of)
    throw InputError(
        {{"--shard " + text, 0, 0, whole ? "the shard is outside the range" : "not a shard",
          "i/n with 1 <= i <= n",
          whole && shard.of > 0 ? fmt::format("1/{0} to {0}/{0}", shard.of)
                                : "as in --shard 3/20"}});
  return shard;
}

}  // namespace liesl
