#pragma once
/// @file
/// Threads of the BLAS of this process.

namespace liesl {

/// More threads than one cost more than they give at the sizes of liesl, and wait for each other
/// where the machine is busy. Tells OpenBLAS, if the BLAS is that, and the OpenMP of CHOLMOD, which
/// asks for four. For the calling thread, hence before each use. liesl uses its threads over load
/// cases and cells instead.
void one_blas_thread();

}  // namespace liesl
