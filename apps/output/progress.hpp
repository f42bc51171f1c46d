#pragma once
/// @file
/// One live line on terminals: what runs, how far it is, how fast, how long still.

#include <chrono>
#include <cstdio>
#include <string>

namespace liesl::output {

/// Silent in pipes and with `quiet`. Costs a look at the clock per update; prints ten times a
/// second at most, to stderr.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// For `total` units of work, e.g. ("simulating", 1200, "steps", quiet).
  Progress(std::string label, double total, std::string unit, bool quiet);
  /// For tests and other places to print to.
  Progress(std::string label, double total, std::string unit, std::FILE* out);
  ~Progress();  ///< clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of `total`; `note` is put behind, e.g. "cycle 3".
  void update(double done, const std::string& note = "");
  /// Takes the live line away, before something else is printed.
  void clear();
  /// A line that stays, above the live one. Printed in pipes too, unless quiet.
  void say(const std::string& line);

  /// The text of the live line, for `seconds` since the start.
  std::string line(double done, double seconds, const std::string& note) const;

 private:
  std::string label_, unit_;
  double total_;
  std::FILE* out_;  ///< null: say nothing at all
  bool live_;       ///< out_ is a terminal
  bool shown_ = false;
  Clock::time_point start_, next_;
};

}  // namespace liesl::output
