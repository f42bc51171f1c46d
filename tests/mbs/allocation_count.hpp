#pragma once
/// @file
/// Counts the calls of operator new in the test program, to prove that inner loops make none.

namespace liesl::test {

/// Calls of operator new so far, of all threads. (Eigen's dynamic matrices use malloc and are not
/// seen; EIGEN_RUNTIME_NO_MALLOC is the tool for them.)
long allocation_count();

}  // namespace liesl::test
