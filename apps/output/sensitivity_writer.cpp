#include "apps/output/sensitivity_writer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "apps/output/csv_writer.hpp"
#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_file.hpp"

namespace liesl::output {
namespace {

/// "m/m"; compound units in brackets.
std::string ratio(const std::string& of, const std::string& by) {
  if (by.empty() || by == "-") return of;
  return by.find_first_of(" /") == std::string::npos ? of + "/" + by : of + "/(" + by + ")";
}

}  // namespace

double relative(const Sensitivities& s, const Sensitivities::Gradient& gradient,
                std::size_t parameter) {
  if (gradient.value == 0) return 0;
  return s.parameters[parameter].value / gradient.value * gradient.by_parameter[parameter];
}

void write_sensitivities_csv(const std::filesystem::path& path, const Sensitivities& s) {
  const std::size_t n = s.times.size(), P = s.parameters.size();
  std::vector<TextColumn> columns{{"time", "s", {}}};
  for (const double t : s.times) columns[0].cells.push_back(cell(t));
  for (std::size_t r = 0; r < s.derivatives.size(); ++r) {
    const ResponseResult& response = s.responses[r];
    const auto C = static_cast<std::size_t>(response.components);
    for (std::size_t c = 0; c < C; ++c)
      for (std::size_t p = 0; p < P; ++p) {
        TextColumn column{response.column(c) + " by " + s.parameters[p].name,
                          ratio(response.unit, s.parameters[p].unit),
                          {}};
        for (std::size_t i = 0; i < n; ++i)
          column.cells.push_back(cell(s.derivatives[r][(i * C + c) * P + p]));
        columns.push_back(std::move(column));
      }
  }
  write_file(path, columns_csv(columns));
}

void write_gradients_csv(const std::filesystem::path& path, const Sensitivities& s) {
  std::vector<TextColumn> columns;
  for (const char* name : {"response", "functional", "value", "unit"})
    columns.push_back({name, "", {}});
  columns.push_back({"at", "s", {}});
  for (const char* name :
       {"parameter", "parameter_value", "parameter_unit", "gradient", "relative"})
    columns.push_back({name, "", {}});
  for (const auto& g : s.gradients)
    for (std::size_t p = 0; p < s.parameters.size(); ++p) {
      const std::string cells[] = {g.response,
                                   g.functional,
                                   cell(g.value),
                                   g.unit,
                                   cell(g.at_time),
                                   s.parameters[p].name,
                                   cell(s.parameters[p].value),
                                   s.parameters[p].unit,
                                   cell(g.by_parameter[p]),
                                   cell(relative(s, g, p))};
      for (std::size_t i = 0; i < std::size(cells); ++i) columns[i].cells.push_back(cells[i]);
    }
  write_file(path, columns_csv(columns));
}

void write_sensitivities_h5(const std::filesystem::path& path, const Sensitivities& s) {
  const hsize_t n = s.times.size(), P = s.parameters.size(), J = s.gradients.size();
  Hdf5File file(path);
  file.attribute("/", "program", "liesl");
  std::vector<std::string> names, units, responses, functionals;
  std::vector<double> values, of_functionals, gradients;
  for (const auto& p : s.parameters) {
    names.push_back(p.name);
    units.push_back(p.unit);
    values.push_back(p.value);
  }
  file.group("/parameters");
  file.write("/parameters/name", names);
  file.write("/parameters/unit", units);
  file.write("/parameters/value", values, {P});
  if (n > 0) file.write("/time", s.times, {n});
  file.group("/responses");
  file.group("/sensitivities");
  for (std::size_t r = 0; r < s.responses.size(); ++r) {
    const ResponseResult& response = s.responses[r];
    const auto C = static_cast<hsize_t>(response.components);
    const std::string at = "/responses/" + hdf5_name(response.name);
    file.write(at, response.values, {n, C});
    file.attribute(at, "unit", response.unit);
    if (s.derivatives.empty()) continue;
    const std::string by = "/sensitivities/" + hdf5_name(response.name);
    file.write(by, s.derivatives[r], {n, C, P});
    file.attribute(by, "unit", response.unit + " per unit of the parameter");
  }
  for (const auto& g : s.gradients) {
    responses.push_back(g.response);
    functionals.push_back(g.functional);
    of_functionals.push_back(g.value);
    gradients.insert(gradients.end(), g.by_parameter.begin(), g.by_parameter.end());
  }
  file.group("/gradients");
  file.write("/gradients/response", responses);
  file.write("/gradients/functional", functionals);
  file.write("/gradients/value", of_functionals, {J});
  file.write("/gradients/by_parameter", gradients, {J, P});
  file.close();
}

}  // namespace liesl::output
