#pragma once
/// @file
/// Limits on the natural frequencies of a mechanism in a pose.

#include <memory>
#include <optional>

#include "mbs/model/body_alone.hpp"
#include "mbs/solvers/pose_modes.hpp"
#include "optim/design/design.hpp"
#include "optim/problems/static_problem.hpp"

namespace liesl {

/// A copy whose joints hold exactly, as they do in modes, also where the motion has penalties.
Mechanism with_multipliers(Mechanism mechanism);

/// The modes of one design in the poses of the limits on its frequencies: of the whole mechanism,
/// or of one body alone.
struct LimitedModes {
  /// @param designed a mechanism with multipliers; referred to
  LimitedModes(const Mechanism& designed, const SimulationOptions& options,
               const std::vector<FrequencyLimitSpec>& limits);
  LimitedModes(const LimitedModes&) = delete;
  LimitedModes& operator=(const LimitedModes&) = delete;

  /// Number i of limit l, Hz; NaN where `reason` says why there is none.
  double frequency(std::size_t l, int i) const;
  /// d lambda/dp of limit l.
  Eigen::VectorXd lambda_by(std::size_t l, const Parameter& parameter) const;

  /// What vibrates: a body, -1: the whole. The model refers to the mechanism.
  struct Vibrating {
    Vibrating(const Mechanism& designed, int of_body);
    Vibrating(const Vibrating&) = delete;
    Vibrating& operator=(const Vibrating&) = delete;

    int body;
    std::optional<BodyAlone> alone;  ///< none: the whole
    const Mechanism& mechanism;
    Model<SE3> model;
  };
  struct Limited {
    const Vibrating* of;
    PoseModes modes;
  };

  const Mechanism& mechanism;                         ///< with the design
  std::vector<std::unique_ptr<Vibrating>> vibrating;  ///< without repetition
  std::vector<Limited> limited;                       ///< one a limit
  std::string reason;  ///< why a limit has fewer frequencies than it counts; empty: none has

 private:
  const Vibrating& vibrating_of(int body);
};

/// Rows 1 - f_i/least <= 0 of the lowest frequencies, exact at every x (without second derivatives:
/// frequencies are nearly linear in dimensions of sections). The objective is 0. Those with a
/// weight are rows of a term of the objective, numbered from `first_term` on.
class FrequencyProblem final : public CaselessProblem {
 public:
  FrequencyProblem(const Mechanism& mechanism, const Design& design,
                   const SimulationOptions& options, const std::vector<FrequencyLimitSpec>& limits,
                   const Eigen::VectorXd& x, int first_term = 0);

  std::string undefined_reason() const override { return latest_ ? latest_->reason : ""; }
  std::vector<RowImage> images() const override { return images_; }
  std::vector<ObjectiveTerm> objective_terms() const override { return terms_; }
  void values(const Eigen::VectorXd& x, double& f, Eigen::VectorXd& g) override;
  void gradients(const Eigen::VectorXd& x, Eigen::VectorXd& df, RowMatrix& dg) override;

 private:
  Mechanism designed_;  ///< with the design of the latest values
  const Design& design_;
  const SimulationOptions options_;
  const std::vector<FrequencyLimitSpec> limits_;
  std::vector<RowImage> images_;
  std::vector<ObjectiveTerm> terms_;
  std::unique_ptr<LimitedModes> latest_;  ///< of the latest values, for their gradients
};

}  // namespace liesl
