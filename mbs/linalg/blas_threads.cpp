#include "mbs/linalg/blas_threads.hpp"

#include <dlfcn.h>

namespace liesl {

void one_blas_thread() {
  if (void* symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<void (*)(int)>(symbol)(1);
}

}  // namespace liesl
