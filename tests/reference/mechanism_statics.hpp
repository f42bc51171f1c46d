#pragma once
/// @file
/// Static problems of the whole mechanism with its joints, at the positions of its motion (thesis
/// section 5.2), and rows of a cycle that follow them: what they would add to those of single
/// parts.

#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "mbs/bodies/assemble_body.hpp"
#include "mbs/solvers/iteration_matrix.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/problems/design_run.hpp"
#include "optim/problems/motion_rows.hpp"

namespace liesl::test {

/// At record n of the motion of the design x_k, positions H_n, drives held, no prestress:
///   [K(x)  B^T] [u ]   [f_n]
///   [B      0 ] [mu] = [ 0 ],   f_n = g_int(H_n; x_k),   y(x) = y_n + C (u(x) - u(x_k)),
/// K the stiffness of all bodies, B the gradients of all joints, C = dy/dH. Sections of beams
/// change K alone.
template <FrameGroup G>
class MechanismStatics {
 public:
  using VectorXd = Eigen::VectorXd;

  /// @pre all outlive this; x_k is the design of `run`
  MechanismStatics(const DesignSimulator<G>& simulator, const DesignRun<G>& run)
      : simulator_(simulator), run_(run) {}

  /// |y| of a response at a record under the design x. @param slope null, or d|y|/dx
  double value(const ResponseSpec& response, int record, const VectorXd& x, VectorXd* slope) {
    if (x_.size() != x.size() || x_ != x) {
      at_ = designed(x);
      x_ = x;
    }
    State<G> s = run_.model->initial_state();
    run_.simulation.trajectory.read(record, s);
    const VectorXd f = loads(s);
    auto& u_k = u_k_[record];
    if (u_k.size() == 0) u_k = solved(*run_.model, s, f, false);
    const VectorXd u = solved(*at_.model, s, f, false);
    const ResponseValues<G> values(run_.mechanism, *run_.model);
    const Eigen::MatrixXd C = by_frames(values, response, s);
    const VectorXd y = values(response, s) + C.transpose() * (u - u_k);
    const double v = y.norm();
    if (slope && v > 0) *slope = slopes(s, u, solved(*at_.model, s, C * y / v, true));
    if (slope && v == 0) slope->setZero(x.size());
    return v;
  }

 private:
  struct Designed {
    Mechanism mechanism;
    std::shared_ptr<Model<G>> model;
    std::vector<std::unique_ptr<ParameterResidual<G>>> by;  ///< one a variable
  };

  Designed designed(const VectorXd& x) const {
    Designed d;
    d.mechanism = simulator_.design().apply(simulator_.mechanism(), x);
    d.model = std::make_shared<Model<G>>(Model<G>::build(d.mechanism, run_.model->space));
    for (const Parameter& p : simulator_.design().parameters(d.mechanism, x))
      d.by.push_back(std::make_unique<ParameterResidual<G>>(d.mechanism, *d.model, p));
    return d;
  }

  /// f_n, and 0 for the joints.
  VectorXd loads(const State<G>& s) const {
    const Model<G>& model = *run_.model;
    VectorXd f = VectorXd::Zero(model.size() + model.constraints());
    for (std::size_t b = 0; b < model.bodies.size(); ++b) {
      const int first = model.first_node(static_cast<int>(b));
      model.bodies[b]->add_elastic_force(s.H.data() + first, f.data() + G::dim * first);
    }
    return f;
  }

  static VectorXd solved(const Model<G>& model, State<G> s, VectorXd b, bool transposed) {
    const LoadLevel unloaded{s.t, 0};
    s.lambda.setZero();
    Equations<G> equations(model);
    equations.evaluate(s, s.rows, unloaded);
    IterationMatrix<G> S(model);
    S.assemble(equations, s, unloaded);
    if (!S.factor()) throw std::runtime_error("the mechanism can move with its drives held");
    transposed ? S.lu().solve_transposed(b) : S.lu().solve(b);
    return b;
  }

  Eigen::MatrixXd by_frames(const ResponseValues<G>& values, const ResponseSpec& response,
                            const State<G>& s) const {
    const auto gradients = values.gradient(response, s);
    const Model<G>& model = *run_.model;
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(model.size() + model.constraints(),
                                              static_cast<Eigen::Index>(gradients.size()));
    for (std::size_t i = 0; i < gradients.size(); ++i)
      for (const auto& node : gradients[i].nodes)
        C.col(static_cast<Eigen::Index>(i)).template segment<G::dim>(G::dim * node.node) += node.h;
    return C;
  }

  /// -mu^T dK/dx_i u
  VectorXd slopes(const State<G>& s, const VectorXd& u, const VectorXd& mu) const {
    VectorXd out = VectorXd::Zero(x_.size());
    const Model<G>& model = *run_.model;
    for (std::size_t i = 0; i < at_.by.size(); ++i)
      for (int b = 0; b < static_cast<int>(model.bodies.size()); ++b) {
        const Body<G>* change = at_.by[i]->body(b);
        if (!change) continue;
        const typename Body<G>::Stresses rest(std::size_t(change->stresses()), G::Tangent::Zero());
        BodyMatrix<G::dim> K(change->nodes());
        K.set_form(change->stiffness());
        change->exact_tangent(model.body_state(s, b), Model<G>::Vector::Zero(), {}, rest.data(), K);
        each_block(K, G::dim * model.first_node(b), [&](int row, int column, const auto& block) {
          out[static_cast<Eigen::Index>(i)] -=
              mu.segment(row, block.rows()).dot(block * u.segment(column, block.cols()));
        });
      }
    return out;
  }

  const DesignSimulator<G>& simulator_;
  const DesignRun<G>& run_;
  VectorXd x_;
  Designed at_;                  ///< of x_
  std::map<int, VectorXd> u_k_;  ///< u(x_k) by record
};

/// The rows of MotionRows, which stay, as static problems of the whole mechanism tell them.
template <FrameGroup G>
class MechanismRows final : public CaselessProblem {
 public:
  MechanismRows(std::unique_ptr<MotionRows> rows, MechanismStatics<G> statics,
                const StudySpec& study)
      : CaselessProblem(rows->variables()), rows_(std::move(rows)), statics_(std::move(statics)) {
    constraints_ = rows_->constraints();
    for (const RowImage& image : rows_->images()) {
      of_.push_back(rows_->responses()[std::size_t(image.response)]);
      limit_.push_back(study.constraints[std::size_t(of_.back().constraint)].limit);
    }
  }

  int load_cases() const override { return rows_->load_cases(); }
  std::vector<LimitedResponse> responses() const override { return rows_->responses(); }
  std::vector<RowImage> images() const override { return rows_->images(); }
  HessianShape hessian_shape() const override { return HessianShape::None; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override {
    f = 0;
    for (std::size_t i = 0; i < of_.size(); ++i) g[Eigen::Index(i)] = value(i, x, nullptr) - 1;
  }
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override {
    df.setZero();
    Eigen::VectorXd slope;
    for (std::size_t i = 0; i < of_.size(); ++i) {
      value(i, x, &slope);
      dg.row(Eigen::Index(i)) = slope.transpose() / limit_[i];
    }
  }

 private:
  double value(std::size_t row, const Eigen::VectorXd& x, Eigen::VectorXd* slope) {
    return statics_.value(of_[row].response, rows_->images()[row].record, x, slope) / limit_[row];
  }
  std::unique_ptr<MotionRows> rows_;
  MechanismStatics<G> statics_;
  std::vector<LimitedResponse> of_;  ///< of the rows
  std::vector<double> limit_;        ///< of the rows
};

}  // namespace liesl::test
