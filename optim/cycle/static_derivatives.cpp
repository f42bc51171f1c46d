/// @file
/// First and second derivatives of the static problem.
#include "mbs/sections/stress.hpp"
#include "optim/cycle/static_sizing.hpp"

namespace liesl {

/// dy/dx of all outputs in all retained cases, by the form that costs fewer solutions.
template <FrameGroup G>
void StaticSizing<G>::output_gradients() {
  dy_.assign(parts_.size(), {});
  for (size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    const bool direct = part.problem.direct_is_cheaper(sizing_.size());
    const std::vector<Law> dK = stiffness_derivatives(part);
    for (int i = 0; i < sizing_.size(); ++i) {
      Eigen::MatrixXd& dy =
          dy_[p].emplace_back(Eigen::MatrixXd::Zero(part.outputs.count(), part.problem.cases()));
      if (dK[i].empty()) continue;
      if (direct) part.problem.add_gradient_direct(dK[i], dy);
      for (const auto& at : sizing_.elements(i)) {
        if (at.body != part.body) continue;
        const typename G::Matrix& dK_s = dK[i][at.element];
        if (!direct) part.problem.add_gradient(at.element, dK_s, dy);
        if (part.outputs.compliance)
          dy.bottomRows(1) += part.problem.compliance_gradient(at.element, dK_s);
      }
    }
  }
}

template <FrameGroup G>
typename G::Matrix StaticSizing<G>::section_derivative(const Part& part, int i,
                                                       SizedElement at) const {
  return space_.reduce_law(sizing_.derivative(mechanism_, i, at).K, part.align[at.element]);
}

template <FrameGroup G>
typename G::Matrix StaticSizing<G>::stiffness_derivative(const Part& part, int i,
                                                         SizedElement at) const {
  return part.beam->rest_stiffness_by(at.element, part.section[at.element],
                                      section_derivative(part, i, at));
}

template <FrameGroup G>
std::vector<typename StaticSizing<G>::Law> StaticSizing<G>::stiffness_derivatives(
    const Part& part) const {
  std::vector<Law> dK(sizing_.size());
  for (int i = 0; i < sizing_.size(); ++i)
    for (const auto& at : sizing_.elements(i)) {
      if (at.body != part.body) continue;
      if (dK[i].empty()) dK[i].assign(part.align.size(), G::Matrix::Zero());
      dK[i][at.element] = stiffness_derivative(part, i, at);
    }
  return dK;
}

/// What each variable does to the sections whose stress is limited.
template <FrameGroup G>
typename StaticSizing<G>::StressChanges StaticSizing<G>::stress_changes() const {
  StressChanges changes;
  for (size_t p = 0; p < parts_.size(); ++p)
    for (int i = 0; i < sizing_.size() && !parts_[p].stress.empty(); ++i)
      for (const auto& at : sizing_.elements(i)) {
        if (at.body != parts_[p].body) continue;
        const auto& beam = std::get<BeamSpec>(mechanism_.bodies[at.body].kind);
        StressChange& change = changes[{static_cast<int>(p), at.element, i}];
        change.dK = stiffness_derivative(parts_[p], i, at);
        for (const auto& name : sizing_.dimensions(i)) {
          const auto dS =
              stress_points_derivative(beam.sections[at.element], beam.material.nu, name);
          change.dS.resize(dS.size(), Eigen::Matrix<double, 3, 6>::Zero());
          for (size_t k = 0; k < dS.size(); ++k) change.dS[k] += dS[k];
        }
      }
  return changes;
}

template <FrameGroup G>
void StaticSizing<G>::gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix& dg) {
  df.setZero();
  for (int i = 0; i < sizing_.size(); ++i)
    for (const auto& at : sizing_.elements(i))
      if (in_mass(at.body)) df[i] += mass_slope(sizing_.derivative(mechanism_, i, at), at);
  output_gradients();
  const StressChanges changes = stress_changes();
  for (size_t r = 0; r < retained_.rows.size(); ++r) {
    const Limit& limit = limits_[retained_.rows[r].limit];
    const Part& part = parts_[limit.part];
    const Eigen::VectorXd y = outputs_of(limit, retained_.rows[r].kept);
    Eigen::VectorXd slope;
    limit_value(limit, y, &slope);
    for (int i = 0; i < sizing_.size(); ++i) {
      double d = slope.dot(
          dy_[limit.part][i].col(retained_.rows[r].kept).segment(limit.first, limit.count));
      if (const auto c = changes.find({limit.part, limit.element, i}); c != changes.end())
        d += part.stress[limit.element].explicit_slope(limit.point, y, c->second);
      dg(static_cast<int>(r), i) = d / limit_of(limit);
    }
  }
}

/// Second derivatives of the section laws by pair of variables j <= i, where both act.
template <FrameGroup G>
typename StaticSizing<G>::SecondLaws StaticSizing<G>::second_laws() const {
  const int n = sizing_.size();
  SecondLaws second(n);
  for (int i = 0; i < n; ++i) {
    second[i].resize(n);
    for (int j = 0; j <= i; ++j)
      for (const auto& a : sizing_.elements(i))
        for (const auto& b : sizing_.elements(j))
          if (a.body == b.body && a.element == b.element)
            second[i][j].push_back({a, sizing_.second_derivative(mechanism_, i, j, a)});
  }
  return second;
}

/// sum_r lambda_r d|y_r|/dy of the outputs of a part; the curvature of the norms goes to h.
template <FrameGroup G>
Eigen::MatrixXd StaticSizing<G>::output_weights(int p, const Eigen::VectorXd& lambda,
                                                Eigen::MatrixXd& h) const {
  const Part& part = parts_[p];
  const int n = sizing_.size();
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(part.outputs.count(), part.problem.cases());
  for (size_t r = 0; r < retained_.rows.size(); ++r) {
    const Limit& limit = limits_[retained_.rows[r].limit];
    const double weight = lambda[static_cast<int>(r)] / limit_of(limit);
    if (limit.part != p || weight == 0) continue;
    const int kept = retained_.rows[r].kept;
    const Eigen::VectorXd y = outputs_of(limit, kept);
    const double v = y.norm();
    if (v == 0) continue;
    w.col(kept).segment(limit.first, limit.count) += weight * y / v;
    if (limit.count < 2) continue;
    Eigen::MatrixXd dy(limit.count, n);  // curvature of the norm: (I - y y^T/v^2)/v
    for (int i = 0; i < n; ++i) dy.col(i) = dy_[p][i].col(kept).segment(limit.first, limit.count);
    const Eigen::VectorXd along = dy.transpose() * y / v;
    h += weight / v * (dy.transpose() * dy - along * along.transpose());
  }
  return w;
}

template <FrameGroup G>
void StaticSizing<G>::hessian(const Eigen::VectorXd&, double sigma, const Eigen::VectorXd& lambda,
                              Eigen::MatrixXd& h) {
  const int n = sizing_.size();
  const SecondLaws second = second_laws();
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      for (const auto& [at, law] : second[i][j]) h(i, j) += sigma * mass_slope(law, at);
  for (size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    const Eigen::MatrixXd w = output_weights(static_cast<int>(p), lambda, h);
    typename StaticPart<G>::Second d2K(n, std::vector<Law>(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        for (const auto& [at, law] : second[i][j]) {
          if (at.body != part.body) continue;
          if (d2K[i][j].empty()) d2K[i][j].assign(part.align.size(), G::Matrix::Zero());
          d2K[i][j][at.element] = part.beam->rest_stiffness_second(
              at.element, part.section[at.element], section_derivative(part, i, at),
              section_derivative(part, j, at), space_.reduce_law(law.K, part.align[at.element]));
        }
    part.problem.add_second(stiffness_derivatives(part), d2K, w, h);
  }
}

template void StaticSizing<SE2>::output_gradients();
template SE2::Matrix StaticSizing<SE2>::section_derivative(const Part&, int, SizedElement) const;
template SE2::Matrix StaticSizing<SE2>::stiffness_derivative(const Part&, int, SizedElement) const;
template std::vector<typename StaticSizing<SE2>::Law> StaticSizing<SE2>::stiffness_derivatives(
    const Part&) const;
template typename StaticSizing<SE2>::StressChanges StaticSizing<SE2>::stress_changes() const;
template void StaticSizing<SE2>::gradients(const Eigen::VectorXd&, Eigen::VectorXd&, RowMatrix&);
template typename StaticSizing<SE2>::SecondLaws StaticSizing<SE2>::second_laws() const;
template Eigen::MatrixXd StaticSizing<SE2>::output_weights(int, const Eigen::VectorXd&,
                                                           Eigen::MatrixXd&) const;
template void StaticSizing<SE2>::hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&,
                                         Eigen::MatrixXd&);
template void StaticSizing<SE3>::output_gradients();
template SE3::Matrix StaticSizing<SE3>::section_derivative(const Part&, int, SizedElement) const;
template SE3::Matrix StaticSizing<SE3>::stiffness_derivative(const Part&, int, SizedElement) const;
template std::vector<typename StaticSizing<SE3>::Law> StaticSizing<SE3>::stiffness_derivatives(
    const Part&) const;
template typename StaticSizing<SE3>::StressChanges StaticSizing<SE3>::stress_changes() const;
template void StaticSizing<SE3>::gradients(const Eigen::VectorXd&, Eigen::VectorXd&, RowMatrix&);
template typename StaticSizing<SE3>::SecondLaws StaticSizing<SE3>::second_laws() const;
template Eigen::MatrixXd StaticSizing<SE3>::output_weights(int, const Eigen::VectorXd&,
                                                           Eigen::MatrixXd&) const;
template void StaticSizing<SE3>::hessian(const Eigen::VectorXd&, double, const Eigen::VectorXd&,
                                         Eigen::MatrixXd&);

}  // namespace liesl
