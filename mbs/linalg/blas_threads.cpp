#include "mbs/linalg/blas_threads.hpp"

#include <dlfcn.h>

namespace liesl {

namespace {

using Setter = void (*)(int);

Setter setter(const char* name) { return reinterpret_cast<Setter>(dlsym(RTLD_DEFAULT, name)); }

}  // namespace

void one_blas_thread() {
  static const Setter openblas = setter("openblas_set_num_threads");
  static const Setter openmp = setter("omp_set_max_active_levels");  // 0: no parallel regions
  if (openblas) openblas(1);
  if (openmp) openmp(0);
}

}  // namespace liesl
