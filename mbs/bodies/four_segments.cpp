#include "mbs/bodies/four_segments.hpp"

#include <algorithm>
#include <cmath>

#include "mbs/bodies/segment_angle.hpp"

namespace liesl {
namespace {

using Vec2 = Eigen::Vector2d;
using Vec2x4 = Eigen::Matrix<Lanes, 2, 1>;

Lanes sqrt(const Lanes& x) {
  return {std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

/// Direction of a segment, or of an end section, and its rate.
struct Direction {
  Vec2 t;
  double rate = 0;
};

/// Segments e ... e + 3 of those before `end`, the last one again where there are fewer.
int segment_of(int e, int lane, int end) { return std::min(e + lane, end - 1); }

/// Of four segments.
Lanes gathered(const double* x, int e, int end) {
  const auto of = [&](int lane) { return x[segment_of(e, lane, end)]; };
  return {of(0), of(1), of(2), of(3)};
}

/// of(k + 1) - of(k) from node k of each of four segments to the next.
template <class Of>
Vec2x4 differences(int e, int end, const Of& of) {
  Vec2x4 out;
  for (int lane = 0; lane < Lanes::size; ++lane) {
    const int k = segment_of(e, lane, end);
    const Vec2 d = of(k + 1) - of(k);
    out[0].v[lane] = d[0];
    out[1].v[lane] = d[1];
  }
  return out;
}

double sum(const Lanes& x) { return (x[0] + x[2]) + (x[1] + x[3]); }

/// Values of the segments before: `first`, then those of lanes 0 to 2.
Lanes shifted(double first, const Lanes& x) { return {first, x[0], x[1], x[2]}; }

Direction end_direction(const BodyState<SE2>& s, int node) {
  return {s.H[node].R.col(0), s.v[3 * node + 2]};
}

Direction direction(const BodyState<SE2>& s, int e, bool damped) {
  const Vec2 d = s.H[e + 1].x - s.H[e].x;
  const double l = d.norm();
  const Vec2 t = d / l;
  if (!damped) return {t};
  return {t, turned(t).dot(node_velocity(s, e + 1) - node_velocity(s, e)) / l};
}

/// N_e of segments and M at their first nodes.
struct FourSegments {
  Lanes l, inverse_l, N, M, rate;
  Vec2x4 t;

  Direction last() const { return {{t[0][3], t[1][3]}, rate[3]}; }
};

class Forces {
 public:
  Forces(const SegmentLaw& law, SegmentRange range, const BodyState<SE2>& s)
      : law_(law), range_(range), s_(s) {}

  Direction before() const {
    return range_.first > 0 ? direction(s_, range_.first - 1, law_.damping > 0)
                            : end_direction(s_, 0);
  }
  [[gnu::always_inline]] FourSegments at(int e, const Direction& before) const {
    FourSegments out;
    const Vec2x4 d = differences(e, range_.end, [&](int k) -> const Vec2& { return s_.H[k].x; });
    out.l = sqrt(d[0] * d[0] + d[1] * d[1]);
    out.inverse_l = 1 / out.l;
    out.t = {d[0] * out.inverse_l, d[1] * out.inverse_l};
    const Lanes k_e = of(law_.k, e), c_i = of(law_.c, e);
    out.N = axial_force(law_.potential, k_e, of(law_.L, e), out.l);
    const Vec2x4 t_before(shifted(before.t[0], out.t[0]), shifted(before.t[1], out.t[1]));
    out.M = c_i * (angle_between(t_before, out.t) - of(law_.phi0, e));
    out.rate = 0;
    if (law_.damping == 0) return out;
    const Vec2x4 v = differences(e, range_.end, [&](int k) { return node_velocity(s_, k); });
    out.rate = (out.t[0] * v[1] - out.t[1] * v[0]) * out.inverse_l;
    out.N += law_.damping * k_e * (out.t[0] * v[0] + out.t[1] * v[1]);
    out.M += law_.damping * c_i * (out.rate - shifted(before.rate, out.rate));
    return out;
  }
  /// M at the last node of the range.
  double after(const Direction& last) const {
    const int i = range_.end;
    const Direction next =
        i < law_.segments ? direction(s_, i, law_.damping > 0) : end_direction(s_, i);
    return law_.c[i] * (angle_between<double>(last.t, next.t) - law_.phi0[i] +
                        law_.damping * (next.rate - last.rate));
  }

 private:
  Lanes of(const double* x, int e) const { return gathered(x, e, range_.end); }

  const SegmentLaw& law_;
  const SegmentRange range_;
  const BodyState<SE2>& s_;
};

}  // namespace

void add_segment_forces(const SegmentLaw& law, SegmentRange range, const BodyState<SE2>& s,
                        double* r, ForceScale& scale) {
  const Forces forces(law, range, s);
  FourSegments now = forces.at(range.first, forces.before());
  if (range.first == 0) r[2] -= now.M[0];
  Vec2 f_before = Vec2::Zero();
  const auto put = [&](int k, const Vec2& f) {
    Eigen::Map<Vec2>(r + 3 * k) += s.H[k].R.transpose() * f;
  };
  for (int e = range.first; e < range.end; e += Lanes::size) {
    const bool more = e + Lanes::size < range.end;
    const FourSegments next = more ? forces.at(e + Lanes::size, now.last()) : now;
    const double M_after = more ? next.M[0] : forces.after(now.last());
    Lanes M_next(now.M[1], now.M[2], now.M[3], M_after);
    const int count = std::min(Lanes::size, range.end - e);
    M_next.v[count - 1] = M_after;
    const Lanes V = (now.M - M_next) * now.inverse_l;
    Lanes x = now.N * now.t[0] - V * now.t[1], y = now.N * now.t[1] + V * now.t[0];
    for (int lane = count; lane < Lanes::size; ++lane) x.v[lane] = y.v[lane] = M_next.v[lane] = 0;
    scale.force += sum(x * x + y * y);
    scale.moment += sum(M_next * M_next);
    const Lanes on_x = shifted(f_before[0], x) - x, on_y = shifted(f_before[1], y) - y;
    for (int lane = 0; lane < count; ++lane) put(e + lane, {on_x[lane], on_y[lane]});
    f_before = {x[count - 1], y[count - 1]};
    if (!more && range.end == law.segments) r[3 * range.end + 2] += M_after;
    now = next;
  }
  put(range.end, f_before);
}

void turn_segment_axes(const std::vector<Eigen::Matrix2d>& from_bisector, int segments, SE2* H) {
  Vec2 before = Vec2::Zero();
  for (int e = 0; e < segments; e += Lanes::size) {
    const Vec2x4 d = differences(e, segments, [&](int k) -> const Vec2& { return H[k].x; });
    const Lanes inverse_l = 1 / sqrt(d[0] * d[0] + d[1] * d[1]);
    const Vec2x4 t(d[0] * inverse_l, d[1] * inverse_l);
    const Lanes x = shifted(before[0], t[0]) + t[0], y = shifted(before[1], t[1]) + t[1];
    const Lanes inverse = 1 / sqrt(x * x + y * y), along = x * inverse, across = y * inverse;
    for (int k = std::max(e, 1); k < std::min(e + Lanes::size, segments); ++k) {
      Eigen::Matrix2d bisector;
      bisector << along[k - e], -across[k - e], across[k - e], along[k - e];
      H[k].R = bisector * from_bisector[static_cast<std::size_t>(k)];
    }
    before = {t[0][3], t[1][3]};
  }
}

}  // namespace liesl
