#pragma once
/// @file
/// Static problems of the whole mechanism with its joints at the positions of its motion (thesis
/// section 5.2): how responses of several bodies follow their sections.

#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "mbs/solvers/iteration_matrix.hpp"
#include "mbs/system/parameter_residual.hpp"
#include "mbs/system/response_value.hpp"
#include "optim/problems/design_run.hpp"
#include "optim/study/without_mechanism_statics.hpp"

namespace liesl {

/// The mechanism can move with its drives held, so it has no static problem.
struct MechanismMoves : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// At record n of the motion of the design x_k, positions H_n, drives held, no prestress:
///   [K(x)  B^T] [u ]   [f_n]
///   [B      0 ] [mu] = [ 0 ],   f_n = g_int(H_n; x_k),   y(x) = y_n + C (u(x) - u(x_k)),
/// u increments of the frames and amplitudes, K the stiffness of all bodies and springs, g_int the
/// elastic forces of the bodies by u, B the gradients of all joints, C = dy/du. Sections of beams
/// change K; what a stress takes from its section at constant u is not told. One factor a record
/// and design.
template <FrameGroup G>
class MechanismStatics {
 public:
  using VectorXd = Eigen::VectorXd;

  /// @pre all outlive this; x_k is the design of `run`, whose variables are sizes of sections of
  /// beams that are not in modes
  /// @param records that are asked for
  /// @throws MechanismMoves if it can at one of them
  MechanismStatics(const DesignSimulator<G>& simulator, const DesignRun<G>& run,
                   const std::vector<int>& records);

  /// |y| of a response at a record under the design x. @param slope null, or d|y|/dx
  double value(const ResponseSpec& response, int record, const VectorXd& x, VectorXd* slope);

 private:
  struct Designed {
    Mechanism mechanism;
    std::shared_ptr<Model<G>> model;
    std::vector<std::unique_ptr<ParameterResidual<G>>> by;  ///< one a variable
  };
  struct Record {
    State<G> state;  ///< H_n at rest, without multipliers
    VectorXd f;      ///< f_n, and 0 for the joints
    VectorXd u_k;    ///< u(x_k), mu
  };
  struct Solved {
    std::unique_ptr<IterationMatrix<G>> S;  ///< of x, factored
    VectorXd u;
  };

  Record loaded(int record) const;
  Designed designed(const VectorXd& x) const;
  static std::unique_ptr<IterationMatrix<G>> assembled(const Model<G>& model, const Record& n);
  /// @throws MechanismMoves if it is singular
  static Solved solved(const Model<G>& model, const Record& n);
  const Solved& solution(int record, const VectorXd& x);
  /// C, a column a component.
  Eigen::MatrixXd by_increments(const ResponseValues<G>& values, const ResponseSpec& response,
                                const State<G>& s) const;
  /// -mu^T dK/dx_i u
  VectorXd slopes(const Record& n, const VectorXd& u, const VectorXd& mu) const;
  /// The same of one variable by central differences: of elements of order 4, whose stiffness is
  /// not linear in that of their section.
  double difference(Eigen::Index i, const Record& n, const VectorXd& u, const VectorXd& mu) const;
  bool has_fourth_order() const;

  const DesignSimulator<G>& simulator_;
  const DesignRun<G>& run_;
  std::map<int, Record> records_;
  VectorXd x_;                    ///< of the latest call
  Designed at_;                   ///< of x_
  std::map<int, Solved> solved_;  ///< by record, of x_
};

extern template class MechanismStatics<SE2>;
extern template class MechanismStatics<SE3>;

}  // namespace liesl
