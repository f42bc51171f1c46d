#ifdef LIESL_OPTIM

#include "apps/cli/checkpoint.hpp"

#include <nlohmann/json.hpp>

#include "apps/input/problem.hpp"
#include "apps/output/file.hpp"

namespace liesl {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> numbers(const Eigen::VectorXd& x) { return {x.data(), x.data() + x.size()}; }

Eigen::VectorXd vector(const Json& list) {
  const auto v = list.get<std::vector<double>>();
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<long>(v.size()));
}

Json to_json(const NlpWarmStart& warm) {
  Json ids = Json::array(), multipliers = Json::array();
  for (const auto& [id, multiplier] : warm.multipliers) {
    ids.push_back(id);
    multipliers.push_back(multiplier);
  }
  return {{"ids", ids},
          {"multipliers", multipliers},
          {"lower", numbers(warm.lower)},
          {"upper", numbers(warm.upper)}};
}

NlpWarmStart read_warm(const Json& j) {
  NlpWarmStart warm;
  const auto ids = j.at("ids").get<std::vector<ConstraintId>>();
  const auto multipliers = j.at("multipliers").get<std::vector<double>>();
  for (std::size_t k = 0; k < ids.size() && k < multipliers.size(); ++k)
    warm.multipliers[ids[k]] = multipliers[k];
  warm.lower = vector(j.at("lower"));
  warm.upper = vector(j.at("upper"));
  return warm;
}

Json to_json(const SimulationEffort& e) {
  return {{"steps", e.steps},
          {"newton_iterations", e.newton_iterations},
          {"sensitivities", e.sensitivities},
          {"stepping_s", e.stepping_s},
          {"factorizations", e.factorizations}};
}

Json to_json(const std::vector<CycleLoads>& parts) {
  Json list = Json::array();
  for (const CycleLoads& part : parts) {
    Json loads = Json::array();
    for (const CycleLoads::Load& load : part.loads)
      loads.push_back(std::vector<double>(load.data(), load.data() + load.size()));
    list.push_back({{"body", part.body},
                    {"scenario", part.scenario},
                    {"times", part.times},
                    {"loads", std::move(loads)}});
  }
  return list;
}

std::vector<CycleLoads> read_loads(const Json& list) {
  std::vector<CycleLoads> parts;
  for (const Json& j : list) {
    CycleLoads& part = parts.emplace_back();
    part.body = j.at("body");
    part.scenario = j.at("scenario");
    part.times = j.at("times").get<std::vector<double>>();
    for (const Json& values : j.at("loads")) {
      const auto v = values.get<std::vector<double>>();
      part.loads.push_back(
          CycleLoads::Load::Map(v.data(), 6, static_cast<Eigen::Index>(v.size() / 6)));
    }
  }
  return parts;
}

Json to_json(const std::vector<LimitExcess>& limits) {
  Json list = Json::array();
  for (const LimitExcess& l : limits)
    list.push_back({{"name", l.name}, {"excess", l.excess}, {"at", l.at}});
  return list;
}

std::vector<LimitExcess> read_excesses(const Json& j) {
  std::vector<LimitExcess> limits;
  for (const Json& l : j) limits.push_back({l.at("name"), l.at("excess"), l.at("at")});
  return limits;
}

Json to_json(const Cycle& c) {
  Json cycle = {{"number", c.number},
                {"start", c.start},
                {"x", numbers(c.x)},
                {"answer", numbers(c.answer)},
                {"next", numbers(c.next)},
                {"lower", numbers(c.lower)},
                {"upper", numbers(c.upper)},
                {"unit", numbers(c.unit)},
                {"mass", c.mass},
                {"objective", c.objective},
                {"worst", c.worst},
                {"worst_constraint", c.worst_constraint},
                {"worst_at", c.worst_at},
                {"limits", to_json(c.excesses)},
                {"load_cases", c.load_cases},
                {"loads", to_json(c.loads)},
                {"iterations", c.iterations},
                {"move", c.move},
                {"taken", c.taken},
                {"penalty", c.penalty},
                {"maxima", c.maxima},
                {"before", numbers(c.before)},
                {"warm", to_json(c.warm)},
                {"effort", to_json(c.effort)},
                {"seconds", c.seconds}};
  if (c.load_change) cycle["load_change"] = *c.load_change;
  if (c.end) cycle["end"] = to_string(*c.end);
  return cycle;
}

Cycle read_cycle(const Json& j) {
  Cycle c;
  c.number = j.at("number");
  c.start = j.at("start");
  c.x = vector(j.at("x"));
  c.answer = vector(j.at("answer"));
  c.next = vector(j.at("next"));
  c.lower = vector(j.at("lower"));
  c.upper = vector(j.at("upper"));
  c.unit = vector(j.at("unit"));
  c.mass = j.at("mass");
  c.objective = j.at("objective");
  c.worst = j.at("worst");
  c.worst_constraint = j.at("worst_constraint");
  c.worst_at = j.at("worst_at");
  if (j.contains("limits")) c.excesses = read_excesses(j.at("limits"));
  if (j.contains("load_change")) c.load_change = j.at("load_change").get<double>();
  c.load_cases = j.at("load_cases");
  if (j.contains("loads")) c.loads = read_loads(j.at("loads"));
  c.iterations = j.at("iterations");
  c.move = j.at("move");
  c.taken = j.at("taken");
  c.penalty = j.at("penalty");
  c.maxima = j.at("maxima").get<std::vector<std::set<int>>>();
  if (j.contains("before")) c.before = vector(j.at("before"));
  c.warm = read_warm(j.at("warm"));
  const Json& effort = j.at("effort");
  c.effort = {effort.at("steps"), effort.at("newton_iterations"), effort.at("stepping_s"),
              effort.at("factorizations"), effort.value("sensitivities", 0L)};
  c.seconds = j.at("seconds");
  if (j.contains("end")) c.end = cycle_status(j.at("end"));
  return c;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const ModelHistory& models,
                      const std::string& input_sha256) {
  Json file;
  file["input_sha256"] = input_sha256;
  for (const RoundHistory& model : models) {
    Json& rounds = file["models"].emplace_back(Json::array());
    for (const auto& round : model) {
      Json& cycles = rounds.emplace_back(Json::array());
      for (const Cycle& c : round) cycles.push_back(to_json(c));
    }
  }
  output::write_file(path, file.dump(1));
}

ModelHistory read_checkpoint(const std::filesystem::path& path, const std::string& input_sha256) {
  const auto refuse = [&](const std::string& what) {
    throw InputError({{path.string(), 0, 0, what,
                       "the checkpoint of an interrupted run with the same study, scene and --set",
                       "run without --resume"}});
  };
  if (!std::filesystem::exists(path))
    throw InputError(
        {{path.parent_path().string(), 0, 0, "--resume: there is no interrupted run in this folder",
          "the folder (-o) of an interrupted run, with its checkpoint.json",
          "to begin anew, run without --resume"}});
  const std::string text = output::read_file(path);
  ModelHistory models;
  try {
    const Json file = Json::parse(text);
    if (file.at("input_sha256") != input_sha256) refuse("the checkpoint belongs to another input");
    for (const auto& rounds : file.at("models")) {
      RoundHistory& model = models.emplace_back();
      for (const auto& cycles : rounds) {
        auto& round = model.emplace_back();
        for (const auto& j : cycles) round.push_back(read_cycle(j));
      }
    }
  } catch (const Json::exception& e) {
    refuse(std::string("the checkpoint cannot be read: ") + e.what());
  }
  return models;
}

}  // namespace liesl

#endif
