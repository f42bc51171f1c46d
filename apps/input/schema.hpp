#pragma once
/// @file
/// Every key of scenes and studies as data: type, unit, default, range, options, meaning.
/// It drives validation, defaults, error messages and docs/scene_reference.md.

#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace liesl {

/// Type of a value. `Key::size` says how many numbers where it varies.
enum class Type {
  Text,    ///< string
  Choice,  ///< string out of `Key::options`
  Boolean,
  Integer,
  Number,
  Vector,          ///< list of `size` numbers
  NumberOrList,    ///< number, or list of `size` numbers (0 = one or more)
  Rows,            ///< two or more rows of `size` numbers
  Matrix,          ///< `size` numbers (diagonal) or `size` rows of `size`; inertia also 6 numbers
  NumberOrMatrix,  ///< number, or `size` numbers, or `size` rows of `size`; the range is of numbers
  Texts,           ///< string or list of strings
  Pair,            ///< list of two strings
  Function,        ///< number, string (expression of t) or table (keys: `(function).*`)
  Table,           ///< table with the keys of the schema
  TableOrList,     ///< table or list of tables
  Named,           ///< table whose keys are names that the user chooses
  List,            ///< list of one or more values, of whatever the keys it is for ask for
  Any,             ///< whatever the key named by the user asks for
  Point            ///< list of 2 or 3 numbers: in the plane or in space
};

/// Interval of allowed numbers; an open end excludes its bound.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool open_lower = false;
  bool open_upper = false;

  bool contains(double x) const;
  std::string text() const;  ///< "> 0", "in [0, 1]", ""
};

inline constexpr Range kAny{};
inline constexpr Range kPositive{.lower = 0, .open_lower = true};
inline constexpr Range kNotNegative{.lower = 0};

/// Values of `Key::preset` that are not a default.
inline constexpr std::string_view kRequired = "!";
inline constexpr std::string_view kOptional = "";
/// Exactly one of the keys of a table that carry this must be given.
inline constexpr std::string_view kOneOf = "|";

struct Key {
  std::string path;  ///< "bodies.*.beam.from"; `*` is a name of the user
  Type type = Type::Table;
  std::string_view unit = {};
  std::string_view preset = {};  ///< kRequired, kOptional, kOneOf, or the default as TOML text
  Range range = {};
  std::string doc = {};
  int size = 0;
  std::string_view options = {};  ///< of a Choice, separated by blanks
  std::string_view when = {};     ///< "type=circle tube": only if the sibling key has such a value

  std::string_view parent() const;  ///< "" for a top-level key
  std::string_view leaf() const;
};

/// Kinds of file: a mechanism, a task on it, many cases of either, a mechanism under many
/// formalisms, by what a motion is differentiated.
enum class FileKind { Scene, Study, Batch, Comparison, Sensitivity };
inline constexpr std::array kFileKinds = {FileKind::Scene, FileKind::Study, FileKind::Batch,
                                          FileKind::Comparison, FileKind::Sensitivity};
/// "scene", "study", "batch", "comparison", "sensitivity"
std::string_view name_of(FileKind kind);
const std::vector<Key>& schema(FileKind kind);

/// Keys directly below a path pattern ("" = top level). `(function).*` for functions of time.
std::vector<const Key*> children(FileKind kind, std::string_view parent);
/// The key of a pattern, nullptr if there is none.
const Key* find_key(FileKind kind, std::string_view pattern);
/// Pattern of the key `part` in a table; empty if there is none.
std::string pattern_below(FileKind kind, const std::string& pattern, const std::string& part);
/// Unit of the value at a path, "sections.rod.diameter"; empty if there is no such key.
std::string_view unit_at(FileKind kind, const std::string& path);

/// Words of a blank-separated list.
std::vector<std::string> words(std::string_view text);

/// What a value of this key looks like, for messages and the reference: "a number > 0 (m)".
std::string expectation(const Key& key);

/// JSON Schema (draft 7) of a kind of file, for editors.
std::string schema_json(FileKind kind);

/// The reference page of all kinds of file, docs/scene_reference.md.
std::string schema_markdown();

/// Parts of the tables, in the order of the page.
std::vector<Key> scene_keys();
std::vector<Key> study_keys();
std::vector<Key> batch_keys();
std::vector<Key> compare_keys();
std::vector<Key> sensitivity_keys();
std::vector<Key> solid_keys();
std::vector<Key> joint_keys();
std::vector<Key> response_keys(std::string_view parent);
std::vector<Key> function_keys();

}  // namespace liesl
