#include "apps/mesh/matrix_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "apps/input/problem.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/io_error.hpp"

namespace liesl {
namespace {

using output::Hdf5File;
using output::Hdf5Input;
using output::Hdf5Numbers;

class MatrixFileReader {
 public:
  explicit MatrixFileReader(const std::filesystem::path& path)
      : name_(path.string()), file_(path) {}

  PartMatrices read() const {
    PartMatrices part;
    const Hdf5Numbers nodes = whole("nodes");
    if (nodes.shape.size() != 2 || (nodes.shape[1] != 2 && nodes.shape[1] != 3))
      fail("'nodes' is no table of 2 or 3 columns", "a row [x, y] or [x, y, z] a node (m)");
    part.nodes.dim = static_cast<int>(nodes.shape[1]);
    const auto count = static_cast<Eigen::Index>(nodes.shape[0]);
    part.nodes.nodes = Eigen::Matrix3Xd::Zero(3, count);
    part.nodes.nodes.topRows(part.nodes.dim) =
        Eigen::Map<const Eigen::MatrixXd>(nodes.values.data(), part.nodes.dim, count);
    const int size = freedoms(part.nodes);
    part.matrices = {matrix("stiffness", size), matrix("mass", size)};
    for (const std::string& set : file_.children("/sets"))
      for (const int node : indices("sets/" + set, part.nodes.node_count()))
        part.nodes.sets[set].push_back(node);
    return part;
  }

 private:
  [[noreturn]] void fail(std::string what, std::string expected) const {
    throw InputError({{name_, 0, 0, std::move(what), std::move(expected), ""}});
  }
  Hdf5Numbers whole(const std::string& set) const {
    Hdf5Numbers numbers = file_.numbers("/" + set);
    if (numbers.empty())
      fail(fmt::format("it has no data set '{}'", set),
           "nodes, and row, column and value of stiffness and mass");
    return numbers;
  }
  /// Of all nodes: with rotations where the stiffness has rows beyond the displacements.
  int freedoms(const SolidMesh& nodes) const {
    const int displacements = nodes.dim * nodes.node_count();
    for (const double row : whole("stiffness/row").values)
      if (row >= displacements) return (nodes.dim == 2 ? 3 : 6) * nodes.node_count();
    return displacements;
  }
  /// Numbers from 0 to size - 1.
  std::vector<int> indices(const std::string& set, int size) const {
    std::vector<int> out;
    for (const double x : whole(set).values) {
      if (!(x >= 0 && x < size) || x != std::floor(x))
        fail(fmt::format("'{}' holds {}", set, x),
             fmt::format("whole numbers from 0 to {}", size - 1));
      out.push_back(static_cast<int>(x));
    }
    return out;
  }
  /// Of entries of the lower triangle alone both.
  Eigen::SparseMatrix<double> matrix(const std::string& group, int size) const {
    const std::vector<int> rows = indices(group + "/row", size),
                           columns = indices(group + "/column", size);
    const std::vector<double> values = whole(group + "/value").values;
    if (rows.size() != values.size() || columns.size() != values.size())
      fail(fmt::format("'{}' has {} rows, {} columns and {} values", group, rows.size(),
                       columns.size(), values.size()),
           "as many of each");
    bool lower = true;
    for (std::size_t k = 0; k < rows.size(); ++k) lower = lower && rows[k] >= columns[k];
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      entries.emplace_back(rows[k], columns[k], values[k]);
      if (lower && rows[k] != columns[k]) entries.emplace_back(columns[k], rows[k], values[k]);
    }
    Eigen::SparseMatrix<double> A(size, size);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
  }

  std::string name_;
  Hdf5Input file_;
};

void write_matrix(const Hdf5File& file, const std::string& group,
                  const Eigen::SparseMatrix<double>& A) {
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (int j = 0; j < A.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator a(A, j); a; ++a)
      if (a.value() != 0) {
        rows.push_back(static_cast<int>(a.row()));
        columns.push_back(j);
        values.push_back(a.value());
      }
  file.group(group);
  file.write(group + "/row", rows, {rows.size()});
  file.write(group + "/column", columns, {rows.size()});
  file.write(group + "/value", values, {rows.size()});
}

}  // namespace

PartMatrices read_matrix_file(const std::filesystem::path& path) {
  try {
    return MatrixFileReader(path).read();
  } catch (const output::IoError& error) {
    throw InputError({{path.string(), 0, 0, error.reason(), "an HDF5 file of a part", ""}});
  }
}

void write_matrix_file(const std::filesystem::path& path, const PartMatrices& part) {
  Hdf5File file(path);
  const SolidMesh& mesh = part.nodes;
  const Eigen::MatrixXd x = mesh.nodes.topRows(mesh.dim);
  file.write("/nodes", std::vector<double>(x.data(), x.data() + x.size()),
             {static_cast<hsize_t>(x.cols()), static_cast<hsize_t>(x.rows())});
  write_matrix(file, "/stiffness", part.matrices.K);
  write_matrix(file, "/mass", part.matrices.M);
  file.group("/sets");
  for (const auto& [name, nodes] : mesh.sets) file.write("/sets/" + name, nodes, {nodes.size()});
  file.close();
}

}  // namespace liesl
