#pragma once
/// @file
/// Gradients of the limited responses of a motion by the design variables, record by record.

#include <map>
#include <memory>
#include <string>

#include "mbs/sensitivity/response_sensitivity.hpp"
#include "optim/problems/design_run.hpp"
#include "optim/problems/static_problem.hpp"
#include "optim/problems/treatment.hpp"

namespace liesl {

/// v_rn = |y_r(t_n)| of each response r at the records n of its motion, and dv_rn/dx by the
/// sensitivities (mbs/sensitivity), exact but for the tolerance of the simulation. Gradients are
/// kept where v_rn is at least `kept` of the largest value of its limit: less does not bound the
/// design. By the direct form; of many variables by the adjoint one (`adjoint_is_faster`), then of
/// each maximum over time, the records beside it and those of its treatment only.
class MotionGradients {
 public:
  MotionGradients() = default;
  /// @param run of the design x, with a tape
  /// @throws std::invalid_argument if this motion has no sensitivities: formalism, start moved
  /// by the joints
  template <FrameGroup G>
  MotionGradients(const Design& design, const DesignRun<G>& run, const Eigen::VectorXd& x,
                  const std::vector<LimitedResponse>& responses);

  /// @throws std::invalid_argument as the constructor where there are none, without their work
  template <FrameGroup G>
  static void require(const Design& design, const DesignRun<G>& run, const Eigen::VectorXd& x,
                      const std::vector<LimitedResponse>& responses);

  bool by_adjoint() const { return by_adjoint_; }

  /// Puts those of another motion of the same design behind these.
  void append(MotionGradients other);

  /// Takes the responses from number `first` on out of these.
  MotionGradients split(int first);

  /// Replaces the records of a response by fewer, each of them a function of all.
  void aggregate(int response, const std::vector<Aggregate>& by);

  /// Why there are none; empty if all steps were differentiated.
  const std::string& reason() const { return reason_; }
  int responses() const { return static_cast<int>(series_.size()); }
  const LimitedResponse& response(int r) const { return at(r).response; }
  int records(int response) const { return static_cast<int>(at(response).times->size()); }
  double time(int response, int record) const {
    return (*at(response).times)[static_cast<std::size_t>(record)];
  }
  double value(int response, int record) const { return at(response).value[record]; }
  /// -d(value/limit)/d(ln limit): 1 but of some aggregates.
  double by_limit(int response, int record) const {
    const auto& of = at(response).by_limit;
    return of.empty() ? 1 : of[static_cast<std::size_t>(record)];
  }
  /// By the variables; null where it was not kept.
  const Eigen::VectorXd* gradient(int response, int record) const;
  /// The same, or that at the nearest record that has one; null: there is none.
  const Eigen::VectorXd* nearest_gradient(int response, int record, int* found) const;

 private:
  struct Series {
    LimitedResponse response;
    std::shared_ptr<const std::vector<double>> times;
    Eigen::VectorXd value;                    ///< by record
    std::map<int, Eigen::VectorXd> gradient;  ///< by record
    std::vector<double> by_limit = {};        ///< by record of an aggregate
  };
  const Series& at(int response) const { return series_[static_cast<std::size_t>(response)]; }
  template <FrameGroup G>
  void differentiate(const DesignRun<G>& run, const ResponseValues<G>& values,
                     const Parameters<G>& parameters);
  template <FrameGroup G>
  bool differentiate_maxima(const DesignRun<G>& run, const ResponseValues<G>& values,
                            const Parameters<G>& parameters);
  template <FrameGroup G>
  double least_kept(const DesignRun<G>& run, const LimitedResponse& response) const;

  std::vector<Series> series_;
  std::string reason_;
  bool by_adjoint_ = false;
};

extern template MotionGradients::MotionGradients(const Design&, const DesignRun<SE2>&,
                                                 const Eigen::VectorXd&,
                                                 const std::vector<LimitedResponse>&);
extern template MotionGradients::MotionGradients(const Design&, const DesignRun<SE3>&,
                                                 const Eigen::VectorXd&,
                                                 const std::vector<LimitedResponse>&);

}  // namespace liesl
