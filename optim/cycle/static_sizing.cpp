#include "optim/cycle/static_sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace liesl {
namespace {

constexpr double kDifference = 1e-6;  // of the beam's length: step of the gradients at rest

/// "bend at t = 0.0123 s" and a number that stays the same from cycle to cycle.
ConstraintId row_id(int limit, int load_case) {
  return (static_cast<ConstraintId>(limit) << 32) | static_cast<ConstraintId>(load_case);
}

}  // namespace

template <FrameGroup G>
StaticSizing<G>::StaticSizing(const Analysis<G>& at, const Sizing& sizing, const StudySpec& study,
                              const Eigen::VectorXd& x0, double move)
    : sizing_(sizing),
      study_(study),
      mechanism_(at.mechanism),
      model_(*at.model),
      space_(at.model->space) {
  variables_ = sizing.variables();
  for (int i = 0; i < sizing.size(); ++i) {
    variables_[i].start = x0[i];
    variables_[i].lower = std::max(variables_[i].lower, x0[i] * (1 - move));
    variables_[i].upper = std::min(variables_[i].upper, x0[i] * (1 + move));
  }
  make_parts(at);
  update_stress_of_strain();
  for (auto& part : parts_) {
    part.problem.set_loads(part.loads->f);
    part.problem.solve(stiffness(part));
  }
  update_outputs();
  for (size_t p = 0; p < parts_.size(); ++p)
    parts_[p].correction = dynamic_outputs(at, static_cast<int>(p)) - parts_[p].y;
  screen();
}

template <FrameGroup G>
void StaticSizing<G>::make_parts(const Analysis<G>& at) {
  for (const auto& loads : at.loads) {
    std::vector<Eigen::MatrixXd> outputs;
    const int index = static_cast<int>(parts_.size());
    const auto& beam = dynamic_cast<const Beam<G>&>(*model_.bodies[loads.body]);
    const size_t before = limits_.size();
    add_outputs(at, loads.body, outputs);
    for (size_t i = before; i < limits_.size(); ++i) limits_[i].part = index;
    int columns = 0;
    for (const auto& c : outputs) columns += static_cast<int>(c.cols());
    Eigen::MatrixXd C(beam.size(), columns);
    columns = 0;
    for (const auto& c : outputs) {
      C.middleCols(columns, c.cols()) = c;
      columns += static_cast<int>(c.cols());
    }
    const auto support = study_.supports.find(loads.body);
    HeldPart held = read_support(support == study_.supports.end() ? Support{} : support->second,
                                 at.mechanism, model_, loads.body);
    Part part{loads.body, &loads, StaticPart<G>(beam, std::move(held), std::move(C)), {}, false, {},
              {},         {}};
    for (size_t i = before; i < limits_.size(); ++i)
      part.compliance |= kind_of(limits_[i]) == ResponseKind::Compliance;
    for (int e = 0; e < beam.elements(); ++e)
      part.align.push_back(space_.alignment(at.mechanism.frame({loads.body, e, SE3::identity()})));
    parts_.push_back(std::move(part));
  }
}

/// The limits on one body and the outputs they are made of.
template <FrameGroup G>
void StaticSizing<G>::add_outputs(const Analysis<G>& at, int body,
                                  std::vector<Eigen::MatrixXd>& outputs) {
  int column = 0, compliance = -1;
  const auto add = [&](int constraint, Eigen::MatrixXd c) {
    limits_.push_back({constraint, 0, column, static_cast<int>(c.cols()), -1, -1});
    column += static_cast<int>(c.cols());
    outputs.push_back(std::move(c));
  };
  const auto& beam = dynamic_cast<const Beam<G>&>(*model_.bodies[body]);
  for (size_t i = 0; i < study_.constraints.size(); ++i) {
    ResponseSpec r = study_.constraints[i].response;
    const int index = static_cast<int>(i);
    if (limited_body(r) != body) continue;
    if (r.kind == ResponseKind::Stress) {
      second_derivatives_ = false;
      const auto& spec = std::get<BeamSpec>(at.mechanism.bodies[body].kind);
      for (int e = 0; e < beam.elements(); ++e) {
        const int points =
            static_cast<int>(stress_points(spec.sections[e], spec.material.nu).size());
        for (int p = 0; p < points; ++p) limits_.push_back({index, 0, column, dim, e, p});
        outputs.push_back(StaticPart<G>::strain_output(beam, e));
        column += dim;
      }
    } else if (r.kind == ResponseKind::Compliance) {
      second_derivatives_ = false;
      compliance = index;
    } else if (r.everywhere) {
      r.everywhere = false;
      for (int k = 1; k < beam.elements(); ++k) {
        r.s = static_cast<double>(k) / beam.elements();
        add(index, gradient_at_rest(at, r));
      }
    } else {
      add(index, gradient_at_rest(at, r));
    }
  }
  if (compliance >= 0) limits_.push_back({compliance, 0, column, 1, -1, -1});
}

/// Gradient of a response with respect to the increments of its body at the reference shape, by
/// fourth-order differences.
template <FrameGroup G>
Eigen::MatrixXd StaticSizing<G>::gradient_at_rest(const Analysis<G>& at,
                                                  const ResponseSpec& r) const {
  const ResponseValues<G> values(at.mechanism, model_);
  State<G> s = model_.initial_state();
  const int body = limited_body(r);
  const int first = model_.first_node(body), nodes = model_.bodies[body]->nodes();
  Eigen::MatrixXd c(dim * nodes, components(r, G::space_dim == 2));
  const double step = kDifference * model_.length;
  for (int k = 0; k < nodes; ++k)
    for (int i = 0; i < dim; ++i) {
      const double h = i < G::space_dim ? step * 100 : 1e-4;
      const G rest = s.H[first + k];
      const auto moved = [&](double d) {
        s.H[first + k] = rest * G::exp(d * G::Tangent::Unit(i));
        return values(r, s);
      };
      c.row(dim * k + i) =
          ((8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h)).transpose();
      s.H[first + k] = rest;
    }
  return c;
}

/// The outputs as the motion has them: outputs x all cases.
template <FrameGroup G>
Eigen::MatrixXd StaticSizing<G>::dynamic_outputs(const Analysis<G>& at, int part) const {
  const ResponseValues<G> values(at.mechanism, model_);
  const int body = parts_[part].body;
  Eigen::MatrixXd y(parts_[part].outputs(), at.trajectory->size());
  State<G> s = model_.initial_state();
  for (int n = 0; n < at.trajectory->size(); ++n) {
    at.trajectory->read(n, s);
    int filled = -1;  // outputs that several limits share are read once
    int node = 0;
    for (const auto& limit : limits_) {
      if (limit.part != part || limit.first <= filled) continue;
      filled = limit.first;
      if (limit.element >= 0) {
        y.col(n).segment(limit.first, dim) =
            model_.bodies[body]->strain(model_.body_state(s, body), limit.element);
        continue;
      }
      ResponseSpec r = study_.constraints[limit.constraint].response;
      if (r.everywhere) {
        r.everywhere = false;
        r.s = static_cast<double>(++node) / model_.bodies[body]->elements();
      } else {
        node = 0;
      }
      y.col(n).segment(limit.first, limit.count) = values(r, s);
    }
  }
  return y;
}

template <FrameGroup G>
typename StaticSizing<G>::Law StaticSizing<G>::stiffness(const Part& part) const {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
  Law law;
  for (size_t e = 0; e < beam.sections.size(); ++e)
    law.push_back(space_.reduce_law(section_law(beam.sections[e], beam.material).K, part.align[e]));
  return law;
}

template <FrameGroup G>
typename StaticSizing<G>::StressRows StaticSizing<G>::stress_rows(const Part& part, int e,
                                                                  int point) const {
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
  const auto S = stress_points(beam.sections[e], beam.material.nu)[point].S;
  StressRows rows;
  for (int j = 0; j < dim; ++j)
    rows.col(j) = S * space_.embed_local(G::Tangent::Unit(j), part.align[e]);
  return rows;
}

template <FrameGroup G>
void StaticSizing<G>::update_outputs() {
  for (auto& part : parts_) {
    part.y.resize(part.outputs(), part.problem.cases());
    part.y.topRows(part.problem.outputs()) = part.problem.y();
    if (part.compliance) part.y.bottomRows(1) = part.problem.compliance();
  }
}

template <FrameGroup G>
void StaticSizing<G>::update_stress_of_strain() {
  stress_of_strain_.assign(limits_.size(), StressRows::Zero());
  for (size_t l = 0; l < limits_.size(); ++l) {
    const Limit& limit = limits_[l];
    if (limit.element < 0) continue;
    const Part& part = parts_[limit.part];
    const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
    const SectionLaw law = section_law(beam.sections[limit.element], beam.material);
    stress_of_strain_[l] = stress_rows(part, limit.element, limit.point) *
                           space_.reduce_law(law.K, part.align[limit.element]);
  }
}

template <FrameGroup G>
double StaticSizing<G>::limit_value(const Limit& limit, const Eigen::VectorXd& y,
                                    Eigen::VectorXd* slope) const {
  if (limit.element < 0) {
    const double v = y.norm();
    if (slope) *slope = v > 0 ? Eigen::VectorXd(y / v) : Eigen::VectorXd::Zero(y.size());
    return v;
  }
  const StressRows& SK = stress_of_strain_[static_cast<size_t>(&limit - limits_.data())];
  const Vec3 s = SK * y;
  const Vec3 weighted(s[0], 3 * s[1], 3 * s[2]);
  const double v = std::sqrt(s.dot(weighted));
  if (slope)
    *slope =
        v > 0 ? Eigen::VectorXd(SK.transpose() * weighted / v) : Eigen::VectorXd::Zero(y.size());
  return v;
}

/// Part of d(stress)/dx_i at fixed strain: the section itself changes.
template <FrameGroup G>
double StaticSizing<G>::explicit_stress_slope(const Limit& limit, const Eigen::VectorXd& y,
                                              int i) const {
  const Part& part = parts_[limit.part];
  bool touches = false;
  for (const auto& at : sizing_.elements(i))
    touches |= at.body == part.body && at.element == limit.element;
  if (!touches) return 0;
  const auto& beam = std::get<BeamSpec>(mechanism_.bodies[part.body].kind);
  const Section& section = beam.sections[limit.element];
  const SE3& align = part.align[limit.element];
  const typename G::Matrix K = space_.reduce_law(section_law(section, beam.material).K, align);
  const typename G::Matrix dK =
      space_.reduce_law(sizing_.derivative(mechanism_, i, {part.body, limit.element}).K, align);
  const StressRows S = stress_rows(part, limit.element, limit.point);
  Eigen::Matrix<double, 3, 6> dS = Eigen::Matrix<double, 3, 6>::Zero();
  for (const auto& name : sizing_.dimensions(i))
    dS += stress_points_derivative(section, beam.material.nu, name)[limit.point];
  const Vec3 s = S * (K * y);
  const Vec3 weighted(s[0], 3 * s[1], 3 * s[2]);
  const double v = std::sqrt(s.dot(weighted));
  if (v == 0) return 0;
  const SE3::Tangent n = space_.embed_local(typename G::Tangent(K * y), align);
  return weighted.dot(dS * n + S * (dK * y)) / v;
}

template <FrameGroup G>
Eigen::VectorXd StaticSizing<G>::outputs_of(const Limit& limit, int kept) const {
  const Part& part = parts_[limit.part];
  return part.y.col(kept).segment(limit.first, limit.count) +
         part.correction.col(part.kept[kept]).segment(limit.first, limit.count);
}

/// Keeps, for each limit, the cases near its largest value and some more.
template <FrameGroup G>
void StaticSizing<G>::screen() {
  std::vector<std::vector<int>> cases(limits_.size());
  const auto& o = study_.cycle;
  std::vector<double> worst(study_.constraints.size(), 0);
  std::vector<std::vector<double>> value(limits_.size());
  for (auto& part : parts_) {
    part.kept.resize(part.loads->t.size());
    std::iota(part.kept.begin(), part.kept.end(), 0);
  }
  for (size_t l = 0; l < limits_.size(); ++l) {
    const auto& limit = limits_[l];
    for (size_t n = 0; n < parts_[limit.part].loads->t.size(); ++n) {
      value[l].push_back(limit_value(limit, outputs_of(limit, static_cast<int>(n)), nullptr));
      worst[limit.constraint] = std::max(worst[limit.constraint], value[l].back());
    }
  }
  for (size_t l = 0; l < limits_.size(); ++l) {
    std::vector<int> order(value[l].size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return value[l][a] > value[l][b]; });
    const bool many = limits_[l].element >= 0;  // stress: hundreds of points share one constraint
    for (size_t k = 0; k < order.size(); ++k)
      if ((!many && static_cast<int>(k) < o.min_cases) ||
          value[l][order[k]] >= (1 - o.screening) * worst[limits_[l].constraint])
        if (!many || static_cast<int>(k) < o.min_cases) cases[l].push_back(order[k]);
  }
  retain(cases);
}

/// Makes the rows of these cases (by limit) the constraints, and their loads those of the parts.
template <FrameGroup G>
void StaticSizing<G>::retain(const std::vector<std::vector<int>>& cases) {
  rows_.clear();
  constraints_.clear();
  std::vector<std::vector<int>> slot(parts_.size());
  for (size_t p = 0; p < parts_.size(); ++p) {
    slot[p].assign(parts_[p].loads->t.size(), -1);
    parts_[p].kept.clear();
  }
  for (size_t l = 0; l < limits_.size(); ++l)
    for (const int n : cases[l]) {
      Part& part = parts_[limits_[l].part];
      int& place = slot[limits_[l].part][n];
      if (place < 0) {
        place = static_cast<int>(part.kept.size());
        part.kept.push_back(n);
      }
      rows_.push_back({static_cast<int>(l), place});
      constraints_.push_back(
          {row_id(static_cast<int>(l), n),
           fmt::format("{} at t = {:.6g} s",
                       study_.constraints[limits_[l].constraint].response.name, part.loads->t[n]),
           1.0});
    }
  for (auto& part : parts_) {
    Eigen::MatrixXd f(part.loads->f.rows(), part.kept.size());
    for (size_t k = 0; k < part.kept.size(); ++k)
      f.col(static_cast<int>(k)) = part.loads->f.col(part.kept[k]);
    part.problem.set_loads(f);
  }
}

template <FrameGroup G>
int StaticSizing<G>::load_cases() const {
  int n = 0;
  for (const auto& part : parts_) n += static_cast<int>(part.kept.size());
  return n;
}

template <FrameGroup G>
int StaticSizing<G>::add_violated(const Eigen::VectorXd& x, double tolerance) {
  std::vector<std::vector<int>> cases(limits_.size());
  for (const auto& row : rows_)
    cases[row.limit].push_back(parts_[limits_[row.limit].part].kept[row.kept]);
  for (auto& part : parts_) {
    part.kept.resize(part.loads->t.size());
    std::iota(part.kept.begin(), part.kept.end(), 0);
    part.problem.set_loads(part.loads->f);
  }
  int added = 0;
  if (solve(x))
    for (size_t l = 0; l < limits_.size(); ++l) {
      const auto& limit = limits_[l];
      const double allowed = study_.constraints[limit.constraint].limit * (1 + tolerance);
      std::sort(cases[l].begin(), cases[l].end());
      const size_t had = cases[l].size();
      for (int n = 0; n < parts_[limit.part].problem.cases(); ++n)
        if (limit_value(limit, outputs_of(limit, n), nullptr) > allowed &&
            !std::binary_search(cases[l].begin(), cases[l].begin() + static_cast<long>(had), n)) {
          cases[l].push_back(n);
          ++added;
        }
    }
  retain(cases);
  return added;
}

template <FrameGroup G>
bool StaticSizing<G>::solve(const Eigen::VectorXd& x) {
  mechanism_ = sizing_.apply(mechanism_, x);
  for (auto& part : parts_)
    if (!part.problem.solve(stiffness(part))) return false;
  update_outputs();
  update_stress_of_strain();
  return true;
}

template <FrameGroup G>
void StaticSizing<G>::values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) {
  const bool solved = solve(x);
  f = mass_of(mechanism_, study_.mass_of);
  for (size_t i = 0; i < rows_.size(); ++i) {
    const Limit& limit = limits_[rows_[i].limit];
    g[static_cast<int>(i)] = solved
                                 ? limit_value(limit, outputs_of(limit, rows_[i].kept), nullptr) /
                                           study_.constraints[limit.constraint].limit -
                                       1
                                 : std::numeric_limits<double>::quiet_NaN();
  }
}

template <FrameGroup G>
void StaticSizing<G>::gradients(const Eigen::VectorXd&, Eigen::VectorXd& df, RowMatrix& dg) {
  const auto in_mass = [this](int body) {
    return std::find(study_.mass_of.begin(), study_.mass_of.end(), body) != study_.mass_of.end();
  };
  df.setZero();
  dy_.assign(parts_.size(), {});
  for (int i = 0; i < sizing_.size(); ++i) {
    for (size_t p = 0; p < parts_.size(); ++p)
      dy_[p].push_back(Eigen::MatrixXd::Zero(parts_[p].outputs(), parts_[p].problem.cases()));
    for (const auto& at : sizing_.elements(i)) {
      const SectionLaw d = sizing_.derivative(mechanism_, i, at);
      if (in_mass(at.body))
        df[i] += d.M(0, 0) *
                 element_length(std::get<BeamSpec>(mechanism_.bodies[at.body].kind), at.element);
      for (size_t p = 0; p < parts_.size(); ++p)
        if (parts_[p].body == at.body) {
          const typename G::Matrix dK = space_.reduce_law(d.K, parts_[p].align[at.element]);
          if (!parts_[p].problem.direct_is_cheaper(sizing_.size()))
            parts_[p].problem.add_gradient(at.element, dK, dy_[p][i]);
          if (parts_[p].compliance)
            dy_[p][i].bottomRows(1) += parts_[p].problem.compliance_gradient(at.element, dK);
        }
    }
  }
  for (size_t p = 0; p < parts_.size(); ++p) {
    if (!parts_[p].problem.direct_is_cheaper(sizing_.size())) continue;
    const std::vector<Law> dK = stiffness_derivatives(parts_[p]);
    for (int i = 0; i < sizing_.size(); ++i)
      if (!dK[i].empty()) parts_[p].problem.add_gradient_direct(dK[i], dy_[p][i]);
  }
  for (size_t r = 0; r < rows_.size(); ++r) {
    const Limit& limit = limits_[rows_[r].limit];
    const Eigen::VectorXd y = outputs_of(limit, rows_[r].kept);
    Eigen::VectorXd slope;
    limit_value(limit, y, &slope);
    const double scale = 1 / study_.constraints[limit.constraint].limit;
    for (int i = 0; i < sizing_.size(); ++i) {
      double d = slope.dot(dy_[limit.part][i].col(rows_[r].kept).segment(limit.first, limit.count));
      if (limit.element >= 0) d += explicit_stress_slope(limit, y, i);
      dg(static_cast<int>(r), i) = scale * d;
    }
  }
}

template <FrameGroup G>
std::vector<typename StaticSizing<G>::Law> StaticSizing<G>::stiffness_derivatives(
    const Part& part) const {
  std::vector<Law> dK(sizing_.size());
  for (int i = 0; i < sizing_.size(); ++i)
    for (const auto& at : sizing_.elements(i)) {
      if (at.body != part.body) continue;
      if (dK[i].empty()) dK[i].assign(part.align.size(), G::Matrix::Zero());
      dK[i][at.element] =
          space_.reduce_law(sizing_.derivative(mechanism_, i, at).K, part.align[at.element]);
    }
  return dK;
}

template <FrameGroup G>
void StaticSizing<G>::hessian(const Eigen::VectorXd&, double sigma, const Eigen::VectorXd& lambda,
                              Eigen::MatrixXd& h) {
  const int n = sizing_.size();
  std::vector<std::vector<std::vector<std::pair<SizedElement, SectionLaw>>>> second(n);
  for (int i = 0; i < n; ++i) {
    second[i].resize(n);
    for (int j = 0; j <= i; ++j)
      for (const auto& a : sizing_.elements(i))
        for (const auto& b : sizing_.elements(j))
          if (a.body == b.body && a.element == b.element)
            second[i][j].push_back({a, sizing_.second_derivative(mechanism_, i, j, a)});
    for (int j = 0; j <= i; ++j)
      for (const auto& [at, law] : second[i][j])
        if (std::find(study_.mass_of.begin(), study_.mass_of.end(), at.body) !=
            study_.mass_of.end())
          h(i, j) +=
              sigma * law.M(0, 0) *
              element_length(std::get<BeamSpec>(mechanism_.bodies[at.body].kind), at.element);
  }
  for (size_t p = 0; p < parts_.size(); ++p) {
    const Part& part = parts_[p];
    Eigen::MatrixXd w = Eigen::MatrixXd::Zero(part.outputs(), part.problem.cases());
    for (size_t r = 0; r < rows_.size(); ++r) {
      const Limit& limit = limits_[rows_[r].limit];
      const double weight =
          lambda[static_cast<int>(r)] / study_.constraints[limit.constraint].limit;
      if (limit.part != static_cast<int>(p) || weight == 0) continue;
      const int kept = rows_[r].kept;
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
    typename StaticPart<G>::Second d2K(n, std::vector<Law>(n));
    for (int i = 0; i < n; ++i)
      for (int j = 0; j <= i; ++j)
        for (const auto& [at, law] : second[i][j]) {
          if (at.body != part.body) continue;
          if (d2K[i][j].empty()) d2K[i][j].assign(part.align.size(), G::Matrix::Zero());
          d2K[i][j][at.element] = space_.reduce_law(law.K, part.align[at.element]);
        }
    part.problem.add_second(stiffness_derivatives(part), d2K, w, h);
  }
}

template class StaticSizing<SE2>;
template class StaticSizing<SE3>;

}  // namespace liesl
