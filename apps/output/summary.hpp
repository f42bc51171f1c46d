#pragma once
/// @file
/// summary.json: what a command did, why it stopped, and the figures. The keys are an interface,
/// documented in docs/outputs.md.

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/output/results.hpp"

namespace liesl::output {

/// A response in three figures.
struct ResponseFigure {
  std::string name, unit;
  double max_abs = 0;         ///< largest |value| over all accepted steps, the norm for vectors
  double at_time = 0;         ///< where that is
  std::vector<double> final;  ///< value of the last record, one number a component
  std::string axes = {};      ///< letters of the components, see ResponseResult
  std::optional<double> error_mesh = {}, error_step = {};  ///< of max_abs, if it was verified
  std::optional<double> error_total = {};                  ///< of both, with their signs
  double missed = 0, between = 0;                          ///< of Peak
  std::optional<double> end_error_mesh = {}, end_error_step = {};  ///< of `final`
  std::optional<double> end_error_total = {};                      ///< of both, as vectors
};

/// Of a recorded series; zeros if it is empty.
ResponseFigure response_figure(const ResponseResult& response, const std::vector<double>& times);

struct RunSummary {
  std::string command = "run";
  std::string name;                                          ///< of the scene or study
  std::string status, reason;                                ///< one word or two; one sentence
  std::string space, space_reason;                           ///< "planar" | "spatial", and why
  int steps = 0;                                             ///< accepted
  long newton_iterations = 0;                                ///< over all steps
  std::vector<std::pair<std::string, long>> factorizations;  ///< by body
  double stepping_s = 0;                                     ///< time stepping alone
  double wall_s = 0;                                         ///< from the start of the program
  std::vector<ResponseFigure> responses;
  std::vector<std::string> warnings;
  std::vector<std::string> overrides;  ///< the --set arguments
  std::string input_sha256;            ///< of the input files' bytes, scene after study
  nlohmann::ordered_json more;         ///< object: further keys, put before `warnings`
};

/// A limit and how it fared over every step of the true dynamic response.
struct ConstraintFigure {
  std::string name, response, unit;
  double limit = 0;
  double max_abs_initial = 0, max_abs_final = 0;
  double at_time = 0;    ///< of max_abs_final
  double violation = 0;  ///< max_abs_final / limit - 1: negative inside
  std::optional<double> error_mesh = {}, error_step = {};  ///< of max_abs_final, if verified
};

struct DesignFigure {
  std::string name;  ///< "rod_diameters[0]"
  double initial = 0, final = 0, lower = 0, upper = 0;
  std::string unit = "m";
};

/// A limit in a cycle.
struct CycleLimit {
  std::string name;
  double violation = 0;  ///< largest |r|/limit - 1, negative inside
  std::string at;        ///< where: "t = 0.1 s", a load case; empty: everywhere
};

/// One turn of the cycle: the design that was simulated, and what followed.
struct CycleRecord {
  int cycle = 0;
  double mass = 0;                    ///< kg, of the design at the start of the cycle
  double worst_constraint = 0;        ///< of its dynamic response, relative, negative inside
  std::optional<double> load_change;  ///< relative to the cycle before; none in the first
  int load_cases = 0;                 ///< kept by the screening
  int optimizer_iterations = 0;
  double move_limit = 0;
  double wall_s = 0;
  std::optional<double> objective = {};  ///< where it is not the mass
  std::vector<double> design = {};       ///< that was simulated, in the order of `design`
  std::string worst_limit = {};          ///< which one `worst_constraint` is of
  std::string worst_at = {};             ///< and where: "t = 0.1 s", a load case
  std::vector<CycleLimit> limits = {};   ///< all of that simulation
};

struct OptimizeSummary : RunSummary {
  double mass_initial = 0, mass_final = 0;  ///< kg
  double worst_constraint = 0;
  std::optional<double> load_change;  ///< of the last cycle; none if it cannot be compared
  std::vector<DesignFigure> design;
  std::vector<ConstraintFigure> constraints;
  std::vector<CycleRecord> history;
};

/// With peak memory and versions added. Numbers that are not finite become null.
nlohmann::ordered_json to_json(const RunSummary& summary);
nlohmann::ordered_json to_json(const OptimizeSummary& summary);

/// Of a batch: how many of its cases ended how.
struct BatchSummary {
  std::string name;
  std::string status, reason;
  int cases = 0;                                   ///< of the batch
  int done = 0, failed = 0;                        ///< cases that have ended; of those
  std::vector<std::pair<std::string, int>> ended;  ///< status -> cases
  std::vector<std::pair<std::string, std::string>> input_units;  ///< columns whose unit is known
  int jobs = 1;                                                  ///< processes at once
  std::string shard;  ///< "i/n" as asked for; empty: all cases
  double wall_s = 0;  ///< of this command
  double cpu_s = 0;   ///< of all processes of all cases
  std::vector<std::string> warnings, overrides;
  std::string input;  ///< file, as it was named
  std::string input_sha256;
};
nlohmann::ordered_json to_json(const BatchSummary& summary);

/// What the rows of a comparison are measured against.
struct ReferenceFigure {
  std::vector<std::string> changes;  ///< that make it another motion; none for the scene's
  std::array<std::string, 2> formalisms;
  double floor = 0;  ///< distance of the two, in the norm
  double size = 0;   ///< norm of their mean
};

/// A formalism against the first of a comparison.
struct FormalismRatio {
  std::string formalism, to;
  int pairs = 0;                      ///< of rows alike in all else
  std::optional<double> error, time;  ///< medians of the pairs; empty without figures
};

struct CompareSummary {
  std::string name;
  std::string status, reason;
  std::string response, unit, norm;
  int rows = 0, done = 0;                          ///< of the grid; of those that have ended
  std::vector<std::pair<std::string, int>> ended;  ///< status -> rows
  std::vector<ReferenceFigure> references;
  std::vector<FormalismRatio> ratios;
  double wall_s = 0;
  std::vector<std::string> warnings, overrides;
  std::string input;  ///< file, as it was named
  std::string input_sha256;
};
nlohmann::ordered_json to_json(const CompareSummary& summary);

/// The words behind "liesl" that the program was started with: `arguments` of every summary from
/// now on. Without them, as in Python, the key is left out.
void set_arguments(std::vector<std::string> words);

/// Keys that every summary ends with: `warnings`, `overrides`, `arguments`, `versions`,
/// `input_sha256`.
void add_tail(nlohmann::ordered_json& json, const std::vector<std::string>& warnings,
              const std::vector<std::string>& overrides, const std::string& input_sha256);

/// As a text file, indented. @throws IoError
void write_summary(const std::filesystem::path& path, const nlohmann::ordered_json& summary);

/// Largest memory this process has used so far, MB.
double peak_memory_mb();

}  // namespace liesl::output
