#pragma once
/// @file
/// The states of a simulation at its recorded instants, one after the other.

#include <algorithm>
#include <cassert>
#include <memory>
#include <vector>

#include "mbs/linalg/record_memory.hpp"
#include "mbs/system/state.hpp"

namespace liesl {

/// A record is frames, t, v, vdot, w, lambda and coupling rows of a state, in this order. Many of
/// them are in a file (RecordMemory): written and read one after the other, they take little
/// memory.
template <FrameGroup G>
class Trajectory {
 public:
  using Vector = Eigen::Map<const Eigen::VectorXd>;

  /// Room for `records` states shaped like `s`: recording up to there allocates nothing.
  void reserve(const State<G>& s, int records) {
    set_shape(s);
    values_.reserve(stride_ * static_cast<std::size_t>(records), used());
  }

  void record(const State<G>& s) {
    if (stride_ == 0) set_shape(s);
    assert(s.H.size() == nodes_ && s.v.size() == velocities_ && s.w.size() == coordinates_ &&
           s.lambda.size() == multipliers_ && s.rows.size() == rows_);
    if (used() + stride_ > values_.capacity()) values_.reserve(2 * used() + stride_, used());
    double* const at = values_.data() + used();
    ++size_;
    std::uninitialized_copy(s.H.begin(), s.H.end(), reinterpret_cast<G*>(at));
    double* next = at + first_;
    *next++ = s.t;
    for (const Eigen::VectorXd* x : {&s.v, &s.vdot, &s.w, &s.lambda, &s.rows})
      next = std::copy(x->begin(), x->end(), next);
    let_go_before(size_ - 1);
  }

  int size() const { return size_; }
  double time(int n) const { return at(n)[first_]; }
  const G* frames(int n) const { return reinterpret_cast<const G*>(at(n)); }
  Vector v(int n) const { return part(n, 0, velocities_); }
  Vector vdot(int n) const { return part(n, velocities_, velocities_); }
  Vector w(int n) const { return part(n, 2 * velocities_, coordinates_); }
  Vector lambda(int n) const { return part(n, 2 * velocities_ + coordinates_, multipliers_); }
  Vector rows(int n) const { return part(n, 2 * velocities_ + coordinates_ + multipliers_, rows_); }

  /// Copies record n into a state.
  void read(int n, State<G>& s) const {
    s.t = time(n);
    s.H.assign(frames(n), frames(n) + nodes_);
    s.v = v(n);
    s.vdot = vdot(n);
    s.w = w(n);
    s.lambda = lambda(n);
    s.rows = rows(n);
    let_go_before(n);
  }

 private:
  std::size_t used() const { return stride_ * static_cast<std::size_t>(size_); }
  /// Of each few megabytes of records, once the last of them is n.
  void let_go_before(int n) const {
    constexpr std::size_t kWindow = std::size_t{1} << 19;  // doubles
    const std::size_t records = std::max(kWindow / stride_, std::size_t{1}),
                      next = static_cast<std::size_t>(n) + 1;
    if (next % records == 0) values_.let_go(stride_ * (next - records), stride_ * next);
  }
  void set_shape(const State<G>& s) {
    constexpr std::size_t kFrame = sizeof(G) / sizeof(double),
                          kAligned = alignof(G) / sizeof(double);
    nodes_ = s.H.size();
    first_ = kFrame * nodes_;
    velocities_ = s.v.size();
    coordinates_ = s.w.size();
    multipliers_ = s.lambda.size();
    rows_ = s.rows.size();
    const auto vectors =
        static_cast<std::size_t>(1 + 2 * velocities_ + coordinates_ + multipliers_ + rows_);
    stride_ = (first_ + vectors + kAligned - 1) / kAligned * kAligned;
  }
  const double* at(int n) const { return values_.data() + stride_ * static_cast<std::size_t>(n); }
  Vector part(int n, Eigen::Index from, Eigen::Index size) const {
    return Vector(at(n) + first_ + 1 + from, size);
  }

  int size_ = 0;
  std::size_t nodes_ = 0, first_ = 0, stride_ = 0;  ///< of a record: doubles before t, and all
  Eigen::Index velocities_ = 0, coordinates_ = 0, multipliers_ = 0, rows_ = 0;
  RecordMemory values_;
};

}  // namespace liesl
