#pragma once
/// @file
/// Threads of the BLAS of this process.

namespace liesl {

/// More threads than one cost more than they give at the sizes of liesl; where the BLAS is
/// OpenBLAS, it is told so. liesl uses its threads over load cases and cells instead.
void one_blas_thread();

}  // namespace liesl
