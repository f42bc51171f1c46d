#pragma once
/// @file
/// Von Mises stresses of the cells of a meshed part, and one number a load case: their p-norm.

#include "mbs/solids/solid_statics.hpp"

namespace liesl {

struct StressOptions {
  double p = 8;             ///< exponent of the norm, >= 1
  double relaxation = 0.5;  ///< q of v^q, >= 0: takes the stress of cells that vanish to zero
                            ///< (Bruggi 2008; Le, Norato, Bruns, Ha, Tortorelli 2010)
};

struct StressNorm {
  Eigen::VectorXd value;     ///< Pa, by case
  Eigen::MatrixXd gradient;  ///< Pa per parameter, cases x parameters, at constant loads
  /// dS/dq at constant fractions, q x cases; empty if there are no parameters
  Eigen::MatrixXd by_displacement;
};

/// S_n = (sum_e w_e (v_e^q sigma_e)^p)^(1/p), w_e = V_e / sum V, with sigma_e the von Mises stress
/// of the full material at the centre of cell e. Never above the largest relaxed stress, and nearer
/// to it for larger p. The gradient takes one more solution a case.
/// @pre the last solve of `statics` gave Solved
/// @throws std::invalid_argument for options out of range
StressNorm stress_norm(const SolidStatics& statics, const FractionGradient& dv,
                       const StressOptions& options = {});

/// Von Mises stress of the full material at the centres, Pa: cells x cases; times v^relaxation.
Eigen::MatrixXd von_mises(const SolidStatics& statics, double relaxation = 0);

/// Stresses of the full material at the centre of a cell, ordered as in `CellMatrices`, Pa, from
/// displacements u of the nodes: one column a column of u [node freedoms x columns].
Eigen::MatrixXd central_stress(const SolidModel& model, int cell,
                               const Eigen::Ref<const Eigen::MatrixXd>& u);

/// sqrt(sigma^T V sigma) of stresses in the plane or in space, a column each, Pa: 1 x columns.
Eigen::RowVectorXd von_mises(const Eigen::MatrixXd& stresses);
/// Its derivative by one stress, V sigma/sigma_vM; zero where there is no stress.
Eigen::VectorXd von_mises_gradient(const Eigen::VectorXd& stress);

/// v^relaxation by cell: the share of the stress of its material that a cell shows.
Eigen::VectorXd relaxed_shares(const Eigen::VectorXd& v,
                               double relaxation = StressOptions().relaxation);
/// Its derivative by a parameter of the fractions, dv/dp; 0 of cells that are void.
Eigen::VectorXd relaxed_shares_derivative(const Eigen::VectorXd& v, const Eigen::VectorXd& dv,
                                          double relaxation = StressOptions().relaxation);

}  // namespace liesl
