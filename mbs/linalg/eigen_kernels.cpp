#include "mbs/linalg/eigen_kernels.hpp"

#ifdef LIESL_EIGEN_KERNELS
namespace Eigen::internal {
LIESL_EIGEN_KERNELS()
}  // namespace Eigen::internal
#endif
