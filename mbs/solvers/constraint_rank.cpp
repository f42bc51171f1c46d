#include "mbs/solvers/constraint_rank.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

namespace liesl {
namespace {

constexpr double kDependent = 1e-7;  // what is left of a unit row that others span
constexpr double kContradiction = 1e-6;

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

}  // namespace

template <FrameGroup G>
void remove_redundant_constraints(Model<G>& model, const State<G>& s,
                                  std::vector<std::string>& out) {
  Equations<G> eq(model);
  State<G> at = s;
  at.lambda.setZero(model.constraints());
  eq.evaluate(at, s.q, {s.t, 1});
  std::map<int, int> column;  // of a coupled node
  for (const auto& c : model.couplings)
    for (const auto* p : {&c.a, &c.b})
      if (p->body >= 0) column.emplace(p->node, static_cast<int>(column.size()) * G::dim);
  const int columns = G::dim * static_cast<int>(column.size());

  Basis basis;
  std::vector<std::string> owner;  // of each basis row
  bool found = false;
  for (size_t i = 0; i < model.couplings.size(); ++i) {
    auto& c = model.couplings[i];
    std::set<std::string> others;
    int repeated = 0;
    for (int k = 0; k < c.constraints; ++k) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(columns), used;
      if (c.a.body >= 0)
        row.segment<G::dim>(column[c.a.node]) +=
            eq.couplings[i].B.row(k).template head<G::dim>().transpose();
      if (c.b.body >= 0)
        row.segment<G::dim>(column[c.b.node]) +=
            eq.couplings[i].B.row(k).template tail<G::dim>().transpose();
      scale_rotations<G>(row, model.length);
      if (basis.add(row, used)) {
        owner.push_back(c.name);
        continue;
      }
      for (int j = 0; j < used.size(); ++j)
        if (std::abs(used[j]) > 1e-4 && owner[j] != c.name) others.insert("'" + owner[j] + "'");
      c.equations[k].role = Role::Redundant;
      ++repeated;
    }
    if (repeated == 0) continue;
    found = true;
    out.push_back(
        fmt::format("joint '{}' repeats rows of {}: {} of its {} rows {} left out", c.name,
                    others.empty() ? "itself" : fmt::format("{}", fmt::join(others, ", ")),
                    repeated, c.constraints, repeated == 1 ? "is" : "are"));
  }
  if (found) model.finish();
}

template <FrameGroup G>
std::string contradiction(const Model<G>& model, const State<G>& s) {
  for (const auto& c : model.couplings) {
    const RelativeMotion<G> motion(c.a.frame(s.H), c.b.frame(s.H));
    for (size_t i = 0; i < c.equations.size(); ++i) {
      const auto& e = c.equations[i];
      if (e.role != Role::Redundant) continue;
      const double off =
          e.row.value(motion, s.q[c.first_row + static_cast<int>(i)]) - e.target(s.t);
      const bool length = e.row.kind() == RowKind::Along || e.row.kind() == RowKind::Distance;
      if (std::abs(off) > kContradiction * (length ? model.length : 1))
        return fmt::format(
            "joint '{}' repeats other joints and contradicts them by {:.3g} {} at t = {:.6g} s; "
            "take it out, or give one of the bodies between them some flexibility",
            c.name, off, length ? "m" : "rad", s.t);
    }
  }
  return {};
}

template <FrameGroup G>
Mobility mobility(const Model<G>& model, const State<G>& s) {
  const int bodies = static_cast<int>(model.bodies.size());
  Basis basis;
  Mobility m;
  for (const auto& c : model.couplings) {
    const G a = c.a.frame(s.H), b = c.b.frame(s.H);
    const RelativeMotion<G> motion(a, b);
    for (const auto& e : c.equations) {
      if (e.role != Role::Constraint && e.role != Role::Redundant) continue;
      typename Row<G>::Gradient g;
      e.row.gradient(motion, g);
      Eigen::VectorXd row = Eigen::VectorXd::Zero(G::dim * bodies), used;
      const auto add = [&](const PortOf<G>& p, const G& H,
                           auto gradient) {  // body increments: inertial axes
        if (p.body >= 0)
          row.template segment<G::dim>(G::dim * p.body) += H.AdInv().transpose() * gradient;
      };
      add(c.a, a, g.template head<G::dim>());
      add(c.b, b, g.template tail<G::dim>());
      scale_rotations<G>(row, model.length);
      if (!basis.add(row, used)) ++m.redundant;
    }
  }
  m.free = G::dim * bodies - basis.rank();
  return m;
}

template void remove_redundant_constraints(Model<SE2>&, const State<SE2>&,
                                           std::vector<std::string>&);
template void remove_redundant_constraints(Model<SE3>&, const State<SE3>&,
                                           std::vector<std::string>&);
template std::string contradiction(const Model<SE2>&, const State<SE2>&);
template std::string contradiction(const Model<SE3>&, const State<SE3>&);
template Mobility mobility(const Model<SE2>&, const State<SE2>&);
template Mobility mobility(const Model<SE3>&, const State<SE3>&);

}  // namespace liesl
