#pragma once
/// @file
/// What is wrong with an input file, where, and what to do about it.

#include <toml++/toml.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace liesl {

/// One thing that a user has to mend.
struct InputProblem {
  std::string file;
  int line = 0;  ///< from 1; 0 if the problem has no place in the file
  int column = 0;
  std::string what;
  std::string expected;  ///< may be empty
  std::string hint;      ///< may be empty

  /// "file:line:column: what; expected ...; hint: ..."; the middle of very long parts is left out.
  std::string text() const;
};

/// Input refused. Holds every problem of the file, in the order of the file.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<InputProblem> problems);
  std::vector<InputProblem> problems;
};

/// Was a value written in a file or override, rather than put in as a default?
inline bool written(const toml::node& node) { return node.source().path != nullptr; }

/// Collects problems while a file is read.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  /// Adds a problem at a value, or at the start of the file if the value came from no file.
  void add(const toml::node& at, std::string what, std::string expected = "",
           std::string hint = "");
  /// Adds a problem at a key.
  void add(const toml::key& at, std::string what, std::string expected = "", std::string hint = "");
  void add(InputProblem problem) { problems_.push_back(std::move(problem)); }

  /// Is there a problem at this value already?
  bool has(const toml::node& at) const;
  int count() const { return static_cast<int>(problems_.size()); }
  const std::string& file() const { return file_; }
  /// @throws InputError if there are any, sorted by place.
  void throw_if_any() const;

 private:
  void add(const toml::source_region& at, std::string what, std::string expected, std::string hint);

  std::string file_;
  std::vector<InputProblem> problems_;
};

/// Number of insertions, deletions, replacements and swaps of neighbours between two words,
/// regardless of case.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to a name, empty if none is near enough to be meant.
std::string nearest(std::string_view name, const std::vector<std::string>& candidates);

/// "did you mean 'x'?" or "known: a, b, c" or, without candidates, `otherwise`.
std::string suggestion(std::string_view name, const std::vector<std::string>& candidates,
                       std::string_view otherwise = "");

}  // namespace liesl
