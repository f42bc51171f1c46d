#pragma once
/// @file
/// Shape variables: parameters of the features of a level set, linked, bounded, kept apart.

#include <Eigen/SparseCore>

#include "mbs/levelset/level_set.hpp"
#include "mbs/solids/solid_model.hpp"
#include "mbs/solids/volume_fraction.hpp"
#include "optim/nlp/problem.hpp"
#include "optim/study/study.hpp"

namespace liesl {

class ShapeDesign {
 public:
  /// `shape` and `model` must outlive this; the shape is left as it was made.
  /// @throws std::invalid_argument that lists all of: unknown parameters, features and interfaces,
  /// parameters that follow two variables, bounds out of order, bounds within which a feature turns
  /// inside out or has another defect, walls that are not above zero
  ShapeDesign(ShapeDesignSpec spec, levelset::LevelSet& shape, const SolidModel& model);

  const std::vector<NlpVariable>& variables() const { return variables_; }
  const std::vector<std::string>& units() const { return units_; }
  int size() const { return static_cast<int>(variables_.size()); }
  Eigen::VectorXd start() const;

  /// The parameters p of the level set at x, and dp/dx [parameters x variables], constant.
  Eigen::VectorXd parameters(const Eigen::VectorXd& x) const;
  const Eigen::SparseMatrix<double>& jacobian() const { return jacobian_; }

  /// How far each variable may go, alone, until some place of the outline has moved by `cells`
  /// cells: cells h / max_e |d phi/dx_j| / |d phi/dx| over the cells e that the outline crosses
  /// (with entries in `dv`), h the mean length of a cell; infinite if nothing moves.
  /// @pre the shape is set to where `dv` was computed
  Eigen::VectorXd step_bounds(const FractionGradient& dv, double cells) const;

  /// Rows 1 - thickness/least <= 0 of the walls at the parameters set; an interface has one row a
  /// node. `dg` [rows x variables] if not null.
  const std::vector<std::string>& wall_names() const { return wall_names_; }
  Eigen::VectorXd walls(RowMatrix* dg = nullptr) const;

 private:
  struct WallRow {
    levelset::Part a, b;  ///< b.shape is null: distance to `node`
    int node = -1;
    double least = 0;
    int void_a = -1, void_b = -1;  ///< among the sampled features
  };
  int sampled(const levelset::Part& part);
  void add_variable(const ShapeVariableSpec& v, std::vector<std::string>& errors);
  void check_bounds(const ShapeVariableSpec& v, int j, std::vector<std::string>& errors);
  void add_wall(const WallSpec& w, std::vector<std::string>& errors);
  int parameter_named(const std::string& name, std::vector<std::string>& errors) const;

  levelset::LevelSet& shape_;
  const SolidModel& model_;
  std::vector<NlpVariable> variables_;
  std::vector<std::string> units_;
  Eigen::VectorXd p0_, x0_;
  std::vector<std::string> owner_;  ///< variable that a parameter follows, by parameter
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> jacobian_;
  std::vector<WallRow> walls_;
  std::vector<levelset::Part> sampled_;
  std::vector<std::string> wall_names_;
};

}  // namespace liesl
