#pragma once
/// @file
/// A meshed part as a handful of modes: constrained modes of its ports plus modes of the part.

#include <vector>

#include "mbs/solids/solid_model.hpp"

namespace liesl {

enum class ReductionKind {
  CraigBampton,  ///< port motions (constraint modes), then modes with all ports held
  FreeInterface  ///< rigid motions, inertia-relief answers to unit port loads, free modes
};

/// Integrals over the part of products of position x and modes phi_k (both isoparametric, hence
/// exact with the consistent mass), all with the fractions in them. In the plane the third
/// component is zero.
struct InertiaIntegrals {
  double mass = 0;                     ///< int rho, kg
  Eigen::Vector3d first;               ///< int rho x, kg m
  Eigen::Matrix3d second;              ///< int rho x x^T, kg m^2
  Eigen::Matrix3Xd mode;               ///< int rho phi_k, 3 x modes
  std::vector<Eigen::Matrix3d> cross;  ///< int rho x phi_k^T by mode
  /// int rho phi_k phi_l^T at [k * modes + l]
  std::vector<Eigen::Matrix3d> product;
};

/// q = basis * eta; M = basis^T M_q basis, K likewise.
struct ReducedSolid {
  Eigen::MatrixXd basis;        ///< q x modes
  Eigen::MatrixXd M, K;         ///< modes x modes, symmetric
  int ports = 0;                ///< Craig-Bampton: the first `ports` modes are the port motions
  Eigen::VectorXd frequencies;  ///< Hz, of the internal modes kept
  InertiaIntegrals inertia;
  bool converged = false;  ///< of the eigenvalue solver; nothing else is filled if not
};

/// @param internal number of internal modes (fixed-interface or free modes)
/// @throws std::invalid_argument if a Craig-Bampton part has no interfaces
ReducedSolid reduce(const SolidModel& model, const Eigen::VectorXd& v, ReductionKind kind,
                    int internal);

/// Inertia integrals of the displacements T * modes (modes: q x k).
InertiaIntegrals inertia_integrals(const SolidModel& model, const Eigen::VectorXd& v,
                                   const Eigen::MatrixXd& modes);
/// Their derivative by a parameter of the fractions and of the modes: dv/dp, d(modes)/dp.
InertiaIntegrals inertia_integrals_derivative(const SolidModel& model, const Eigen::VectorXd& v,
                                              const Eigen::MatrixXd& modes,
                                              const Eigen::VectorXd& dv,
                                              const Eigen::MatrixXd& dmodes);

/// Lowest `count` elastic free-free frequencies, Hz, without the rigid motions: of the full mesh,
/// and of the reduced part (fewer if it has fewer). Empty if the eigenvalue solver failed.
Eigen::VectorXd free_frequencies(const SolidModel& model, const Eigen::VectorXd& v, int count);
Eigen::VectorXd free_frequencies(const ReducedSolid& reduced, int rigid, int count);

/// d f_k/dp of the free-free frequencies [count x parameters], from
/// d lambda = phi^T (s' K_e - lambda M_e) phi dv_e; f = sqrt(lambda)/(2 pi). Single frequencies
/// only.
struct FrequencyGradient {
  Eigen::VectorXd frequency;  ///< Hz
  Eigen::MatrixXd gradient;   ///< Hz per parameter
};
FrequencyGradient free_frequency_gradient(const SolidModel& model, const Eigen::VectorXd& v,
                                          const Eigen::SparseMatrix<double, Eigen::RowMajor>& dv,
                                          int count);

}  // namespace liesl
