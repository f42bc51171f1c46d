#include "apps/output/map_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/output/csv_writer.hpp"
#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_file.hpp"
#include "apps/output/hdf5_writer.hpp"
#include "apps/output/summary.hpp"

namespace liesl::output {
namespace {

using Json = nlohmann::ordered_json;

TextColumn column(const std::string& name, const std::string& unit,
                  const std::vector<double>& values) {
  TextColumn out{name, unit, {}};
  for (const double v : values) out.cells.push_back(cell(v));
  return out;
}

/// Least and largest of what has a value.
Json range(const std::vector<double>& values) {
  Json json = nullptr;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    if (json.is_null()) json = {v, v};
    json[0] = std::min(json[0].get<double>(), v);
    json[1] = std::max(json[1].get<double>(), v);
  }
  return json;
}

}  // namespace

void write_map_csv(const std::filesystem::path& path, const DesignMap& map) {
  std::vector<double> x, y;
  for (const double v : map.axes[1].values)
    for (const double u : map.axes[0].values) {
      x.push_back(u);
      y.push_back(v);
    }
  std::vector<TextColumn> columns{column(map.axes[0].name, map.axes[0].unit, x),
                                  column(map.axes[1].name, map.axes[1].unit, y)};
  for (const DesignMap::Quantity& q : map.of) {
    columns.push_back(column(q.name, q.unit, q.global));
    if (!q.local.empty()) columns.push_back(column(q.name + " local", q.unit, q.local));
  }
  columns.push_back({"reason", "", map.reasons});
  write_file(path, columns_csv(columns));
}

void write_path_csv(const std::filesystem::path& path, const DesignMap& map) {
  std::vector<TextColumn> columns{{"cycle", "", {}},
                                  {map.axes[0].name, map.axes[0].unit, {}},
                                  {map.axes[1].name, map.axes[1].unit, {}}};
  for (const DesignMap::Stop& stop : map.path) {
    columns[0].cells.push_back(fmt::format("{}", stop.cycle));
    for (const std::size_t k : {0, 1}) columns[k + 1].cells.push_back(cell(stop.at[k]));
  }
  write_file(path, columns_csv(columns));
}

void write_map_h5(const std::filesystem::path& path, const DesignMap& map) {
  const hsize_t nx = map.axes[0].values.size(), ny = map.axes[1].values.size();
  Hdf5File file(path);
  file.attribute("/", "program", "liesl");
  for (const std::size_t k : {0, 1}) {
    const DesignMap::Axis& axis = map.axes[k];
    const std::string name = k == 0 ? "/x" : "/y";
    file.write(name, axis.values, {axis.values.size()});
    file.attribute(name, "name", axis.name);
    file.attribute(name, "unit", axis.unit);
  }
  file.group("/global");
  file.group("/local");
  for (const DesignMap::Quantity& q : map.of)
    for (const auto& [group, values] :
         {std::pair{"/global/", &q.global}, std::pair{"/local/", &q.local}}) {
      if (values->empty()) continue;
      const std::string name = group + hdf5_name(q.name);
      file.write(name, *values, {ny, nx});
      file.attribute(name, "unit", q.unit);
      if (q.limit) file.attribute(name, "limit", cell(*q.limit));
    }
  if (!map.path.empty()) {
    std::vector<int> cycles;
    std::vector<double> at;
    for (const DesignMap::Stop& stop : map.path) {
      cycles.push_back(stop.cycle);
      at.insert(at.end(), stop.at.begin(), stop.at.end());
    }
    file.group("/path");
    file.write("/path/cycle", cycles, {cycles.size()});
    file.write("/path/at", at, {cycles.size(), 2});
  }
  file.close();
}

nlohmann::ordered_json to_json(const MapSummary& s, const DesignMap& map) {
  Json json = {{"command", "map"},   {"name", s.name},       {"status", s.status},
               {"reason", s.reason}, {"designs", s.designs}, {"failed", s.failed},
               {"local", s.local}};
  json["over"] = Json::object();
  for (const DesignMap::Axis& axis : map.axes)
    json["over"][axis.name] = {{"from", axis.values.front()},
                               {"to", axis.values.back()},
                               {"points", axis.values.size()},
                               {"unit", axis.unit}};
  json["of"] = Json::object();
  for (const DesignMap::Quantity& q : map.of)
    json["of"][q.name] = {{"unit", q.unit},
                          {"limit", q.limit ? Json(*q.limit) : Json(nullptr)},
                          {"range", range(q.global)}};
  json["centre"] = Json::object();
  for (const auto& [name, value] : map.centre) json["centre"][name] = value;
  json["wall_s"] = s.wall_s;
  json["peak_memory_mb"] = peak_memory_mb();
  json["input"] = s.input;
  add_tail(json, s.warnings, s.overrides, s.input_sha256);
  return json;
}

}  // namespace liesl::output
