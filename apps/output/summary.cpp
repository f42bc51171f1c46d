#include "apps/output/summary.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>

#include "apps/output/file.hpp"
#include "apps/output/versions.hpp"

namespace liesl::output {
namespace {

using Json = nlohmann::ordered_json;

/// A number for scalars, a list for vectors.
Json number_or_list(const std::vector<double>& values) {
  return values.size() == 1 ? Json(values[0]) : Json(values);
}

Json responses_json(const std::vector<ResponseFigure>& responses) {
  Json json = Json::object();
  for (const auto& r : responses) {
    json[r.name] = {{"max_abs", r.max_abs},
                    {"at_time", r.at_time},
                    {"final", number_or_list(r.final)},
                    {"unit", r.unit}};
    if (!r.axes.empty()) json[r.name]["axes"] = r.axes;
    if (r.error_mesh) json[r.name]["error"]["mesh"] = *r.error_mesh;
    if (r.error_step) json[r.name]["error"]["step"] = *r.error_step;
    if (r.error_total) json[r.name]["error"]["total"] = *r.error_total;
    if (r.end_error_mesh) json[r.name]["error"]["end"]["mesh"] = *r.end_error_mesh;
    if (r.end_error_step) json[r.name]["error"]["end"]["step"] = *r.end_error_step;
    if (r.end_error_total) json[r.name]["error"]["end"]["total"] = *r.end_error_total;
  }
  return json;
}

/// Keys of both commands up to the point where those of `optimize` come in.
Json head(const RunSummary& s) {
  Json factorizations = Json::object();
  for (const auto& [body, count] : s.factorizations) factorizations[body] = count;
  return {{"command", s.command},
          {"name", s.name},
          {"status", s.status},
          {"reason", s.reason},
          {"space", s.space},
          {"space_reason", s.space_reason},
          {"steps", s.steps},
          {"newton_iterations", s.newton_iterations},
          {"factorizations", factorizations},
          {"stepping_s", s.stepping_s},
          {"wall_s", s.wall_s},
          {"peak_memory_mb", peak_memory_mb()},
          {"responses", responses_json(s.responses)}};
}

/// Keys that have another name now keep the old one beside it: {new, old} at the top, and of each
/// hole that was tried. Only where the old name has no other meaning in the same object.
void keep_old_keys(Json& json) {
  const auto keep = [](Json& object, const char* now, const char* old) {
    if (object.contains(now)) object[old] = object[now];
  };
  keep(json, "terms", "goals");
  if (json.contains("nucleation"))
    for (Json& hole : json["nucleation"]["tried"]) keep(hole, "cycles", "steps");
}

void add_tail(Json& json, const RunSummary& s) {
  if (s.more.is_object()) json.update(s.more);
  keep_old_keys(json);
  output::add_tail(json, s.warnings, s.overrides, s.input_sha256);
}

Json constraints_json(const std::vector<ConstraintFigure>& constraints) {
  Json json = Json::object();
  for (const auto& c : constraints) {
    json[c.name] = {{"response", c.response},
                    {"limit", c.limit},
                    {"unit", c.unit},
                    {"max_abs_initial", c.max_abs_initial},
                    {"max_abs_final", c.max_abs_final},
                    {"at_time", c.at_time},
                    {"violation", c.violation}};
    if (c.error_mesh) json[c.name]["error"]["mesh"] = *c.error_mesh;
    if (c.error_step) json[c.name]["error"]["step"] = *c.error_step;
  }
  return json;
}

Json history_json(const std::vector<CycleRecord>& history) {
  Json json = Json::array();
  for (const auto& h : history) {
    json.push_back({{"cycle", h.cycle},
                    {"mass", h.mass},
                    {"worst_constraint", h.worst_constraint},
                    {"load_change", h.load_change ? Json(*h.load_change) : Json(nullptr)},
                    {"load_cases", h.load_cases},
                    {"optimizer_iterations", h.optimizer_iterations},
                    {"move_limit", h.move_limit},
                    {"wall_s", h.wall_s}});
    if (h.objective) json.back()["objective"] = *h.objective;
    if (!h.design.empty()) json.back()["design"] = h.design;
    if (h.worst_limit.empty()) continue;
    json.back()["worst_limit"] = h.worst_limit;
    json.back()["worst_at"] = h.worst_at;
    for (const CycleLimit& l : h.limits)
      json.back()["limits"][l.name] = {{"violation", l.violation}, {"at", l.at}};
  }
  return json;
}

std::vector<std::string>& arguments() {
  static std::vector<std::string> words;
  return words;
}

}  // namespace

void set_arguments(std::vector<std::string> words) { arguments() = std::move(words); }

void add_tail(Json& json, const std::vector<std::string>& warnings,
              const std::vector<std::string>& overrides, const std::string& input_sha256) {
  json["warnings"] = warnings;
  json["overrides"] = overrides;
  if (!arguments().empty()) json["arguments"] = arguments();
  json["versions"] = Json::object();
  for (const auto& [name, version] : versions()) json["versions"][name] = version;
  json["input_sha256"] = input_sha256;
}

ResponseFigure response_figure(const ResponseResult& response, const std::vector<double>& times) {
  ResponseFigure figure{response.name, response.unit, 0, 0, {}};
  const auto C = static_cast<std::size_t>(response.components);
  const std::size_t n = C > 0 ? std::min(times.size(), response.values.size() / C) : 0;
  for (std::size_t i = 0; i < n; ++i) {
    double squares = 0;
    for (std::size_t c = 0; c < C; ++c) squares += std::pow(response.values[i * C + c], 2);
    const double size = std::sqrt(squares);
    if (i == 0 || size > figure.max_abs) {
      figure.max_abs = size;
      figure.at_time = times[i];
    }
  }
  if (response.peak && response.peak->size > figure.max_abs) {
    figure.max_abs = response.peak->size;
    figure.at_time = response.peak->at;
  }
  if (response.peak) {
    figure.missed = response.peak->missed;
    figure.between = response.peak->between;
  }
  figure.axes = response.axes;
  if (n > 0) {
    const double* last = response.values.data() + (n - 1) * C;
    figure.final.assign(last, last + C);
  }
  return figure;
}

Json to_json(const RunSummary& summary) {
  Json json = head(summary);
  add_tail(json, summary);
  return json;
}

Json to_json(const OptimizeSummary& s) {
  Json json = head(s);
  json["cycles"] = s.history.size();
  json["mass_initial"] = s.mass_initial;
  json["mass_final"] = s.mass_final;
  json["worst_constraint"] = s.worst_constraint;
  json["load_change"] = s.load_change ? Json(*s.load_change) : Json(nullptr);
  json["design"] = Json::object();
  json["design_range"] = Json::object();
  for (const auto& d : s.design) {
    json["design"][d.name] = d.final;
    json["design_range"][d.name] = {
        {"initial", d.initial}, {"lower", d.lower}, {"upper", d.upper}, {"unit", d.unit}};
  }
  json["constraints"] = constraints_json(s.constraints);
  json["history"] = history_json(s.history);
  add_tail(json, s);
  return json;
}

Json to_json(const BatchSummary& s) {
  Json json = {{"command", "batch"}, {"name", s.name}, {"status", s.status}, {"reason", s.reason},
               {"cases", s.cases},   {"done", s.done}, {"failed", s.failed}};
  json["ended"] = Json::object();
  for (const auto& [status, count] : s.ended) json["ended"][status] = count;
  json["input_units"] = Json::object();
  for (const auto& [column, unit] : s.input_units) json["input_units"][column] = unit;
  json.update({{"jobs", s.jobs}, {"shard", s.shard}, {"wall_s", s.wall_s}, {"cpu_s", s.cpu_s}});
  json["input"] = s.input;
  add_tail(json, s.warnings, s.overrides, s.input_sha256);
  return json;
}

Json to_json(const CompareSummary& s) {
  Json json = {{"command", "compare"}, {"name", s.name},         {"status", s.status},
               {"reason", s.reason},   {"response", s.response}, {"unit", s.unit},
               {"norm", s.norm},       {"rows", s.rows},         {"done", s.done}};
  json["ended"] = Json::object();
  for (const auto& [status, count] : s.ended) json["ended"][status] = count;
  json["references"] = Json::array();
  for (const ReferenceFigure& r : s.references)
    json["references"].push_back({{"changes", r.changes},
                                  {"formalisms", r.formalisms},
                                  {"floor", r.floor},
                                  {"size", r.size}});
  json["ratios"] = Json::array();
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  for (const FormalismRatio& r : s.ratios)
    json["ratios"].push_back({{"formalism", r.formalism},
                              {"to", r.to},
                              {"pairs", r.pairs},
                              {"error", number(r.error)},
                              {"time", number(r.time)}});
  json["wall_s"] = s.wall_s;
  json["input"] = s.input;
  add_tail(json, s.warnings, s.overrides, s.input_sha256);
  return json;
}

void write_summary(const std::filesystem::path& path, const Json& summary) {
  // Names come from files: bytes that are not UTF-8 are replaced, not thrown at.
  write_file(path, summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in kB
}

}  // namespace liesl::output
