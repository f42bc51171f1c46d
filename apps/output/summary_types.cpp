#include "apps/output/summary_types.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace liesl::output {
namespace {

using Json = nlohmann::ordered_json;

enum class Type { Text, Number, Flag, Numbers, List, Object, ObjectOrNull };

/// Paths of keys: `*` is any name in an object, `[]` any entry of a list; what they go through is
/// in the table, too. A number may be null; numbers are one, or a list of them.
constexpr struct {
  Type type;
  const char* paths;
} kTypes[] = {
    {Type::Text,
     "command name status reason space space_reason input input_sha256 versions.* files.* "
     "warnings[] overrides[] arguments[] "
     "responses.*.unit responses.*.axes "
     "constraints.*.response constraints.*.unit design_range.*.unit "
     "objective.quantity objective.unit terms.*.quantity terms.*.unit history[].worst_limit "
     "history[].worst_at "
     "history[].limits.*.at kkt "
     "load_cases[] supports[].place supports[].held fixed_loads[].name fixed_loads[].load_case "
     "fixed_loads[].place scenarios[] design_files.* nucleation.reason nucleation.gain_unit "
     "method parameters.*.unit gradients.*.*.unit "
     "shard input_units.* "
     "response unit norm references[].changes[] references[].formalisms[] "
     "ratios[].formalism ratios[].to "
     "local over.*.unit of.*.unit "
     "changes[] decisions[].about decisions[].choice decisions[].evidence "
     "lean.space lean.tangent given.space given.tangent reference.space reference.tangent "
     "held_out.space held_out.tangent"},
    {Type::Number,
     "steps newton_iterations factorizations.* stepping_s wall_s cpu_s peak_memory_mb "
     "responses.*.max_abs responses.*.at_time responses.*.error.* "
     "responses.*.error.end.* "
     "tangent_refreshes rejected_steps refused_steps smallest_step max_constraint_residual "
     "mobility "
     "redundant_if_rigid frequencies_hz[] eigenvalues[] critical_loads[].load "
     "parts.*.cells parts.*.modes parts.*.mass parts.*.right_up_to_hz "
     "cycles sensitivities mass_initial mass_final worst_constraint worst_constraint_error "
     "load_change "
     "kkt_residual prices.* design.* design_range.*.initial design_range.*.lower "
     "design_range.*.upper constraints.*.limit constraints.*.max_abs_initial "
     "constraints.*.max_abs_final constraints.*.at_time constraints.*.violation "
     "constraints.*.error.* objective.initial objective.final objective.error.* "
     "terms.*.weight terms.*.initial terms.*.final terms.*.error.* "
     "history[].cycle history[].mass history[].objective history[].worst_constraint "
     "history[].load_change history[].load_cases history[].optimizer_iterations "
     "history[].move_limit history[].wall_s history[].design[] history[].limits.*.violation "
     "refinement.steps[].cycles "
     "nucleation.next.radius nucleation.next.place[] "
     "tolerance sensitivity_s parameters.*.value gradients.*.*.value gradients.*.*.at_time "
     "gradients.*.*.by.* "
     "cases done failed jobs ended.* "
     "rows references[].floor references[].size ratios[].pairs ratios[].error ratios[].time "
     "designs over.*.from over.*.to over.*.points of.*.limit centre.* "
     "error error_given reference_error time_s time_given_s time_reference_s time_held_out_s "
     "corrections_given runs decisions[].figure decisions[].limit "
     "lean.steps lean.step given.steps given.step reference.steps reference.step "
     "held_out.steps held_out.step"},
    {Type::Flag, "critical_loads[].limit_point"},
    {Type::Numbers,
     "responses.*.final of.*.range supports[].points[] fixed_loads[].points[] fixed_loads[].force "
     "fixed_loads[].moment"},
    {Type::List,
     "warnings overrides arguments frequencies_hz eigenvalues critical_loads history "
     "history[].design load_cases supports supports[].points fixed_loads fixed_loads[].points "
     "scenarios "
     "references references[].changes "
     "references[].formalisms ratios "
     "decisions changes refinement.steps nucleation.next.place"},
    {Type::Object,
     "versions files factorizations responses responses.* responses.*.error "
     "responses.*.error.end parts parts.* "
     "constraints constraints.* constraints.*.error design design_range design_range.* objective "
     "objective.error terms terms.* terms.*.error prices history[] identity verification "
     "refinement refinement.steps[] nucleation supports[] fixed_loads[] "
     "critical_loads[] parameters parameters.* gradients gradients.* gradients.*.* "
     "gradients.*.*.by ended input_units references[] ratios[] over over.* of of.* centre lean "
     "lean.beams lean.beams.* given given.beams given.beams.* reference reference.beams "
     "reference.beams.* held_out held_out.beams held_out.beams.* decisions[]"},
    {Type::ObjectOrNull, "nucleation.next"},
};

const std::map<std::string, Type>& types() {
  static const std::map<std::string, Type> all = [] {
    std::map<std::string, Type> out;
    for (const auto& [type, paths] : kTypes) {
      std::istringstream words(paths);
      for (std::string path; words >> path;) out.emplace(path, type);
    }
    return out;
  }();
  return all;
}

bool is_number(const Json& value) { return value.is_number() || value.is_null(); }

bool has_type(const Json& value, Type type) {
  switch (type) {
    case Type::Text:
      return value.is_string();
    case Type::Number:
      return is_number(value);
    case Type::Flag:
      return value.is_boolean();
    case Type::Numbers:
      return is_number(value) ||
             (value.is_array() && std::all_of(value.begin(), value.end(), is_number));
    case Type::List:
      return value.is_array();
    case Type::Object:
      return value.is_object();
    case Type::ObjectOrNull:
      return value.is_object() || value.is_null();
  }
  return false;
}

/// @param path in the table  @param name of the value, for the message
std::string wrong_below(const Json& value, const std::string& path, const std::string& name) {
  const auto type = types().find(path);
  if (type != types().end() && !has_type(value, type->second))
    return fmt::format("'{}' is {}", name, value.type_name());
  std::string wrong;
  if (value.is_object())
    for (auto it = value.begin(); it != value.end() && wrong.empty(); ++it) {
      const std::string start = path.empty() ? "" : path + ".";
      const bool known = types().count(start + it.key()) > 0;
      wrong = wrong_below(it.value(), start + (known ? it.key() : "*"),
                          (name.empty() ? "" : name + ".") + it.key());
    }
  if (value.is_array())
    for (std::size_t i = 0; i < value.size() && wrong.empty(); ++i)
      wrong = wrong_below(value[i], path + "[]", fmt::format("{}[{}]", name, i));
  return wrong;
}

}  // namespace

std::string wrong_type(const Json& summary) { return wrong_below(summary, "", ""); }

}  // namespace liesl::output
