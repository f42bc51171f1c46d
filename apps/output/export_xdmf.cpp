#include "apps/output/export_xdmf.hpp"

#include <Eigen/Core>

#include "apps/output/cut_mesh.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/io_error.hpp"
#include "apps/output/own_files.hpp"
#include "apps/output/xdmf_writer.hpp"

namespace fs = std::filesystem;

namespace liesl::output {
namespace {

constexpr const char* kMeshes = "meshes.h5";

std::vector<int> integers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

BodyResult body(const Hdf5Input& file, const std::string& name) {
  const std::string group = "/bodies/" + name;
  BodyResult out;
  out.name = name;
  out.kind = file.attribute(group, "kind");
  out.positions = file.numbers(group + "/position").values;
  out.nodes = static_cast<int>(file.shape(group + "/position").at(1));
  out.rotations = file.numbers(group + "/rotation").values;
  out.velocities = file.numbers(group + "/velocity").values;
  out.strains = file.numbers(group + "/strain").values;
  out.section_forces = file.numbers(group + "/section_force").values;
  const auto nodes = integers(file.numbers(group + "/elements").values);
  for (std::size_t e = 0; e + 1 < nodes.size(); e += 2)
    out.elements.push_back({nodes[e], nodes[e + 1]});
  return out;
}

/// Positions x_0 + R_0 (s + u) and R_0 u, u = sum of amplitudes and basis, at the records.
MeshResult mesh(const Hdf5Input& file, const std::string& name, const BodyResult& frame, int n) {
  const std::string group = "/meshes/" + name;
  MeshResult out;
  out.name = name;
  out.cells = integers(file.numbers(group + "/cells").values);
  const CellKind& kind = stored_cells(file.attribute(group, "cell"),
                                      static_cast<int>(file.shape(group + "/cells").at(1)));
  out.corners = kind.nodes;
  if (const auto t = file.numbers(group + "/thickness").values; kind.dim == 2 && !t.empty())
    out.thickness = t[0];
  out.fractions = file.numbers(group + "/fraction").values;
  out.records = spread_records(n, kShownRecords);
  const Hdf5Numbers rest = file.numbers(group + "/reference"),
                    basis = file.numbers(group + "/basis"),
                    amplitude = file.numbers(group + "/amplitude", out.records);
  if (rest.empty())
    throw IoError("export", name, "an earlier version wrote results.h5; run it again");
  using Rows = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  const auto N = static_cast<Eigen::Index>(rest.shape[0]);
  const Eigen::Map<const Eigen::Matrix3Xd> s(rest.values.data(), 3, N);
  for (std::size_t r = 0; r < out.records.size(); ++r) {
    Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, N);
    for (std::size_t k = 0; !basis.empty() && k < basis.shape[0]; ++k)
      u += amplitude.values[r * basis.shape[0] + k] *
           Eigen::Map<const Eigen::Matrix3Xd>(&basis.values[k * basis.row()], 3, N);
    const std::size_t node = static_cast<std::size_t>(out.records[r] * frame.nodes);
    const Eigen::Matrix3d R = Rows::Map(&frame.rotations[9 * node]);
    const Eigen::Vector3d x_0 = Eigen::Vector3d::Map(&frame.positions[3 * node]);
    const Eigen::Matrix3Xd moved = R * u, x = (R * (s + u)).colwise() + x_0;
    out.displacements.insert(out.displacements.end(), moved.data(), moved.data() + moved.size());
    out.positions.insert(out.positions.end(), x.data(), x.data() + x.size());
  }
  return out;
}

void write_meshes(const fs::path& path, const std::vector<MeshResult>& meshes) {
  Hdf5File file(path);
  file.attribute("/", "program", "liesl");
  file.group("/meshes");
  for (const MeshResult& m : meshes) {
    const std::string group = "/meshes/" + m.name;
    const hsize_t C = static_cast<hsize_t>(m.corners), r = m.records.size();
    const Hdf5File::Shape shape = {r, m.positions.size() / r / 3, 3};
    file.group(group);
    file.write(group + "/cells", m.cells, {m.cells.size() / C, C});
    file.write(group + "/fraction", m.fractions, {m.fractions.size()});
    file.write(group + "/record", m.records, {r});
    file.write(group + "/position", m.positions, shape);
    file.write(group + "/displacement", m.displacements, shape);
  }
  file.close();
}

}  // namespace

void export_xdmf(const fs::path& folder) {
  if (!fs::exists(folder / "results.h5"))
    throw IoError("export", folder, "it holds no results.h5 of a simulation");
  const Hdf5Input file(folder / "results.h5");
  Results results;
  results.name = file.attribute("/", "scene");
  results.times = file.numbers("/time").values;
  for (const std::string& name : file.children("/bodies"))
    results.bodies.push_back(body(file, name));
  for (const std::string& name : file.children("/meshes"))
    for (const BodyResult& frame : results.bodies)
      if (frame.name == name)
        results.meshes.push_back(mesh(file, name, frame, static_cast<int>(results.times.size())));
  std::vector<std::string> written = {"results.xdmf"};
  if (!results.meshes.empty()) {
    write_meshes(folder / kMeshes, results.meshes);
    written.push_back(kMeshes);
  }
  write_xdmf(folder / "results.xdmf", "results.h5", results, kShownRecords, kMeshes);
  mark_files(folder, written);
}

}  // namespace liesl::output
