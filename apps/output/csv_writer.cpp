#include "apps/output/csv_writer.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "apps/output/enlarged.hpp"
#include "apps/output/file.hpp"

namespace liesl::output {
namespace {

/// Columns that share the abscissa, gathered and then written by rows.
class Table {
 public:
  explicit Table(const Results& results) : n_(results.times.size()) {
    add(results.abscissa, results.abscissa_unit, results.times);
  }
  /// Component `c` of a block [n, C]; nothing if the block is empty.
  void add(const std::string& name, const std::string& unit, const std::vector<double>& block,
           std::size_t c = 0, std::size_t C = 1) {
    if (block.empty()) return;
    header_ += (header_.empty() ? "" : ",") + heading(name, unit);
    columns_.push_back({&block, c, C});
  }
  void write(const std::filesystem::path& path) const {
    fmt::memory_buffer out;
    out.reserve(header_.size() + 1 + n_ * columns_.size() * kCell);
    out.append(header_ + "\n");
    for (std::size_t i = 0; i < n_; ++i) {
      char end = ',';
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        const auto& [block, c, C] = columns_[k];
        if (k + 1 == columns_.size()) end = '\n';
        fmt::format_to(fmt::appender(out), FMT_COMPILE("{}"), (*block)[i * C + c]);
        out.push_back(end);
      }
    }
    write_file(path, {out.data(), out.size()});
  }

 private:
  static constexpr std::size_t kCell = 20;  // bytes of most numbers
  struct Column {
    const std::vector<double>* block;
    std::size_t c, C;
  };
  std::size_t n_;
  std::string header_;
  std::vector<Column> columns_;
};

}  // namespace

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string heading(const std::string& name, const std::string& unit) {
  return field(unit.empty() ? name : name + " [" + unit + "]");
}

void write_responses_csv(const std::filesystem::path& path, const Results& results) {
  check_shapes(results);
  Table table(results);
  for (const auto& response : results.responses) {
    const auto C = static_cast<std::size_t>(response.components);
    for (std::size_t c = 0; c < C; ++c)
      table.add(response.column(c), response.unit, response.values, c, C);
  }
  table.write(path);
}

void write_energies_csv(const std::filesystem::path& path, const Results& results) {
  check_shapes(results);
  Table table(results);
  table.add("kinetic", "J", results.energies.kinetic);
  table.add("elastic", "J", results.energies.elastic);
  table.add("potential", "J", results.energies.potential);
  table.add("dissipated", "J", results.energies.dissipated);
  table.add("total", "J", results.energies.total);
  table.add("constraint_residual", "m or rad", results.constraint_residual);
  table.write(path);
}

void write_joints_csv(const std::filesystem::path& path, const Results& results) {
  check_shapes(results);
  Table table(results);
  for (const auto& joint : results.joints) {
    const std::size_t K = joint.units.size();
    for (std::size_t c = 0; c < K; ++c) {
      table.add(fmt::format("{}.q{}", joint.name, c), joint.units[c], joint.coordinates, c, K);
    }
    const char* const names[] = {"Fx", "Fy", "Fz", "Mx", "My", "Mz"};
    for (std::size_t c = 0; c < 6; ++c) {
      table.add(joint.name + "." + names[c], c < 3 ? "N" : "N m", joint.forces, c, 6);
    }
  }
  table.write(path);
}

void write_frames_csv(const std::filesystem::path& path, const Results& results, int instants) {
  check_shapes(results);
  std::string out = heading(results.abscissa, results.abscissa_unit) +
                    ",body,kind,node,x [m],y [m],z [m],"
                    "bending x [m],bending y [m],bending z [m]\n";
  const auto put = [&](const std::string& at, const BodyResult& body, int k, const double* x,
                       const Eigen::Vector3d& bending) {
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{:.7g},{:.7g},{:.7g}\n", at,
                   field(body.name), field(body.kind), k, x[0], x[1], x[2], bending[0], bending[1],
                   bending[2]);
  };
  if (results.abscissa == "frequency")
    for (const auto& body : results.bodies)
      for (int k = 0; k < body.nodes && !body.reference_positions.empty(); ++k)
        put(kAtRest, body, k, &body.reference_positions[3 * static_cast<std::size_t>(k)],
            Eigen::Vector3d::Zero());
  for (const int i : frame_records(results, instants))
    for (const auto& body : results.bodies) {
      if (body.positions.empty()) continue;
      const Enlarged bending(results, body, results.row(i));
      const double* x =
          body.positions.data() + 3 * results.row(i) * static_cast<std::size_t>(body.nodes);
      for (int k = 0; k < body.nodes; ++k)
        put(fmt::format("{}", results.times[i]), body, k, x + 3 * k, bending.at(k));
    }
  write_file(path, out);
}

void write_rigid_paths_csv(const std::filesystem::path& path, const Results& results) {
  std::string out = heading(results.abscissa, results.abscissa_unit) + ",body,x [m],y [m],z [m]\n";
  const std::size_t head = out.size();
  const auto records = spread_records(static_cast<int>(results.times.size()), kPathPoints);
  for (const auto& body : results.bodies)
    for (std::size_t k = 0; 3 * k < body.path.size(); ++k)
      fmt::format_to(std::back_inserter(out), "{},{},{:.7g},{:.7g},{:.7g}\n",
                     results.times[static_cast<std::size_t>(records[k])], field(body.name),
                     body.path[3 * k], body.path[3 * k + 1], body.path[3 * k + 2]);
  if (out.size() > head) write_file(path, out);
}

std::string cell(double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; }

std::string columns_csv(const std::vector<TextColumn>& columns) {
  std::string out;
  const char* separator = "";
  for (const TextColumn& column : columns) {
    out += separator + heading(column.name, column.unit);
    separator = ",";
  }
  const std::size_t rows = columns.empty() ? 0 : columns.front().cells.size();
  for (std::size_t row = 0; row < rows; ++row) {
    separator = "\n";
    for (const TextColumn& column : columns) {
      out += separator + field(column.cells.at(row));
      separator = ",";
    }
  }
  return out + "\n";
}

void write_design_csv(const std::filesystem::path& path, const std::vector<DesignRow>& rows) {
  std::string out =
      "variable,body,element,s0 [m],s1 [m],initial,final,lower,upper,unit,dimension\n";
  for (const auto& r : rows) {
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{},{},{},{},{}\n", field(r.variable),
                   field(r.body), r.element, r.s0, r.s1, r.initial, r.final, r.lower, r.upper,
                   field(r.unit), field(r.dimensions));
  }
  write_file(path, out);
}

}  // namespace liesl::output
