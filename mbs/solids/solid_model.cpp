#include "mbs/solids/solid_model.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "mbs/solids/interface_map.hpp"

namespace liesl {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// M of one component for all of them: freedoms dim * node + component.
MatrixXd for_all_components(const MatrixXd& M, int dim) {
  MatrixXd all = MatrixXd::Zero(dim * M.rows(), dim * M.cols());
  for (Eigen::Index i = 0; i < M.rows(); ++i)
    for (Eigen::Index j = 0; j < M.cols(); ++j)
      all.block(dim * i, dim * j, dim, dim).diagonal().setConstant(M(i, j));
  return all;
}

auto K_of(const SolidModel& model) {
  return [&model](int e) -> const MatrixXd& { return model.cell(e).K; };
}

}  // namespace

/// T_e^T A_e T_e of every cell, lower triangle; T_e are the rows of T at the cell's freedoms.
template <class Matrix>
SparseAssembly SolidModel::add_cells(SparseAssembly assembly, const Matrix& matrix,
                                     const VectorXd& factor) const {
  const int dim = mesh_.dim, n = dim * mesh_.nodes_per_cell();
  std::vector<int> columns, local(size(), -1);
  MatrixXd T_e, reduced;
  assembly.begin();
  for (int e = 0; e < mesh_.cell_count(); ++e) {
    columns.clear();
    bool plain = true;
    for (int i = 0; i < n; ++i) {
      const int row = freedom(e, i / dim) + i % dim;
      plain = plain && coordinate_[row] >= 0;
      for (decltype(T_rows_)::InnerIterator t(T_rows_, row); t; ++t) {
        const auto c = static_cast<int>(t.col());
        if (local[c] < 0) local[c] = static_cast<int>(columns.size()), columns.push_back(c);
      }
    }
    const MatrixXd* A = &matrix(e);
    if (!plain) {
      T_e.setZero(n, static_cast<Eigen::Index>(columns.size()));
      for (int i = 0; i < n; ++i)
        for (decltype(T_rows_)::InnerIterator t(T_rows_, freedom(e, i / dim) + i % dim); t; ++t)
          T_e(i, local[t.col()]) = t.value();
      reduced = T_e.transpose() * *A * T_e;
      A = &reduced;
    }
    for (std::size_t j = 0; j < columns.size(); ++j)
      for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i] >= columns[j])
          assembly.add(
              columns[i], columns[j],
              factor[e] * (*A)(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
    for (const int c : columns) local[c] = -1;
  }
  return assembly;
}

SolidModel::SolidModel(SolidMesh mesh, Material material, std::vector<Interface> interfaces,
                       const Options& options)
    : mesh_(std::move(mesh)),
      material_(std::move(material)),
      interfaces_(std::move(interfaces)),
      options_(options) {
  if (mesh_.cell_count() == 0) throw std::invalid_argument("the mesh has no cells");
  if (!(options.law.ratio > 0 && options.law.ratio < 1 && options.law.exponent >= 1))
    throw std::invalid_argument("ersatz law: 0 < ratio < 1 and exponent >= 1 expected");
  if (mesh_.dim == 2 && !(options.thickness > 0))
    throw std::invalid_argument("thickness of a planar part must be positive");
  freedoms_ = mesh_.dim;
  find_shapes();
  number_freedoms();
  assembly_ = add_cells(SparseAssembly(size()), K_of(*this), VectorXd::Ones(mesh_.cell_count()));
  assembly_.finish();
}

SolidModel::SolidModel(SolidMesh nodes, const NodalMatrices& matrices,
                       std::vector<Interface> interfaces)
    : mesh_(std::move(nodes)), interfaces_(std::move(interfaces)) {
  mesh_.cells.resize(mesh_.dim == 2 ? 4 : 8, 0);
  require_free_part(mesh_, matrices);
  freedoms_ = liesl::freedoms_of_a_node(mesh_, matrices);
  number_freedoms();
  component_mass_ = liesl::component_mass(mesh_, matrices);
  if (!component_mass_) coupled_mass_ = matrices.M;
  const Sparse K_q = T_.transpose() * matrices.K * T_, M_q = T_.transpose() * matrices.M * T_;
  const Sparse K = K_q.triangularView<Eigen::Lower>(), M = M_q.triangularView<Eigen::Lower>();
  given_ = {K + 0.0 * M, M + 0.0 * K};
  given_mass_ = rigid_.col(0).dot(M.selfadjointView<Eigen::Lower>() * rigid_.col(0));
}

/// Cells of equal edges (to 1e-10 of their size) share their matrices, the last distinct shape is
/// tried first: a grid has one.
void SolidModel::find_shapes() {
  std::vector<Eigen::Matrix3Xd> known;
  full_mass_.resize(mesh_.cell_count());
  for (int e = 0; e < mesh_.cell_count(); ++e) {
    Eigen::Matrix3Xd x = mesh_.nodes_of(e);
    if (!(smallest_jacobian(mesh_.dim, x) > 0))
      throw std::invalid_argument("cell " + std::to_string(e) + " is inverted or flat");
    x.colwise() -= Eigen::Vector3d(x.col(0));
    const double tolerance = 1e-10 * x.cwiseAbs().maxCoeff();
    std::size_t s = known.size();
    for (std::size_t tried = 0; tried < std::min<std::size_t>(known.size(), 8); ++tried)
      if ((known[known.size() - 1 - tried] - x).cwiseAbs().maxCoeff() <= tolerance) {
        s = known.size() - 1 - tried;
        break;
      }
    if (s == known.size()) {
      known.push_back(x);
      shapes_.push_back(cell_matrices(mesh_.dim, x, material_, options_.thickness));
      M_of_shape_.push_back(for_all_components(shapes_.back().M, mesh_.dim));
    }
    shape_of_.push_back(static_cast<int>(s));
    full_mass_[e] = material_.rho * shapes_[s].volume;
  }
}

void SolidModel::number_freedoms() {
  InterfaceMap map = interface_map(mesh_, freedoms_, interfaces_);
  T_ = std::move(map.T);
  T_rows_ = T_;
  coordinate_ = std::move(map.coordinate);
  rigid_.resize(size(), rigid_count());
  for (int i = 0; i < mesh_.node_count(); ++i) {
    const MatrixXd R =
        rigid_motion(mesh_.dim, freedoms_, mesh_.nodes.col(i), Eigen::Vector3d::Zero());
    for (int a = 0; a < freedoms_; ++a)
      if (const int c = coordinate_[freedoms_ * i + a]; c >= 0) rigid_.row(c) = R.row(a);
  }
  for (int k = 0; k < ports(); ++k) {
    rigid_.middleRows(port(k), rigid_count()).setIdentity();
    rigid_.middleRows(port(k), mesh_.dim) =
        rigid_displacement(mesh_.dim, interfaces_[k].point, Eigen::Vector3d::Zero());
  }
}

int SolidModel::interface_named(const std::string& name) const {
  std::string known;
  for (int k = 0; k < ports(); ++k) {
    if (interfaces_[k].name == name) return k;
    known += (k > 0 ? ", " : "") + interfaces_[k].name;
  }
  throw std::invalid_argument("no interface '" + name + "'; known: " + known);
}

std::optional<int> SolidModel::coordinate(int node, int component) const {
  const int c = coordinate_[freedoms_ * node + component];
  return c >= 0 ? std::optional<int>(c) : std::nullopt;
}

MatrixXd SolidModel::displacements(const MatrixXd& q) const {
  const MatrixXd all = T_ * q;
  const int dim = mesh_.dim;
  if (freedoms_ == dim) return all;
  MatrixXd out(dim * mesh_.node_count(), q.cols());
  for (int i = 0; i < mesh_.node_count(); ++i)
    out.middleRows(dim * i, dim) = all.middleRows(freedoms_ * i, dim);
  return out;
}

MatrixXd SolidModel::at_cell(int cell, const Eigen::Ref<const MatrixXd>& u) const {
  MatrixXd out(mesh_.dim * mesh_.nodes_per_cell(), u.cols());
  for (int c = 0; c < mesh_.nodes_per_cell(); ++c)
    out.middleRows(mesh_.dim * c, mesh_.dim) = u.middleRows(freedom(cell, c), mesh_.dim);
  return out;
}

MatrixXd SolidModel::q_at_cell(int cell, const Eigen::Ref<const MatrixXd>& q) const {
  MatrixXd out = MatrixXd::Zero(mesh_.dim * mesh_.nodes_per_cell(), q.cols());
  for (int i = 0; i < out.rows(); ++i) {
    const int row = freedom(cell, i / mesh_.dim) + i % mesh_.dim;
    for (decltype(T_rows_)::InnerIterator t(T_rows_, row); t; ++t)
      out.row(i) += t.value() * q.row(t.col());
  }
  return out;
}

SolidModel::Sparse SolidModel::stiffness(const VectorXd& v) const {
  if (!given_.empty()) return given_[0];
  const VectorXd factor = v.unaryExpr([this](double x) { return options_.law.stiffness(x); });
  return add_cells(assembly_, K_of(*this), factor).finish();
}

SolidModel::Sparse SolidModel::stiffness_derivative(const VectorXd& v, const VectorXd& dv) const {
  if (!given_.empty()) return 0.0 * given_[0];
  const VectorXd slope = v.unaryExpr([this](double x) { return options_.law.slope(x); });
  return add_cells(assembly_, K_of(*this), slope.cwiseProduct(dv)).finish();
}

SolidModel::Sparse SolidModel::mass(const VectorXd& v) const {
  if (!given_.empty()) return given_[1];
  return add_cells(
             assembly_, [this](int e) -> const MatrixXd& { return cell_mass(e); }, v)
      .finish();
}

}  // namespace liesl
