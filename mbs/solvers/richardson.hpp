#pragma once
/// @file
/// Error estimates from two meshes or steps, and the coarsest choice that they allow.
///
/// With half the element and half the step,
///   R_h - R_{h/2} = (1 - 2^-p) C h^p,  error of the finer one = |R_h - R_{h/2}| / (2^p - 1)
/// (L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307-357), p = 2 for generalized-alpha, 2 or
/// 4 for beam elements; of both together the lower one shows.

#include <optional>
#include <vector>

namespace liesl {

inline constexpr double kOrder = 2;

/// Order of convergence log2(coarse / fine) that two differences of three runs show, each run twice
/// as fine as the one before.
double observed_order(double coarse, double fine);

/// Error of the finer of two runs that differ by `difference`. With the difference before it also
/// the order is checked: an observed order below 2 is taken instead of 2; infinity if it is below
/// 1/2, where nothing converges yet. Differences below 1e-9 are rounding and taken as they are.
double error_of_finer(double difference, std::optional<double> before = {});

/// Error of the coarser of two runs that differ by `difference`, by order p:
/// |R_h - R_{h/2}| / (1 - 2^-p).
double error_of_coarser(double difference, double order);

/// What a mesh costs in accuracy: error E (n_0/n)^p.
struct MeshError {
  int elements = 1;       ///< n_0
  double error = 0;       ///< E, at n_0
  int multiple = 1;       ///< n is a multiple of it
  int most = 1;           ///< n is at most this
  double order = kOrder;  ///< p of its elements
  /// At n elements.
  double at(int n) const;
};

/// A choice of steps and meshes.
struct Plan {
  long steps = 0;
  std::vector<int> elements;
  double error = 0;  ///< sum of the estimates
};

/// The cheapest choice with sum of errors <= budget, cost = steps x (elements + others).
/// For a number of steps with error e_h the meshes share budget - e_h so that sum(n) is least:
///   n_b = (lambda p_b C_b)^(1/(p_b + 1)),  C_b = E_b n_0b^p_b,
/// with the lambda (Lagrange) at which their errors add up to it.
/// @param step_counts candidates, ascending; {0} in statics  @param steps with error `step_error`
/// @return the finest choice if none is within the budget
Plan cheapest(const std::vector<long>& step_counts, long steps, double step_error,
              const std::vector<MeshError>& meshes, double others, double budget);

/// Divisors of n, ascending: numbers of steps whose instants are instants of n steps.
std::vector<long> divisors(long n);

}  // namespace liesl
