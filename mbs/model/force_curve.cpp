#include "mbs/model/force_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace liesl {

ForceCurve::ForceCurve(std::vector<double> x, std::vector<double> f,
                       TimeFunction::Interpolation how)
    : x_(std::move(x)), f_(std::move(f)), how_(how), inside_(TimeFunction::table(x_, f_, how)) {
  if (how == TimeFunction::Interpolation::Quintic)
    throw std::invalid_argument(
        "a characteristic of a spring is linear or cubic; a quintic spline has no slope at its "
        "ends");
  first_slope_ = inside_.rate(x_.front());
  last_slope_ = inside_.rate(std::nextafter(x_.back(), x_.front()));
}

double ForceCurve::operator()(double x) const {
  if (x < x_.front()) return f_.front() + first_slope_ * (x - x_.front());
  if (x > x_.back()) return f_.back() + last_slope_ * (x - x_.back());
  return inside_(x);
}

double ForceCurve::slope(double x) const {
  return x < x_.front() ? first_slope_ : x >= x_.back() ? last_slope_ : inside_.rate(x);
}

/// By Gauss's two points, which integrate the cubic pieces exactly. @pre no point lies between
double ForceCurve::integral(double a, double b) const {
  const double middle = 0.5 * (a + b), off = 0.5 * (b - a) / std::sqrt(3.);
  return 0.5 * (b - a) * ((*this)(middle - off) + (*this)(middle + off));
}

double ForceCurve::energy(double x) const {
  const double from = std::min(0., x), to = std::max(0., x);
  double sum = 0, at = from;
  for (const double point : x_)
    if (point > from && point < to) {
      sum += integral(at, point);
      at = point;
    }
  sum += integral(at, to);
  return x < 0 ? -sum : sum;
}

}  // namespace liesl
