#include "apps/study/load_study.hpp"

#include <algorithm>
#include <functional>
#include <sstream>

#include "apps/input/document.hpp"
#include "apps/input/ordered_text.hpp"
#include "apps/input/title.hpp"
#include "apps/scene/scene_key.hpp"
#include "apps/study/study_reader.hpp"
#include "mbs/sections/shape_dimensions.hpp"

namespace liesl {

namespace {

namespace fs = std::filesystem;

/// The scene that a study names, empty (and said) if it cannot be read.
std::optional<Document> scene_of(const toml::table& root, const fs::path& folder,
                                 Problems& problems) {
  const toml::node* node = root.get("scene");
  if (!node || !node->is_string()) return {};
  const fs::path path = fs::path(text(root, "scene"));
  try {
    Document document =
        load_document((path.is_absolute() ? path : folder / path).lexically_normal());
    if (kind_of(document.root) == FileKind::Scene) return document;
    problems.add(*node, "'scene' names a study", "the file of a scene");
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems) {
      if (problem.line > 0)
        problems.add(problem);
      else
        problems.add(*node, "scene " + problem.file + ": " + problem.what, problem.expected,
                     problem.hint.empty() ? "paths are relative to the study" : problem.hint);
    }
  }
  return {};
}

void read_study_parts(StudyReader& reader) {
  read_design(reader);
  check_motion_variables(reader);
  read_objective(reader);
  read_constraints(reader);
  read_frequencies(reader);
  read_supports(reader);
  read_parts_of_study(reader);
  read_cycle(reader);
  check_images(reader);
  check_shapes(reader);
}

/// The scene of one scenario, with what the study and its scenario change.
struct ScenarioText {
  std::string name;
  Document scene;
  const toml::node* node = nullptr;  ///< in the study, for messages; null: there are no scenarios
};

/// The scene of each scenario; without scenarios the scene itself. Each reads the file anew: copies
/// of a table do not know their lines. Empty (and said) if the scene cannot be read.
std::vector<ScenarioText> scenarios_of(Document& study, const fs::path& folder,
                                       const std::vector<std::string>& overrides,
                                       const Broken& broken, Problems& problems) {
  std::vector<ScenarioText> out;
  const auto add = [&](const std::string& name, toml::node* node) {
    auto scene = scene_of(study.root, folder, problems);
    if (!scene) return;
    if (toml::table* set = study.root["set"].as_table()) apply_set(*set, scene->root, problems);
    apply_overrides(scene->root, FileKind::Scene, overrides, problems);
    if (toml::table* set = node ? node->as_table()->get_as<toml::table>("set") : nullptr)
      apply_set(*set, scene->root, problems);
    out.push_back({name, std::move(*scene), node});
  };
  toml::table* table = study.root["scenarios"].as_table();
  if (!table || broken.contains("scenarios")) {
    add("", nullptr);
    return out;
  }
  for (auto&& [key, value] : *table)
    if (const std::string name(key.str());
        !broken.contains("scenarios." + name) && (out.empty() || problems.count() == 0))
      add(name, &value);
  if (table->empty() && problems.count() == 0)  // else one that could not be set may be missing
    problems.add(*table, "there is no scenario", "an entry in [scenarios], or no such table");
  if (table->size() > 1 && study.root.contains("loads"))
    problems.add(*table, "fixed loads move nothing, in no scenario",
                 "several load cases in [loads]");
  return out;
}

constexpr const char* kOneType = "one simulation.type for all, \"dynamic\" or \"static\"";

/// One design fits all scenarios: the same bodies with the same nodes.
bool same_bodies(const Scene& scene_a, const Scene& scene_b) {
  const Mechanism &a = scene_a.mechanism, &b = scene_b.mechanism;
  const auto same = [](const BodySpec& x, const BodySpec& y) {
    const auto *beam_x = std::get_if<BeamSpec>(&x.kind), *beam_y = std::get_if<BeamSpec>(&y.kind);
    return x.name == y.name && x.kind.index() == y.kind.index() &&
           (!beam_x || beam_x->nodes.size() == beam_y->nodes.size());
  };
  return std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(), same);
}

bool same_outline(const BodySpec& a, const BodySpec& b) {
  const auto *x = std::get_if<SolidSpec>(&a.kind), *y = std::get_if<SolidSpec>(&b.kind);
  if (!x || !y) return !x && !y;
  const auto &of_x = x->outline.features, &of_y = y->outline.features;
  return std::equal(of_x.begin(), of_x.end(), of_y.begin(), of_y.end(),
                    [](const auto& f, const auto& g) {
                      return f.kind == g.kind && f.values == g.values && f.operands == g.operands;
                    });
}

bool same_sections(const DesignSpec& design, const BodySpec& a, const BodySpec& b) {
  const auto *x = std::get_if<BeamSpec>(&a.kind), *y = std::get_if<BeamSpec>(&b.kind);
  if (!x || !y) return !x && !y;
  for (std::size_t e = 0; e < x->sections.size(); ++e) {
    const Shape &of_x = x->sections[e].shape, &of_y = y->sections[e].shape;
    if (of_x.index() != of_y.index()) return false;
    for (const std::string& name : design.properties)
      if (dimension(of_x, name) != dimension(of_y, name)) return false;
  }
  return true;
}

/// A variable of the design that two scenarios give different values, which it would set in both;
/// empty: there is none.
std::string set_otherwise(const StudySpec& spec, Mechanism a, Mechanism b) {
  const auto body = [](const Mechanism& m, int i) { return m.bodies.at(std::size_t(i)); };
  for (const DesignSpec& d : spec.design)
    for (const int i : d.bodies)
      if (!same_sections(d, body(a, i), body(b, i))) return d.name;
  for (const ConstantSpec& c : spec.constants)
    if (constant_of(c, a) != constant_of(c, b)) return c.name;
  for (const auto& [i, shape] : spec.shapes)
    if (!same_outline(body(a, i), body(b, i)))
      return shape.variables.empty() ? body(a, i).name : shape.variables.front().name;
  return "";
}

/// The scene without scenarios, read where one of two has to be blamed.
using Plain = std::function<Scene()>;

/// What two scenes have in common.
using Alike = std::function<bool(const Scene&, const Scene&)>;

/// Of scenario s and the first, which are not alike, the one that is not as the scene is either.
const ScenarioText& odd_one(const std::vector<ScenarioText>& texts, std::size_t s,
                            const Study& study, const Plain& plain, const Alike& alike) {
  const Scene scene = plain();
  const bool first = !alike(scene, study.scene) && alike(scene, study.scenarios[s - 1]);
  return texts[first ? 0 : s];
}

/// What the design varies is its own in every scenario. @pre all is read
void check_scenarios(const std::vector<ScenarioText>& texts, Problems& problems, const Study& study,
                     const Plain& plain) {
  const auto varied = [&](const Scene& a, const Scene& b) {
    return set_otherwise(study.spec, a.mechanism, b.mechanism);
  };
  for (std::size_t s = 1; s < texts.size() && problems.count() == 0; ++s) {
    const std::string name = varied(study.scene, study.scenarios[s - 1]);
    if (name.empty()) continue;
    const ScenarioText& odd = odd_one(texts, s, study, plain, [&](const Scene& a, const Scene& b) {
      return varied(a, b).empty();
    });
    problems.add(*odd.node,
                 "scenario '" + odd.name + "' changes what the design varies: '" + name + "'",
                 "other keys", "one design stands all scenarios; start and bounds are in [design]");
  }
}

/// Limits and objective on what is always 0 in a scenario after the first, which was asked when
/// they were read. @pre all is read
void check_rigid_bodies(const std::vector<ScenarioText>& texts, Problems& problems,
                        const Study& study) {
  for (std::size_t s = 1; s < texts.size() && problems.count() == 0; ++s) {
    const Mechanism& mechanism = study.scenarios[s - 1].mechanism;
    const auto check = [&](const char* what, const ResponseSpec& response) {
      const int body = deformed_body(response);
      if (body < 0) return;
      const BodySpec& spec = mechanism.bodies[static_cast<std::size_t>(body)];
      if (moves_rigidly(spec, mechanism.formalism))
        problems.add(*texts[s].node,
                     std::string(what) + " '" + response.name + "' is always 0 in scenario '" +
                         texts[s].name + "': '" + spec.name + "' is rigid",
                     "a response that does not need deformation, or a flexible body",
                     "bodies.*.beam.as, modes and simulation.formalism say what a body is "
                     "simulated as");
    };
    for (const ConstraintSpec& c : study.spec.constraints)
      check(c.weight > 0 ? "response" : "limit", c.response);
    for (const ResponseSpec& r : study.spec.motion_objective.responses) check("response", r);
  }
}

/// Adds the files that only scenarios after the first name. @pre they are read
void add_files(Study& study) {
  for (const Scene& scene : study.scenarios)
    for (const NamedInput& file : scene.files) {
      auto& files = study.scene.files;
      if (std::any_of(files.begin(), files.end(),
                      [&](const NamedInput& known) { return known.path == file.path; }))
        continue;
      files.push_back(file);
      study.input += file.sha256;
      study.resumable += file.sha256;
    }
}

Scene read_scenario(ScenarioText& from, Problems& problems) {
  const Broken broken = validate(from.scene.root, FileKind::Scene, problems);
  Scene scene;
  scene.file = from.scene.file;
  scene.input = from.scene.text;
  Reader reader{from.scene.root, broken, problems, scene, {}, {}};
  read_parts(reader);
  return scene;
}

bool same_type(const Scene& a, const Scene& b) { return a.simulation.type == b.simulation.type; }

/// The scenarios after the first, which is read.
void read_scenarios(std::vector<ScenarioText>& texts, Problems& problems, Study& study,
                    const Plain& plain) {
  for (std::size_t s = 0; s < texts.size(); ++s) {
    if (texts[s].node) study.spec.scenarios.push_back(texts[s].name);
    if (texts.size() == 1 || problems.count() > 0) continue;  // what is wrong in one is said once
    if (s > 0) study.scenarios.push_back(read_scenario(texts[s], problems));
    const Scene& scene = s > 0 ? study.scenarios.back() : study.scene;
    if (!same_bodies(scene, study.scene)) {
      const ScenarioText& odd = odd_one(texts, s, study, plain, same_bodies);
      const ScenarioText& other = texts[&odd == texts.data() ? s : 0];
      problems.add(*odd.node,
                   "scenario '" + odd.name + "' has other bodies than '" + other.name + "'",
                   "speeds, masses, loads, times; the same beams with the same elements");
    }
    if (scene.simulation.type == SimulationType::Modes) {
      problems.add(*texts[s].node,
                   "scenario '" + texts[s].name + "' is neither motion nor equilibrium", kOneType);
    } else if (!same_type(scene, study.scene)) {
      const ScenarioText& odd = odd_one(texts, s, study, plain, same_type);
      const bool moves =
          (&odd == texts.data() ? scene : study.scene).simulation.type != SimulationType::Static;
      problems.add(*odd.node,
                   "scenario '" + odd.name + "' is no " + (moves ? "motion" : "equilibrium") +
                       ", as the others are",
                   kOneType);
    }
  }
}

std::string content(const toml::table& table) {
  std::ostringstream text;
  text << table << "\n";
  return text.str();
}

/// A scene that may lie in another folder.
toml::table with_whole_paths(const Document& scene) {
  toml::table copy = scene.root;
  for_each_file(copy, [&](const std::string&, toml::value<std::string>& file) {
    file = whole_path(scene.file, *file);
  });
  return copy;
}

/// A study without what says when its cycles end.
std::string without_ends(const toml::table& study) {
  toml::table copy = study;
  if (toml::table* cycle = copy["cycle"].as_table())
    for (const char* key : {"max", "tolerance", "objective_tolerance", "optimality", "gap",
                            "max_designs", "restarts", "continuation", "refine"})
      cycle->erase(key);
  return content(copy);
}

Study read_document(Document document, const fs::path& folder,
                    const std::vector<std::string>& overrides) {
  Problems problems(document.file);
  expect_kind(document.root, FileKind::Study, problems);
  const SplitOverrides parts = split_overrides(overrides);
  apply_overrides(document.root, FileKind::Study, parts.study, problems);
  const Broken broken = validate(document.root, FileKind::Study, problems);

  auto scenarios = scenarios_of(document, folder, parts.scene, broken, problems);
  if (scenarios.empty()) problems.throw_if_any();

  Study study;
  study.file = document.file;
  study.spec.name = title(document.root, study.file);
  Document& first = scenarios.front().scene;
  study.scene.file = first.file;
  study.scene.input = first.text;
  for (const ScenarioText& s : scenarios)
    study.scene_texts.push_back(ordered_text(with_whole_paths(s.scene)));
  const Broken scene_broken = validate(first.root, FileKind::Scene, problems);
  Reader scene{first.root, scene_broken, problems, study.scene, {}, {}};
  scene.fixed_loads = document.root.contains("loads");
  read_parts(scene);
  study.input = document.text + study.scene.input;
  for (const std::string& text : overrides) study.input += "\n--set " + text;
  study.resumable = without_ends(document.root) + content(first.root);
  for (const NamedInput& file : study.scene.files) study.resumable += file.sha256;
  for (std::size_t s = 1; s < scenarios.size(); ++s)
    study.resumable += content(scenarios[s].scene.root);
  const Plain plain = [&] {
    Problems unsaid(document.file);
    ScenarioText bare{"", *scene_of(document.root, folder, unsaid)};
    if (toml::table* set = document.root["set"].as_table())
      apply_set(*set, bare.scene.root, unsaid);
    apply_overrides(bare.scene.root, FileKind::Scene, parts.scene, unsaid);
    return read_scenario(bare, unsaid);
  };
  read_scenarios(scenarios, problems, study, plain);
  add_files(study);
  StudyReader reader{document.root, broken, scene, study.spec};
  read_study_parts(reader);
  check_scenarios(scenarios, problems, study, plain);
  check_rigid_bodies(scenarios, problems, study);
  const toml::table* cycle = document.root["cycle"].as_table();
  study.refine = !cycle || broken.contains("cycle") || text(*cycle, "refine") == "auto";
  problems.throw_if_any();
  return study;
}

}  // namespace

Study load_study(const fs::path& path, const std::vector<std::string>& overrides) {
  return read_document(load_document(path), path.parent_path(), overrides);
}

Study read_study(const std::string& text, const std::string& file, const fs::path& folder,
                 const std::vector<std::string>& overrides) {
  return read_document(parse_document(text, file), folder, overrides);
}

std::optional<InputProblem> key_problem(const fs::path& path, const std::string& key) {
  Document document = load_document(path);
  Problems problems(document.file);
  SplitOverrides parts{{}, {key + "=0"}};
  if (kind_of(document.root) == FileKind::Study) {
    parts = split_overrides(parts.scene);
    apply_overrides(document.root, FileKind::Study, parts.study, problems);
    if (auto scene = scene_of(document.root, path.parent_path(), problems))
      document = std::move(*scene);
  }
  apply_overrides(document.root, FileKind::Scene, parts.scene, problems);
  try {
    problems.throw_if_any();
  } catch (const InputError& error) {
    return error.problems.front();
  }
  return {};
}

}  // namespace liesl
