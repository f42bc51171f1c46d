#include "apps/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "apps/batch/grid.hpp"
#include "apps/compare/models.hpp"
#include "apps/compare/row_table.hpp"
#include "apps/input/document.hpp"
#include "apps/input/title.hpp"
#include "apps/input/validate.hpp"
#include "apps/scene/load_scene.hpp"
#include "apps/scene/reader.hpp"
#include "apps/study/study.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

/// Keys of the comparison itself; what is left goes to the scene of all runs.
bool is_of_comparison(const std::string& change) {
  const std::string path = change.substr(0, change.find('='));
  const std::string top = path.substr(0, path.find('.'));
  return find_key(FileKind::Comparison, top) && (top == path || (top != "scene" && top != "study"));
}

/// Does a key change only how the scene is computed?
bool is_numerical(const std::string& key) {
  const std::string leaf = key.substr(key.rfind('.') + 1);
  if (key.starts_with("simulation.")) return leaf != "duration";
  return key.find(".beam.") != std::string::npos &&
         (leaf == "elements" || leaf == "as" || leaf == "modes" || leaf == "order");
}

/// Keys of the elements of the beams that the comparison names, or of all.
std::vector<std::string> mesh_keys(const toml::table& root, const Scene& scene,
                                   Problems& problems) {
  std::vector<std::string> beams, keys;
  for (const BodySpec& body : scene.mechanism.bodies)
    if (std::holds_alternative<BeamSpec>(body.kind)) beams.push_back(body.name);
  const auto add = [&keys](const std::string& name) {
    keys.push_back("bodies." + name + ".beam.elements");
  };
  if (!root.contains("beams")) {
    for (const std::string& name : beams) add(name);
    return keys;
  }
  for (const toml::node* node : strings(root, "beams")) {
    const std::string name = *node->value<std::string>();
    if (std::count(beams.begin(), beams.end(), name))
      add(name);
    else
      problems.add(*node, fmt::format("the scene has no beam '{}'", name), "a beam of the scene",
                   suggestion(name, beams));
  }
  return keys;
}

/// Keys that an axis of `grid` changes; none of what is for studies only.
std::vector<std::string> keys_of_axis(std::string_view name, const Comparison& comparison) {
  if (name == "elements") return comparison.mesh_keys;
  return {"simulation." + std::string(name)};
}

void refuse_keys_of_studies(const toml::table& root, Problems& problems) {
  for (const char* name : {"method", "optimizer", "treatment", "approximation"})
    if (const toml::node* node = root["grid"].as_table()->get(name))
      problems.add(*node, fmt::format("a scene has no {}", name), "an axis of a scene",
                   "give a 'study' instead of the scene");
}

ReferenceSpec read_reference(const toml::table& table, Problems& problems) {
  ReferenceSpec spec;
  const toml::array& pair = *table["formalisms"].as_array();
  const Key& known = *find_key(FileKind::Scene, "simulation.formalism");
  const auto options = words(known.options);
  for (std::size_t i = 0; i < 2; ++i) {
    spec.formalisms[i] = *pair[i].value<std::string>();
    if (!std::count(options.begin(), options.end(), spec.formalisms[i]))
      problems.add(pair[i], fmt::format("unknown formalism \"{}\"", spec.formalisms[i]),
                   expectation(known), suggestion(spec.formalisms[i], options));
  }
  if (spec.formalisms[0] == spec.formalisms[1])
    problems.add(pair, "the reference compares a formalism with itself", "two different formalisms",
                 "their difference estimates the error of both");
  spec.elements = table["elements"].value<int>();
  spec.step = number(table, "step");
  spec.tolerance = number(table, "tolerance");
  spec.rho_inf = table["rho_inf"].value<double>();
  const std::string extrapolate = text(table, "extrapolate");
  spec.mesh = extrapolate == "mesh" || extrapolate == "both";
  spec.time = extrapolate == "step" || extrapolate == "both";
  if (spec.mesh && (!spec.elements || *spec.elements % 2 != 0))
    problems.add(*table.get("extrapolate"), "the mesh cannot be halved",
                 "reference.elements, an even number");
  spec.place = place_of(table);
  return spec;
}

/// Reads the scene with what is changed in all runs; problems are said at the values of `set`.
Scene read_scene_of(const toml::table& root, Comparison& comparison, Problems& problems) {
  std::vector<std::pair<std::string, const toml::node*>> sources;
  if (const toml::table* set = root["set"].as_table())
    for (const auto& [name, node] : *set) {
      comparison.rows.set.push_back(fmt::format("{}={}", name.str(), toml_text(node)));
      sources.emplace_back("--set " + comparison.rows.set.back(), &node);
    }
  try {
    return load_scene(comparison.rows.of, comparison.rows.set);
  } catch (const InputError& error) {
    for (InputProblem problem : error.problems) {
      const toml::node* at = problem.line == 0 ? root.get("scene") : nullptr;
      for (const auto& [source, node] : sources)
        if (problem.file == source) at = node;
      if (at) {
        const InputPlace place = place_of(*at);
        if (problem.file == comparison.rows.of.string()) problem.what = "scene: " + problem.what;
        problem.file = place.file, problem.line = place.line, problem.column = place.column;
      }
      problems.add(problem);
    }
  }
  problems.throw_if_any();
  return {};
}

/// Beams of which the scene does not say the order, which would depend on the formalism: of
/// order 2.
std::vector<std::string> default_orders(const fs::path& scene) {
  Document document = load_document(scene);
  std::vector<std::string> changes;
  for (const Entry& body : entries_at(document.root, "bodies")) {
    const toml::table* beam = (*body.table)["beam"].as_table();
    if (beam && !beam->contains("order"))
      changes.push_back(fmt::format("bodies.{}.beam.order=2", body.name));
  }
  return changes;
}

void check_quantity(const toml::table& root, const Scene& scene, Problems& problems) {
  const std::string name = text(*root["quantity"].as_table(), "response");
  std::vector<std::string> known;
  for (const ResponseSpec& response : scene.responses) known.push_back(response.name);
  if (!std::count(known.begin(), known.end(), name))
    problems.add(*root["quantity"].as_table()->get("response"),
                 fmt::format("the scene has no response '{}'", name), "a response of the scene",
                 suggestion(name, known, "the scene has no [responses]"));
  if (scene.simulation.type != SimulationType::Dynamic)
    problems.add(*root.get("scene"), "the scene is not dynamic",
                 "a scene with simulation.type = \"dynamic\"");
}

/// Formalisms and fine meshes of the reference are read once, as the scene that they will be.
void check_references(Comparison& comparison, Problems& problems) {
  comparison.smallest_step = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < comparison.rows.cases.rows.size(); ++row)
    comparison.smallest_step =
        std::min(comparison.smallest_step,
                 load_scene(comparison.rows.of, comparison.rows.changes(row)).simulation.step);
  if (!comparison.reference) return;
  for (int side : {0, 1})
    for (const ReferenceRun& run : comparison.reference_runs(0, side)) try {
        const Scene scene = load_scene(comparison.rows.of, run.changes);
        for (const std::string& change : run.changes) comparison.rows.input += "\n" + change;
      } catch (const InputError& error) {
        for (InputProblem problem : error.problems) {
          const InputPlace& at = comparison.reference->place;
          problem.file = at.file, problem.line = at.line, problem.column = at.column;
          problem.what = "the reference: " + problem.what;
          problems.add(problem);
        }
      }
}

output::Norm norm_of(const std::string& name) {
  using output::Norm;
  return name == "final" ? Norm::Final : name == "max" ? Norm::Max : Norm::Rms;
}

}  // namespace

std::vector<Axis> axes_of(const toml::table& root,
                          const std::function<std::vector<std::string>(std::string_view)>& keys,
                          Problems& problems) {
  std::vector<Axis> axes;
  const toml::table& grid = *root["grid"].as_table();
  for (const auto& [name, node] : grid) {
    Axis axis{{std::string(name.str()), keys(name.str()), place_of(node)}, {}};
    if (axis.column.keys.empty())
      problems.add(node,
                   name == "elements" ? "the scene has no beam" : "the study has no constraints",
                   name == "elements" ? "a scene with beams" : "a study with limits",
                   fmt::format("leave '{}' out", name.str()));
    for (const toml::node& value : *node.as_array())
      axis.values.push_back({toml_text(value), place_of(value)});
    axes.push_back(std::move(axis));
  }
  if (const toml::table* vary = root["vary"].as_table())
    for (Axis& axis : read_axes(*vary)) axes.push_back(std::move(axis));
  std::stable_sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
    return std::tie(a.column.place.line, a.column.place.column) <
           std::tie(b.column.place.line, b.column.place.column);
  });
  if (axes.empty())
    problems.add(grid, "the grid is empty", "one axis or more",
                 "as in formalism = [\"se3\", \"r3so3\", \"classical\"]");
  for (const Axis& axis : axes)
    if (is_figure(axis.column.name, root.contains("study")))
      problems.add({axis.column.place.file, axis.column.place.line, axis.column.place.column,
                    fmt::format("'{}' is the name of a column of rows.csv", axis.column.name),
                    "another name", ""});
  if (combinations(axes) > kMostCases)
    problems.add(grid, "the grid has very many rows", fmt::format("at most {}", kMostCases));
  return axes;
}

void read_changes(const toml::table& root, Comparison& comparison) {
  if (const toml::table* set = root["set"].as_table())
    for (const auto& [name, node] : *set)
      comparison.rows.set.push_back(fmt::format("{}={}", name.str(), toml_text(node)));
}

void check_changes(const toml::table& root, const Batch& rows, Problems& problems) {
  const toml::table* set = root["set"].as_table();
  const auto of_file = static_cast<std::ptrdiff_t>(set ? set->size() : 0);
  refuse_changes_of_rows(rows, {rows.set.begin(), rows.set.end() - of_file}, problems);
  if (!set || root.contains("models")) return;  // which may leave the grid's keys alone
  for (const auto& [key, node] : *set)
    if (const auto own = set_by_rows(rows, std::string(key.str())); own && own->key == key.str())
      problems.add(node, fmt::format("'{}' sets '{}' in each of its cases", own->by, own->key),
                   "a key that no axis sets", fmt::format("leave '{}' out of 'set'", own->key));
}

std::vector<std::string> Comparison::physics(std::size_t row) const {
  std::vector<std::string> changes;
  const CaseList& cases = rows.cases;
  for (std::size_t c = 0; c < cases.columns.size(); ++c) {
    const CaseValue& value = cases.rows[row].values[c];
    for (const std::string& key : cases.columns[c].keys)
      if (!value.instead && !is_numerical(key)) changes.push_back(key + "=" + value.text);
  }
  return changes;
}

std::vector<ReferenceRun> Comparison::reference_runs(std::size_t row, int side) const {
  const auto run = [&](double weight, int coarser_mesh, int coarser_step) {
    ReferenceRun r{weight, rows.defaults};
    r.changes.insert(r.changes.end(), rows.set.begin(), rows.set.end());
    for (std::string& change : physics(row)) r.changes.push_back(std::move(change));
    r.changes.push_back("simulation.formalism=" +
                        reference->formalisms[static_cast<std::size_t>(side)]);
    if (reference->elements)
      for (const std::string& key : mesh_keys)
        r.changes.push_back(fmt::format("{}={}", key, *reference->elements / coarser_mesh));
    const double step = reference->step * coarser_step;
    r.changes.push_back(fmt::format("simulation.step={}", step));
    r.changes.push_back(fmt::format("simulation.tolerance={}", reference->tolerance));
    if (reference->rho_inf)
      r.changes.push_back(fmt::format("simulation.rho_inf={}", *reference->rho_inf));
    const int every = static_cast<int>(smallest_step / step * (1 + 1e-9));
    r.changes.push_back(fmt::format("simulation.output_every={}", std::max(1, every)));
    return r;
  };
  // Both errors are of second order: f = fine + (fine - coarse)/3, in the mesh, the step, or both.
  std::vector<ReferenceRun> runs;
  for (const int mesh : {1, 2})
    for (const int step : {1, 2}) {
      if ((mesh == 2 && !reference->mesh) || (step == 2 && !reference->time)) continue;
      const auto weight = [](bool extrapolated, int coarser) {
        return !extrapolated ? 1.0 : coarser == 1 ? 4.0 / 3 : -1.0 / 3;
      };
      runs.push_back(
          run(weight(reference->mesh, mesh) * weight(reference->time, step), mesh, step));
    }
  return runs;
}

Comparison load_comparison(const fs::path& path, const std::vector<std::string>& changes) {
  Document document = load_document(path);
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Comparison, problems);
  Comparison comparison;
  Batch& rows = comparison.rows;
  std::vector<std::string> own, of_scene;
  for (const std::string& change : changes)
    (is_of_comparison(change) ? own : of_scene).push_back(change);
  apply_overrides(document.root, FileKind::Comparison, own, problems);
  validate(document.root, FileKind::Comparison, problems);
  problems.throw_if_any();

  const toml::table& root = document.root;
  rows.name = title(root, document.file);
  rows.file = document.file;
  rows.set = of_scene;
  comparison.time_limit = number(root, "time_limit");
  if (root.contains("study")) {
    read_methods(root, path, comparison, problems);
    rows.input = document.text + rows.input;
    for (const std::string& change : own) rows.input += "\n--set " + change;
    return comparison;
  }
  if (!root.contains("quantity"))
    problems.add(root, "missing key 'quantity'", "a table", "what the error is measured by");
  problems.throw_if_any();
  rows.of = (path.parent_path() / text(root, "scene")).lexically_normal();
  const Scene scene = read_scene_of(root, comparison, problems);
  rows.defaults = default_orders(rows.of);
  const toml::table& quantity = *root["quantity"].as_table();
  comparison.response = text(quantity, "response");
  comparison.norm = norm_of(text(quantity, "norm"));
  comparison.repeats = integer(root, "repeats");
  comparison.mesh_keys = mesh_keys(root, scene, problems);
  check_quantity(root, scene, problems);
  refuse_keys_of_studies(root, problems);
  problems.throw_if_any();
  const auto keys = [&](std::string_view name) { return keys_of_axis(name, comparison); };
  const std::vector<Axis> axes = axes_of(root, keys, problems);
  if (const toml::table* reference = root["reference"].as_table())
    comparison.reference = read_reference(*reference, problems);
  problems.throw_if_any();
  rows.cases = expand(axes);
  if (const toml::table* models = root["models"].as_table()) {
    add_models(*models, axes, rows.cases, problems);
    problems.throw_if_any();
  }
  check_changes(root, rows, problems);
  problems.throw_if_any();
  check_cases(rows, problems);
  check_references(comparison, problems);
  problems.throw_if_any();
  rows.input = document.text + rows.input;
  for (const std::string& change : own) rows.input += "\n--set " + change;
  return comparison;
}

}  // namespace liesl
