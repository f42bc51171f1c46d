#include "apps/output/xdmf_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"

namespace liesl::output {
namespace {

constexpr char kRecord = '\1';  // stands for the number of a record; XML has no such character

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      case kRecord:
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// A block [n, rows, columns] of the HDF5 file.
struct Block {
  std::string file, path;
  std::size_t n, rows, columns;
};

/// Columns first .. first + count of one record of the block, as `path|start:stride:count:whole`.
/// (The reader of XDMF 3 gives nothing for the HyperSlab items of XDMF 2.)
std::string slab(const Block& b, std::size_t first, std::size_t count) {
  return fmt::format(
      "<DataItem Dimensions=\"{1} {2}\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">"
      "{6}:{7}|{0} 0 {3}:1 1 1:1 {1} {2}:{4} {1} {5}</DataItem>",
      kRecord, b.rows, count, first, b.n, b.columns, escaped(b.file), escaped(b.path));
}

std::string attribute(const std::string& name, const char* type, const char* centre,
                      const std::string& data) {
  return fmt::format(
      "     <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n", name, type,
      centre, data);
}

std::string topology(const BodyResult& body, const std::string& file, const std::string& group) {
  if (body.elements.empty()) {
    std::string nodes;
    for (int i = 0; i < body.nodes; ++i) nodes += fmt::format("{} ", i);
    return fmt::format(
        "     <Topology TopologyType=\"Polyvertex\" NumberOfElements=\"{0}\" NodesPerElement=\"1\">"
        "<DataItem Dimensions=\"{0} 1\" NumberType=\"Int\" Format=\"XML\">{1}</DataItem>"
        "</Topology>\n",
        body.nodes, nodes);
  }
  return fmt::format(
      "     <Topology TopologyType=\"Polyline\" NumberOfElements=\"{0}\" NodesPerElement=\"2\">"
      "<DataItem Dimensions=\"{0} 2\" NumberType=\"Int\" Precision=\"4\" Format=\"HDF\">"
      "{1}:{2}/elements</DataItem></Topology>\n",
      body.elements.size(), escaped(file), escaped(group));
}

/// Of every record.
std::string grid(const BodyResult& body, const std::string& file, std::size_t n) {
  const std::string group = "/bodies/" + hdf5_name(body.name);
  const auto N = static_cast<std::size_t>(body.nodes);
  const std::size_t E = body.elements.size();
  const auto block = [&](const char* name, std::size_t rows, std::size_t columns) {
    return Block{file, group + "/" + name, n, rows, columns};
  };
  std::string out = fmt::format("    <Grid Name=\"{}\">\n", escaped(body.name));
  out += topology(body, file, group);
  out += "     <Geometry GeometryType=\"XYZ\">" + slab(block("position", N, 3), 0, 3) +
         "</Geometry>\n";
  if (!body.rotations.empty()) {
    out += attribute("rotation", "Tensor", "Node", slab(block("rotation", N, 9), 0, 9));
  }
  // Six-vectors: translation or force first, rotation or moment second.
  const auto halves = [&](const std::vector<double>& values, const Block& b, const char* centre,
                          const char* first, const char* second) {
    if (values.empty()) return;
    out += attribute(first, "Vector", centre, slab(b, 0, 3));
    out += attribute(second, "Vector", centre, slab(b, 3, 3));
  };
  halves(body.velocities, block("velocity", N, 6), "Node", "velocity (local)",
         "angular velocity (local)");
  halves(body.strains, block("strain", E, 6), "Cell", "strain", "curvature");
  halves(body.section_forces, block("node_force", N, 6), "Node", "section force", "section moment");
  return out + "    </Grid>\n";
}

/// The deformed mesh at every record that it has.
std::string grid(const MeshResult& mesh, const std::string& file) {
  const std::string group = "/meshes/" + hdf5_name(mesh.name);
  const std::size_t C = static_cast<std::size_t>(mesh.corners), M = mesh.cells.size() / C;
  const std::size_t r = mesh.records.size(), N = mesh.positions.size() / r / 3;
  std::string out = fmt::format(
      "    <Grid Name=\"{0}\">\n     <Topology TopologyType=\"{1}\" NumberOfElements=\"{2}\">"
      "<DataItem Dimensions=\"{2} {3}\" NumberType=\"Int\" Precision=\"4\" Format=\"HDF\">"
      "{4}:{5}/cells</DataItem></Topology>\n",
      escaped(mesh.name + " mesh"), cell_kind(mesh.dim(), mesh.corners).xdmf, M, C, escaped(file),
      escaped(group));
  const auto vectors = [&](const char* name) { return slab({file, group + name, r, N, 3}, 0, 3); };
  out += "     <Geometry GeometryType=\"XYZ\">" + vectors("/position") + "</Geometry>\n";
  out += attribute("displacement", "Vector", "Node", vectors("/displacement"));
  const std::string fractions = fmt::format(
      "<DataItem Dimensions=\"{}\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">{}:{}"
      "/fraction</DataItem>",
      M, escaped(file), escaped(group));
  return out + attribute("fraction", "Scalar", "Cell", fractions) + "    </Grid>\n";
}

/// A text of every record as that of one.
void append(const std::string& text, std::size_t record, std::string& out) {
  const std::string number = std::to_string(record);
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(kRecord, from)) != std::string::npos; from = at + 1)
    out.append(text, from, at - from).append(number);
  out.append(text, from);
}

}  // namespace

void write_xdmf(const std::filesystem::path& path, const std::string& hdf5_name,
                const Results& results, int max_instants, const std::string& mesh_hdf5) {
  const std::size_t n = results.times.size();
  std::string out = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n <Domain>\n";
  out += "  <Grid Name=\"" + escaped(results.name) +
         "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n";
  std::vector<std::string> bodies, meshes;
  for (const auto& body : results.bodies)
    if (!body.positions.empty()) bodies.push_back(grid(body, hdf5_name, n));
  for (const auto& mesh : results.meshes)
    meshes.push_back(mesh.records.empty() ? ""
                                          : grid(mesh, mesh_hdf5.empty() ? hdf5_name : mesh_hdf5));
  for (const int record : spread_records(static_cast<int>(n), max_instants)) {
    out += "   <Grid Name=\"bodies\" GridType=\"Collection\" CollectionType=\"Spatial\">\n";
    out += fmt::format("    <Time Value=\"{}\"/>\n", results.times[record]);
    for (const std::string& body : bodies) append(body, static_cast<std::size_t>(record), out);
    for (std::size_t m = 0; m < meshes.size(); ++m) {
      const std::vector<int>& records = results.meshes[m].records;
      const auto at = std::find(records.begin(), records.end(), record);
      if (at != records.end())
        append(meshes[m], static_cast<std::size_t>(at - records.begin()), out);
    }
    out += "   </Grid>\n";
  }
  out += "  </Grid>\n </Domain>\n</Xdmf>\n";
  write_file(path, out);
}

}  // namespace liesl::output
