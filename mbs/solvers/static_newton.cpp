#include "mbs/solvers/static_newton.hpp"

#include "mbs/solvers/divergence.hpp"

namespace liesl {
namespace {

constexpr double kClosure = 1e-3;   // constraint tolerance: this * tolerance * length
constexpr double kLoadStep = 1e-4;  // central difference in the load factor, of max_load
constexpr double kIncrement = 0.1;  // last correction: this * sqrt(tolerance), of length or in rad
constexpr double kHalfTurn = M_PI - 1e-6;   // log is singular at a relative rotation of pi
constexpr double kNearFold = 0.999 * M_PI;  // where a step that fails has that reason

/// Of the first body that has one; empty: none has.
template <FrameGroup G>
std::string fault_of(const Model<G>& model, const State<G>& s) {
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const auto fault = model.bodies[b]->fault(s.H.data() + model.first_node(static_cast<int>(b)));
    if (fault) return fault->what + ": " + fault->remedy + ", or more load steps";
  }
  return {};
}

}  // namespace

template <FrameGroup G>
StaticNewton<G>::StaticNewton(const Model<G>& model, const SimulationOptions& options)
    : model_(model), options_(options), equations_(model), system_(model) {
  rhs_.setZero(system_.size() + system_.constraints(), 2);
  predictor_.setZero(model.size());
  delta_.setZero(model.size());
  for (size_t b = 0; b < model.bodies.size(); ++b) {
    const Body<G>& body = *model.bodies[b];
    std::vector<int> frames;
    for (int k = 0; k < body.nodes(); ++k)
      if (body.kind(k) == NodeKind::Frame)
        frames.push_back(model.first_node(static_cast<int>(b)) + k);
    if (static_cast<int>(frames.size()) < body.nodes() &&
        body.kind(body.nodes() - 1) == NodeKind::Position)
      straight_.insert(straight_.end(), frames.begin(), frames.end());
  }
}

template <FrameGroup G>
void StaticNewton<G>::evaluate(const State<G>& s, double load) {
  equations_.evaluate(s, s.rows, level(load));
}

template <FrameGroup G>
void StaticNewton<G>::evaluate_about_prestress(const State<G>& s, double load) {
  equations_.evaluate(s, s.rows, level(load), &system_.prestress().section);
}

template <FrameGroup G>
bool StaticNewton<G>::small_enough() const {
  const double round_off = equations_.round_off() * std::sqrt(model_.nodes());
  return equations_.residual() <= options_.tolerance * equations_.scale() + round_off &&
         equations_.constraint_residual() <= kClosure * options_.tolerance * model_.length;
}

template <FrameGroup G>
bool StaticNewton<G>::in_equilibrium(const State<G>& s, double load) {
  evaluate(s, load);
  return small_enough();
}

template <FrameGroup G>
const typename IterationMatrix<G>::Matrix& StaticNewton<G>::tangent(const State<G>& s) {
  evaluate(s, s.t);
  system_.take_prestress(equations_, s);
  return system_.assemble(equations_, s, level(s.t));
}

/// d[r; phi]/d(load factor); exact where loads grow linearly.
template <FrameGroup G>
void StaticNewton<G>::load_column(const State<G>& s, double load,
                                  Eigen::Ref<Eigen::VectorXd> column) {
  const double h = kLoadStep * options_.max_load;
  evaluate_about_prestress(s, load + h);
  column << equations_.r, equations_.phi;
  evaluate_about_prestress(s, load - h);
  column.head(system_.size()) -= equations_.r;
  column.tail(system_.constraints()) -= equations_.phi;
  column /= 2 * h;
}

/// rhs_ = -A^-1 [r phi | d/d(load)], equations_ evaluated at (s, load) again.
template <FrameGroup G>
bool StaticNewton<G>::solve_both(const State<G>& s, double load) {
  load_column(s, load, rhs_.col(1));
  evaluate_about_prestress(s, load);
  rhs_.col(0) << equations_.r, equations_.phi;
  system_.assemble(equations_, s, level(load));
  if (!system_.factor()) return false;
  rhs_ = -rhs_;
  system_.lu().solve(rhs_);
  return rhs_.allFinite();
}

/// sum over frames of u_a . u_b + length^2 w_a . w_b
template <FrameGroup G>
double StaticNewton<G>::product(const Eigen::VectorXd& a,
                                Eigen::Ref<const Eigen::VectorXd> b) const {
  constexpr int sd = G::space_dim, rd = G::rotation_dim;
  double sum = 0, turn = 0;
  for (const int node : model_.positions())
    sum += a.template segment<sd>(dim * node).dot(b.template segment<sd>(dim * node));
  for (const int node : model_.frames()) {
    const int k = dim * node;
    sum += a.template segment<sd>(k).dot(b.template segment<sd>(k));
    turn += a.template segment<rd>(k + sd).dot(b.template segment<rd>(k + sd));
  }
  return sum + model_.length * model_.length * turn;
}

/// Extrapolates the prestress and moves the trial state.
template <FrameGroup G>
void StaticNewton<G>::correct(Eigen::Ref<const Eigen::VectorXd> step) {
  delta_ = step.head(system_.size());
  system_.extrapolate_prestress(equations_, trial_, delta_);
  moved_ = std::sqrt(product(delta_, delta_) / model_.nodes()) / model_.length;
  move();
  trial_.lambda += step.tail(system_.constraints());
}

/// By the increments. Positions move straight, and so do the frames beside them: on the arc of a
/// screw they would leave them by half the turn times the way.
template <FrameGroup G>
void StaticNewton<G>::move() {
  std::vector<typename Model<G>::Vector> x;
  for (const int k : straight_)
    x.push_back(trial_.H[k].x + trial_.H[k].R * delta_.template segment<G::space_dim>(dim * k));
  model_.retract(trial_, delta_);
  for (std::size_t i = 0; i < x.size(); ++i) trial_.H[straight_[i]].x = x[i];
}

/// Records the residual; @returns true if the iteration continues.
template <FrameGroup G>
bool StaticNewton<G>::check(NewtonResult& result) {
  const double residual = equations_.residual();
  result.residuals.push_back(residual / std::max(equations_.scale(), 1e-300));
  result.converged = false;
  if (!std::isfinite(residual + equations_.constraint_residual()))
    result.failure = divergence(model_, trial_);
  else if (small_enough() && moved_ <= kIncrement * std::sqrt(options_.tolerance))
    result.converged = true;
  else if (result.iterations == options_.max_iterations)
    result.failure = "the iteration did not converge";
  else
    return true;
  return false;
}

/// Does an element turn by more than an angle? By pi its strain has no unique value.
template <FrameGroup G>
bool StaticNewton<G>::turns_by(double angle, const State<G>& s) const {
  for (size_t b = 0; b < model_.bodies.size(); ++b) {
    const int first = model_.first_node(static_cast<int>(b));
    for (int e = 0; e < model_.bodies[b]->elements(); ++e) {
      const auto d = G::log(s.H[first + e].inverse() * s.H[first + e + 1]);
      if (d.template tail<G::rotation_dim>().norm() > angle) return true;
    }
  }
  return false;
}

template <FrameGroup G>
void StaticNewton<G>::finish(State<G>& s, double load, NewtonResult& result) {
  const char* const kTurns = "an element turns by pi: use more elements";
  if (!result.converged) {
    result.misshapen = turns_by(kNearFold, s);
    if (result.misshapen) result.failure = kTurns;
    return;
  }
  for (size_t b = 0; b < model_.bodies.size(); ++b)
    model_.bodies[b]->turn_axes(trial_.H.data() + model_.first_node(static_cast<int>(b)));
  const bool turned = turns_by(kHalfTurn, trial_);
  const std::string fault = turned ? kTurns : fault_of(model_, trial_);
  if (!fault.empty()) {
    result.converged = false;
    result.misshapen = true;
    result.failure = fault;
    return;
  }
  for (auto& H : trial_.H) H.orthonormalize();
  model_.complete(trial_);
  trial_.t = load;
  equations_.observe(trial_, s.rows, trial_.rows);
  std::swap(s, trial_);
}

template <FrameGroup G>
NewtonResult StaticNewton<G>::solve(State<G>& s, double load) {
  NewtonResult result;
  trial_ = s;
  moved_ = 0;
  evaluate(trial_, load);
  system_.take_prestress(equations_, trial_);
  while (check(result)) {
    system_.assemble(equations_, trial_, level(load));
    rhs_.col(0) << equations_.r, equations_.phi;
    if (!system_.factor()) {
      result.singular = result.iterations == 0;
      result.failure = "the tangent is singular";
      return result;
    }
    rhs_.col(0) = -rhs_.col(0);
    system_.lu().solve(rhs_.col(0));
    correct(rhs_.col(0));
    ++result.iterations;
    equations_.observe(trial_, trial_.rows, trial_.rows);
    evaluate_about_prestress(trial_, load);
  }
  finish(s, load, result);
  return result;
}

template <FrameGroup G>
double StaticNewton<G>::speed(const State<G>& s) {
  evaluate(s, s.t);
  system_.take_prestress(equations_, s);
  if (!solve_both(s, s.t)) return 0;
  delta_ = rhs_.col(1).head(system_.size());
  return std::sqrt(product(delta_, delta_));
}

template <FrameGroup G>
NewtonResult StaticNewton<G>::follow(State<G>& s, double ds, const Eigen::VectorXd& direction) {
  NewtonResult result;
  trial_ = s;
  moved_ = 0;
  double load = s.t;
  evaluate(trial_, load);
  system_.take_prestress(equations_, trial_);
  Eigen::VectorXd t;
  do {
    if (!solve_both(trial_, load)) {
      result.singular = result.iterations == 0;
      result.failure = "the tangent is singular";
      return result;
    }
    double change;
    if (result.iterations == 0) {
      t = rhs_.col(1).head(system_.size());
      t /= std::sqrt(product(t, t));
      if (!t.allFinite()) {
        result.failure = "the load moves nothing";
        return result;
      }
      if (product(t, direction) < 0) t = -t;
      change = ds / product(t, rhs_.col(1).head(system_.size()));
      rhs_.col(0).setZero();
    } else {
      change = -product(t, rhs_.col(0).head(system_.size())) /
               product(t, rhs_.col(1).head(system_.size()));
    }
    load += change;
    rhs_.col(0) += change * rhs_.col(1);
    correct(rhs_.col(0));
    ++result.iterations;
    equations_.observe(trial_, trial_.rows, trial_.rows);
    evaluate_about_prestress(trial_, load);
  } while (check(result));
  finish(s, load, result);
  if (result.converged) predictor_ = t;
  return result;
}

template class StaticNewton<SE2>;
template class StaticNewton<SE3>;

}  // namespace liesl
