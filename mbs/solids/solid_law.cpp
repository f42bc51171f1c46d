#include "mbs/solids/solid_law.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace liesl {
namespace {

constexpr int kThickness = 50;  // iterations of the stretch across a plate
constexpr double kThicknessDone = 1e-15;

struct Lame {
  double lambda, mu;
  explicit Lame(const Material& m)
      : lambda(m.E * m.nu / ((1 + m.nu) * (1 - 2 * m.nu))), mu(m.G()) {}
};

/// Components of a strain: row and column of each.
template <int D>
constexpr int kRow[] = {0, 1, 2, 0, 1, 2};
template <>
constexpr int kRow<2>[] = {0, 1, 0};
template <int D>
constexpr int kColumn[] = {0, 1, 2, 1, 2, 0};
template <>
constexpr int kColumn<2>[] = {0, 1, 1};

template <int D>
using Strain = Eigen::Matrix<double, (D == 2 ? 3 : 6), 1>;

template <int D>
LawAtPoint<D> linear(const Lame& k, const Strain<D>& E) {
  LawAtPoint<D> out;
  out.tangent.setZero();
  const double plane = 2 * k.lambda * k.mu / (k.lambda + 2 * k.mu);  // E_zz eliminated
  out.tangent.template topLeftCorner<D, D>().setConstant(D == 2 ? plane : k.lambda);
  out.tangent.diagonal().template head<D>().array() += 2 * k.mu;
  out.tangent.diagonal().template tail<LawAtPoint<D>::kStrains - D>().setConstant(k.mu);
  out.stress = out.tangent * E;
  out.energy = 0.5 * out.stress.dot(E);
  if (D == 2) {
    const double slope = 2 * k.lambda / (k.lambda + 2 * k.mu);
    const double square = std::max(0., 1 - slope * (E[0] + E[1]));
    out.across = std::sqrt(square);
    if (square > 0) out.thinning.template head<2>().setConstant(-0.5 * slope / square);
  }
  return out;
}

/// C_zz of a plate: mu (c - 1) + lambda (ln J_2 + ln(c)/2) = 0, which grows with c.
double across(const Lame& k, double ln_J2) {
  double c = 1;
  for (int i = 0; i < kThickness; ++i) {
    const double r = k.mu * (c - 1) + k.lambda * (ln_J2 + 0.5 * std::log(c));
    double step = -r / (k.mu + 0.5 * k.lambda / c);
    if (step < -0.5 * c) step = -0.5 * c;
    c += step;
    if (std::abs(step) <= kThicknessDone * c) break;
  }
  return c;
}

/// S = mu (I - C^-1) + lambda ln J C^-1, dS/dE = lambda C^-1 C^-1 + 2 (mu - lambda ln J) I_(C^-1).
template <int D>
LawAtPoint<D> neo_hookean(const Lame& k, const Strain<D>& E) {
  constexpr int n = LawAtPoint<D>::kStrains;
  using Square = Eigen::Matrix<double, D, D>;
  LawAtPoint<D> out;
  Square C = Square::Identity();
  for (int s = 0; s < D; ++s) C(s, s) += 2 * E[s];
  for (int s = D; s < n; ++s) C(kRow<D>[s], kColumn<D>[s]) = C(kColumn<D>[s], kRow<D>[s]) = E[s];
  const double det = C.determinant();
  if (!(det > 0)) {
    out.energy = std::numeric_limits<double>::quiet_NaN();
    out.stress.setConstant(out.energy);
    out.tangent.setConstant(out.energy);
    return out;
  }
  double ln_J = 0.5 * std::log(det), trace = C.trace(), c = 1;
  if (D == 2) {
    c = across(k, ln_J);
    ln_J += 0.5 * std::log(c);
    trace += c;
    out.across = std::sqrt(c);
  }
  const Square inverse = C.inverse();
  const double slope = k.lambda * ln_J - k.mu;
  out.energy = 0.5 * k.mu * (trace - 3 - 2 * ln_J) + 0.5 * k.lambda * ln_J * ln_J;
  // With S_zz = 0: d(ln J) is of the plane times mu c/(mu c + lambda/2).
  const double thin = D == 2 ? -0.5 * k.lambda / (k.mu * c + 0.5 * k.lambda) : 0;
  const double volume = D == 2 ? k.lambda * k.mu * c / (k.mu * c + 0.5 * k.lambda) : k.lambda;
  for (int s = 0; s < n; ++s) {
    const int i = kRow<D>[s], j = kColumn<D>[s];
    out.stress[s] = (s < D ? k.mu : 0) + slope * inverse(i, j);
    out.thinning[s] = thin * inverse(i, j);
    for (int t = 0; t <= s; ++t) {
      const int a = kRow<D>[t], b = kColumn<D>[t];
      out.tangent(s, t) = out.tangent(t, s) =
          volume * inverse(i, j) * inverse(a, b) -
          slope * (inverse(i, a) * inverse(j, b) + inverse(i, b) * inverse(j, a));
    }
  }
  return out;
}

}  // namespace

const char* to_string(SolidLaw law) {
  return law == SolidLaw::StVenantKirchhoff ? "st_venant_kirchhoff" : "neo_hookean";
}

template <int D>
LawAtPoint<D> solid_law(SolidLaw law, const Material& material,
                        const Eigen::Matrix<double, (D == 2 ? 3 : 6), 1>& strain) {
  const Lame k(material);
  return law == SolidLaw::StVenantKirchhoff ? linear<D>(k, strain) : neo_hookean<D>(k, strain);
}

template LawAtPoint<2> solid_law<2>(SolidLaw, const Material&, const Strain<2>&);
template LawAtPoint<3> solid_law<3>(SolidLaw, const Material&, const Strain<3>&);

}  // namespace liesl
