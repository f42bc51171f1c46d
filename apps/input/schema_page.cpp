/// @file
/// The reference page of scenes and studies, written from the schema.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "apps/input/schema.hpp"

namespace liesl {

namespace {

/// Text inside a table cell: bars would end the cell, stars would be emphasis.
std::string cell(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|' || c == '*') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string preset_text(const Key& key) {
  if (key.preset == kRequired) return "required";
  if (key.preset == kOneOf) return "one of";
  if (key.preset == kOptional) return "";
  return fmt::format("`{}`", key.preset);
}

std::string doc_text(const Key& key) {
  std::string text = cell(key.doc);
  if (!key.when.empty()) {
    const auto equals = key.when.find('=');
    text += fmt::format(" For {} {}.", key.when.substr(0, equals),
                        fmt::join(words(key.when.substr(equals + 1)), ", "));
  }
  return text;
}

/// Tables of keys, with a heading wherever the top-level table changes.
std::string tables(const std::vector<Key>& keys) {
  std::string text, group = "?";
  for (const Key& key : keys) {
    std::string top = key.path.substr(0, key.path.find('.'));
    const bool scalar = top == key.path && key.type != Type::Named && key.type != Type::Table;
    if (scalar) top.clear();
    if (top != group) {
      group = top;
      const std::string title = top.empty()           ? "Top level"
                                : top == "(function)" ? "Functions of time"
                                                      : "`[" + top + "]`";
      text += fmt::format("\n### {}\n\n| key | value | default | meaning |\n|---|---|---|---|\n",
                          title);
    }
    Key plain = key;
    plain.unit = "";
    std::string value = cell(expectation(plain));
    if (!key.unit.empty()) value += fmt::format(", {}", cell(key.unit));
    text +=
        fmt::format("| `{}` | {} | {} | {} |\n", key.path, value, preset_text(key), doc_text(key));
  }
  return text;
}

}  // namespace

std::string schema_markdown() {
  std::string page = R"(# Scenes, studies, batches and comparisons: every key

<!-- Generated from apps/input/schema_*.cpp; do not edit. -->

Scenes, studies, batches and comparisons are [TOML](https://toml.io) files. All quantities are in SI units, all vectors in
inertial axes unless the key says otherwise. `*` stands for a name that you choose; names have no dots
and are used once among bodies, joints, forces and loads. "One of": exactly one of the keys so marked
in a table. Lists of numbers refuse `nan` and `inf`; whole numbers may be written for numbers.

**Ports** are places on bodies: `ground`, `ground.<point>`, and for a body `x` a beam's `x.start`, `x.end`, `x.mid`
(even number of elements), `x.node3` (from 0) and `x.<point>`, a rigid body's `x.origin` and
`x.<point>`, a meshed part's `x.<interface>`.

**In statics and modes** drives, tables and expressions have their value at `simulation.at`. Weight, loads and forces of
`forces.*.force` are multiplied by the load factor, up to `max_load`; springs and drives are not. Velocities, dampers and
`damping` do nothing; nor do the keys marked "Dynamic".

**Changing keys from the command line:** `--set key.path=value`, as in `--set simulation.step=5e-5`,
`--set bodies.rod.beam.elements=16`, `--set bodies.rod.beam.to.0=0.5` (entry of a list). The value is
TOML; a word that is no TOML value is a string. Used with a study, a key of the study is changed
first; a key that only scenes have goes to the scene; `scene.` in front always means the scene
(`--set scene.name=test`).

## Scenes
)";
  page += tables(schema(FileKind::Scene));
  page += "\n## Studies\n\nConstraints are given like responses of a scene, or name one (`use`).\n";
  page += tables(schema(FileKind::Study));
  page += "\n## Batches\n\n";
  page +=
      "Many cases of one study or scene. `--set` changes keys of the batch first, then those of ";
  page += "all its cases.\n";
  page += tables(schema(FileKind::Batch));
  page += "\n## Comparisons\n\n";
  page += "One scene under many formalisms, meshes and steps, for `liesl compare`.\n";
  page += tables(schema(FileKind::Comparison));
  page += "\n## Sensitivities\n\n";
  page += "By which numbers of a scene its motion is differentiated, for `liesl sensitivity`.\n";
  page += tables(schema(FileKind::Sensitivity));
  return page;
}

}  // namespace liesl
