#pragma once
/// @file
/// The states of a simulation at its recorded instants, in contiguous blocks.

#include "mbs/system/state.hpp"

namespace liesl {

template <FrameGroup G>
class Trajectory {
 public:
  /// Room for `records` states shaped like `s`: recording up to there allocates nothing.
  void reserve(const State<G>& s, int records) {
    nodes_ = static_cast<int>(s.H.size());
    H_.reserve(static_cast<size_t>(nodes_) * records);
    t_.reserve(records);
    v_.resize(s.v.size(), records);
    vdot_.resize(s.v.size(), records);
    w_.resize(s.w.size(), records);
    lambda_.resize(s.lambda.size(), records);
    rows_.resize(s.rows.size(), records);
  }

  void record(const State<G>& s) {
    const int n = size();
    if (n == v_.cols()) grow(s);
    t_.push_back(s.t);
    H_.insert(H_.end(), s.H.begin(), s.H.end());
    v_.col(n) = s.v;
    vdot_.col(n) = s.vdot;
    w_.col(n) = s.w;
    lambda_.col(n) = s.lambda;
    rows_.col(n) = s.rows;
  }

  int size() const { return static_cast<int>(t_.size()); }
  double time(int n) const { return t_[n]; }
  const G* frames(int n) const { return H_.data() + static_cast<size_t>(nodes_) * n; }
  auto v(int n) const { return v_.col(n); }
  auto vdot(int n) const { return vdot_.col(n); }
  auto w(int n) const { return w_.col(n); }
  auto lambda(int n) const { return lambda_.col(n); }
  auto rows(int n) const { return rows_.col(n); }

  /// Copies record n into a state.
  void read(int n, State<G>& s) const {
    s.t = t_[n];
    s.H.assign(frames(n), frames(n) + nodes_);
    s.v = v_.col(n);
    s.vdot = vdot_.col(n);
    s.w = w_.col(n);
    s.lambda = lambda_.col(n);
    s.rows = rows_.col(n);
  }

 private:
  void grow(const State<G>& s) {
    const int records = std::max(16, 2 * size());
    v_.conservativeResize(s.v.size(), records);
    vdot_.conservativeResize(s.v.size(), records);
    w_.conservativeResize(s.w.size(), records);
    lambda_.conservativeResize(s.lambda.size(), records);
    rows_.conservativeResize(s.rows.size(), records);
    nodes_ = static_cast<int>(s.H.size());
  }

  int nodes_ = 0;
  std::vector<double> t_;
  Frames<G> H_;
  Eigen::MatrixXd v_, vdot_, w_, lambda_, rows_;
};

}  // namespace liesl
