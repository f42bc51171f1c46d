# Precompiled headers: most of the time of a build is spent in reading Eigen and the standard
# library. Sources include what they use all the same; -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds
# without and shows what is missing.
set(LIESL_PCH_ENGINE
  <algorithm> <array> <cmath> <functional> <limits> <map> <memory> <numbers> <numeric> <optional>
  <set> <stdexcept> <string> <utility> <variant> <vector>
  <Eigen/Core> <Eigen/Cholesky> <Eigen/Geometry> <Eigen/LU> <Eigen/SparseCore> <Eigen/StdVector>
  <fmt/format.h>
  <liegroup/product.hpp> <liegroup/r3xso3.hpp> <liegroup/se2.hpp> <liegroup/se3.hpp>
  <mbs/linalg/eigen_kernels.hpp>)
set(LIESL_PCH_APPS ${LIESL_PCH_ENGINE}
  <chrono> <filesystem> <sstream> <nlohmann/json.hpp> <toml++/toml.h>)
set(LIESL_PCH_TESTS ${LIESL_PCH_ENGINE} <filesystem> <fstream> <random> <sstream> <gtest/gtest.h>)

# The headers of the engine, for mbs, esl and optim. A target of its own: who reuses the headers of a
# target waits until all of it is built.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/precompile.cpp.new "// holds precompiled headers\n")
file(COPY_FILE ${CMAKE_CURRENT_BINARY_DIR}/precompile.cpp.new
     ${CMAKE_CURRENT_BINARY_DIR}/precompile.cpp ONLY_IF_DIFFERENT)
add_library(liesl_pch OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompile.cpp)
target_compile_options(liesl_pch PRIVATE ${LIESL_WARNINGS})  # -Wpedantic defines a macro
target_link_libraries(liesl_pch PRIVATE liesl_options Eigen3::Eigen fmt::fmt)
target_include_directories(liesl_pch PRIVATE ${PROJECT_SOURCE_DIR})
target_precompile_headers(liesl_pch PRIVATE ${LIESL_PCH_ENGINE})
