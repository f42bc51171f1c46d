#pragma once
/// @file
/// What a peak is higher than the samples that are taken of it.

namespace liesl {

/// A value at an instant, or at a place.
struct Sample {
  double at = 0, value = 0;
};

/// Of the parabola through three samples, the middle one not below the others: how far its vertex
/// is above the middle one. 0 of a line.
/// @pre a.at < b.at < c.at
constexpr double vertex_above(const Sample& a, const Sample& b, const Sample& c) {
  const double rise = (b.value - a.value) / (b.at - a.at),
               fall = (c.value - b.value) / (c.at - b.at), bend = (fall - rise) / (c.at - a.at),
               slope = rise + bend * (b.at - a.at);  // at b
  return bend < 0 ? -slope * slope / (4 * bend) : 0;
}

}  // namespace liesl
