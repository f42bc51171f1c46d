/// What a user of the installed library writes: a frame of liegroup, a function of mbs.

#include <cmath>
#include <cstdio>

#include "liegroup/se3.hpp"
#include "mbs/model/time_function.hpp"
#ifdef WITH_OPTIM
#include "optim/study/study.hpp"
#endif

int main() {
  liesl::SE3::Tangent h;
  h << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6;
  const double error = (liesl::SE3::log(liesl::SE3::exp(h)) - h).norm();
  const auto motion = liesl::TimeFunction::rate(150.0, 0.04);
  const bool fine = error < 1e-14 && std::abs(motion.rate(1.0) - 150.0) < 1e-12;
  std::printf("log(exp(h)) - h = %.1e, rate = %g: %s\n", error, motion.rate(1.0),
              fine ? "fine" : "WRONG");
#ifdef WITH_OPTIM
  const liesl::CycleOptions cycle;
  if (cycle.max < 1) return 1;
#endif
  return fine ? 0 : 1;
}
