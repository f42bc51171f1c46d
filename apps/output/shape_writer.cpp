#include "apps/output/shape_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "apps/output/file.hpp"

namespace liesl::output {
namespace {

constexpr double kMillimetres = 1000;  // SVG, DXF and STL carry no unit that programs agree on

template <class... Args>
void put(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

void append_float(std::string& bytes, float value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof raw);
}

/// <DataArray> of the columns of a field.
void put_array(std::string& text, const MeshField& field) {
  const auto& [name, values] = field;
  put(text, "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n",
      name, values.rows());
  for (Eigen::Index j = 0; j < values.cols(); ++j)
    for (Eigen::Index i = 0; i < values.rows(); ++i)
      put(text, "{}{}", values(i, j), i + 1 == values.rows() ? '\n' : ' ');
  put(text, "</DataArray>\n");
}

void put_fields(std::string& text, const char* where, const std::vector<MeshField>& fields,
                Eigen::Index count) {
  put(text, "<{}>\n", where);
  for (const MeshField& f : fields) {
    if (f.second.cols() != count)
      throw std::invalid_argument(
          fmt::format("field '{}' has {} columns, expected {}", f.first, f.second.cols(), count));
    put_array(text, f);
  }
  put(text, "</{}>\n", where);
}

}  // namespace

void write_svg(const std::filesystem::path& path, const std::vector<levelset::Polyline>& lines) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  std::string d;
  for (const auto& line : lines) {
    const char* command = "M";
    for (const Eigen::Vector2d& x : line.points) {
      low = low.cwiseMin(x), high = high.cwiseMax(x);
      put(d, "{}{:.6g} {:.6g} ", command, kMillimetres * x[0], -kMillimetres * x[1]);
      command = "L";
    }
    if (line.closed) d += "Z ";
  }
  if (lines.empty()) low.setZero(), high.setZero();
  const Eigen::Vector2d size = kMillimetres * (high - low), margin = 0.02 * size;
  const Eigen::Vector2d whole = size + 2 * margin;
  std::string text;
  put(text,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.6g}mm\" height=\"{:.6g}mm\" "
      "viewBox=\"{:.6g} {:.6g} {:.6g} {:.6g}\">\n",
      whole[0], whole[1], kMillimetres * low[0] - margin[0], -kMillimetres * high[1] - margin[1],
      whole[0], whole[1]);
  put(text,
      "<path fill=\"#b8c4d0\" stroke=\"#203040\" stroke-width=\"{:.4g}\" fill-rule=\"evenodd\" "
      "d=\"{}\"/>\n</svg>\n",
      0.002 * whole.norm(), d);
  write_file(path, text);
}

void write_dxf(const std::filesystem::path& path, const std::vector<levelset::Polyline>& lines) {
  std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
      "0\nSECTION\n2\nENTITIES\n";
  for (const auto& line : lines) {
    put(text, "0\nLWPOLYLINE\n100\nAcDbEntity\n8\noutline\n100\nAcDbPolyline\n90\n{}\n70\n{}\n",
        line.points.size(), line.closed ? 1 : 0);
    for (const Eigen::Vector2d& x : line.points)
      put(text, "10\n{:.9g}\n20\n{:.9g}\n", kMillimetres * x[0], kMillimetres * x[1]);
  }
  text += "0\nENDSEC\n0\nEOF\n";
  write_file(path, text);
}

void write_stl(const std::filesystem::path& path, const levelset::Surface& surface) {
  const Eigen::Matrix3Xf points = (kMillimetres * surface.points).cast<float>();
  std::string triangles;  // 50 bytes each
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3f a = points.col(t[0]), b = points.col(t[1]), c = points.col(t[2]);
    if (a == b || b == c || c == a) continue;  // its two sides cancel: the surface stays closed
    const Eigen::Vector3d from = surface.points.col(t[0]), to = surface.points.col(t[1]);
    const Eigen::Vector3d n = (to - from).cross(surface.points.col(t[2]) - from).normalized();
    for (const Eigen::Vector3f& x : {Eigen::Vector3f(n.cast<float>()), a, b, c})
      for (float xi : x) append_float(triangles, xi);
    triangles.append(2, '\0');
  }
  std::string bytes(80, ' ');  // a header of 80 bytes, a count, the triangles
  bytes.replace(0, 16, "liesl, unit: mm ");
  const auto count = static_cast<std::uint32_t>(triangles.size() / 50);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(count >> shift & 0xff);
  write_file(path, bytes + triangles);
}

void write_vtu(const std::filesystem::path& path, const SolidMesh& mesh,
               const std::vector<MeshField>& cell_fields,
               const std::vector<MeshField>& node_fields) {
  const int nodes = mesh.nodes_per_cell();
  std::string text;
  put(text,
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
      "NumberOfCells=\"{}\">\n",
      mesh.node_count(), mesh.cell_count());
  put_fields(text, "PointData", node_fields, mesh.node_count());
  put_fields(text, "CellData", cell_fields, mesh.cell_count());
  text += "<Points>\n";
  put_array(text, {"position", mesh.nodes});
  text += "</Points>\n<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (int e = 0; e < mesh.cell_count(); ++e)
    for (int c = 0; c < nodes; ++c)
      put(text, "{}{}", mesh.cells(c, e), c + 1 == nodes ? '\n' : ' ');
  text += "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (int e = 1; e <= mesh.cell_count(); ++e) put(text, "{}\n", nodes * e);
  text += "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (int e = 0; e < mesh.cell_count(); ++e) put(text, "{}\n", mesh.kind().vtk);
  text += "</DataArray>\n</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  write_file(path, text);
}

}  // namespace liesl::output
