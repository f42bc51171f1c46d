#include "mbs/system/constraint_rank.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "mbs/system/constraint_matrix.hpp"

namespace liesl {
namespace {

constexpr double kDependent = 1e-7;  // what is left of a unit row that others span
constexpr double kContradiction = 1e-6;
constexpr int kDirections = 2;  // in which to look for configurations near the start

/// Rows one after the other against an orthonormal basis of those before.
class Basis {
 public:
  /// What is left of the row, relative to it; `used` = coefficients on the basis.
  bool add(Eigen::VectorXd row, Eigen::VectorXd& used) {
    const double norm = row.norm();
    used.setZero(static_cast<int>(q_.size()));
    if (norm == 0) return false;
    row /= norm;
    for (int pass = 0; pass < 2; ++pass)
      for (size_t i = 0; i < q_.size(); ++i) {
        const double c = q_[i].dot(row);
        used[static_cast<int>(i)] += c;
        row -= c * q_[i];
      }
    if (row.norm() < kDependent) return false;
    q_.push_back(row / row.norm());
    return true;
  }
  int rank() const { return static_cast<int>(q_.size()); }

 private:
  std::vector<Eigen::VectorXd> q_;
};

/// Scales rotations so that lengths and angles compare.
template <FrameGroup G>
void scale_rotations(Eigen::Ref<Eigen::VectorXd> row, double length) {
  for (int k = 0; k + G::dim <= row.size(); k += G::dim)
    row.template segment<G::rotation_dim>(k + G::space_dim) /= length;
}

/// What the earlier rows make of one: nothing, or all of it.
struct Dependency {
  bool dependent = false;
  std::vector<long> on;  ///< rows
};

std::vector<Dependency> dependencies(const Eigen::MatrixXd& J) {
  Basis basis;
  std::vector<long> row_of;  // of the basis
  std::vector<Dependency> out(static_cast<size_t>(J.rows()));
  Eigen::VectorXd used;
  for (long i = 0; i < J.rows(); ++i) {
    if (basis.add(J.row(i), used)) {
      row_of.push_back(i);
      continue;
    }
    out[i].dependent = true;
    for (long j = 0; j < used.size(); ++j)
      if (std::abs(used[j]) > 1e-4) out[i].on.push_back(row_of[j]);
  }
  return out;
}

/// Takes out of `rows` what is independent near the start. @returns the couplings of those.
template <FrameGroup G>
std::set<int> singular_here_only(ConstraintMatrix<G>& matrix, const State<G>& s,
                                 std::vector<Dependency>& rows) {
  std::set<int> couplings;
  for (int direction = 0; direction < kDirections; ++direction) {
    const auto perturbed = matrix.perturbed(s, direction);
    if (!perturbed) continue;
    const auto there = dependencies(matrix.evaluate(*perturbed));
    for (size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].dependent || there[i].dependent) continue;
      rows[i].dependent = false;
      couplings.insert(matrix.rows()[i].coupling);
    }
  }
  return couplings;
}

}  // namespace

template <FrameGroup G>
RedundantRows redundant_rows(const Model<G>& model, State<G> s) {
  RedundantRows out;
  ConstraintMatrix<G> matrix(model);
  Equations<G>(model).observe(s, s.rows, s.rows);
  std::vector<Dependency> rows = dependencies(matrix.evaluate(s));
  const auto any = [&] {
    return std::any_of(rows.begin(), rows.end(), [](const auto& r) { return r.dependent; });
  };
  if (!any()) return out;
  if (const auto dead = singular_here_only(matrix, s, rows); !dead.empty()) {
    out.dead_point = fmt::format(
        "joint '{}' depends on the others in the start position, but not near it: a dead point, "
        "where the mechanism may continue in more than one way; start it slightly away from it",
        model.couplings[*dead.begin()].name);
    return out;
  }
  std::map<int, std::set<std::string>> others;  // by coupling
  std::map<int, int> repeated;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].dependent) continue;
    const auto& row = matrix.rows()[i];
    for (const long j : rows[i].on)
      if (const int other = matrix.rows()[j].coupling; other != row.coupling)
        others[row.coupling].insert("'" + model.couplings[other].name + "'");
    ++repeated[row.coupling];
    out.rows.emplace_back(row.coupling, row.equation);
  }
  const bool shares = model.penalty.form != ConstraintForm::Multipliers;
  for (const auto& [coupling, count] : repeated) {
    const auto& c = model.couplings[coupling];
    const auto& names = others[coupling];
    out.sentences.push_back(fmt::format(
        "joint '{}' repeats rows of {}: {} of its {} rows {}", c.name,
        names.empty() ? "itself" : fmt::format("{}", fmt::join(names, ", ")), count, c.constraints,
        shares       ? "shared by their penalties"
        : count == 1 ? "is left out"
                     : "are left out"));
  }
  return out;
}

template <FrameGroup G>
std::string contradiction(const Model<G>& model, const State<G>& s, double t) {
  double before = 0;  // of the coupling that the next may continue
  const auto repeats = [](const auto& row) { return row.role == Role::Redundant; };
  for (const auto& c : model.couplings) {
    if (std::none_of(c.rows.begin(), c.rows.end(), repeats)) continue;
    const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
    for (size_t i = 0; i < c.rows.size(); ++i) {
      const auto& e = c.rows[i];
      if (!repeats(e)) continue;
      double off = e.row.value(motion, s.rows[c.first_row + static_cast<int>(i)]) - e.target(t);
      if (c.continued) off += before;
      before = off;
      if (&c != &model.couplings.back() && (&c + 1)->continued) continue;
      const bool length =
          e.row.kind() == RowKind::Displacement || e.row.kind() == RowKind::Distance;
      if (std::abs(off) > kContradiction * (length ? model.length : 1))
        return fmt::format(
            "joint '{}' repeats other joints and contradicts them by {:.3g} {} at t = {:.6g} s; "
            "take it out, or give one of the bodies between them some flexibility",
            c.name, off, length ? "m" : "rad", t);
    }
  }
  return {};
}

template <FrameGroup G>
Mobility mobility(const Model<G>& model, const State<G>& s) {
  const int bodies = static_cast<int>(model.bodies.size());
  Basis basis;
  Mobility m;
  Eigen::VectorXd row, used;
  const auto add_rows = [&](const Coupling<G>& c, bool drives) {
    const G a = c.a.frame(s.H), b = c.b.frame(s.H);
    const RelativeMotion<G> motion(a, b);
    for (const auto& e : c.rows) {
      if (e.role != Role::Constraint && e.role != Role::Redundant) continue;
      if (drives != (e.coordinate >= 0)) continue;
      typename Row<G>::Gradient g;
      e.row.gradient(motion, g);
      if (!c.continued) row.setZero(G::dim * bodies);
      const auto add = [&](const PortOf<G>& p, const G& H,
                           auto gradient) {  // body increments: inertial axes
        if (p.body >= 0)
          row.template segment<G::dim>(G::dim * p.body) += H.AdInv().transpose() * gradient;
      };
      add(c.a, a, g.template head<G::dim>());
      add(c.b, b, g.template tail<G::dim>());
      if (&c != &model.couplings.back() && (&c + 1)->continued) continue;
      scale_rotations<G>(row, model.length);
      if (basis.add(row, used)) continue;
      ++m.redundant;
      if (drives) m.overdriven.push_back(c.name);
    }
  };
  for (const bool drives : {false, true})
    for (const auto& c : model.couplings) add_rows(c, drives);
  m.free = G::dim * bodies - basis.rank();
  return m;
}

template RedundantRows redundant_rows(const Model<SE2>&, State<SE2>);
template RedundantRows redundant_rows(const Model<SE3>&, State<SE3>);
template std::string contradiction(const Model<SE2>&, const State<SE2>&, double);
template std::string contradiction(const Model<SE3>&, const State<SE3>&, double);
template Mobility mobility(const Model<SE2>&, const State<SE2>&);
template Mobility mobility(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
