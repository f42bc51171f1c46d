# One place for every package; which folder uses which is said in the folder's CMakeLists.txt.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)

find_path(SUITESPARSE_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse REQUIRED)
add_library(liesl_suitesparse INTERFACE)
target_include_directories(liesl_suitesparse SYSTEM INTERFACE ${SUITESPARSE_INCLUDE_DIR})
target_link_libraries(liesl_suitesparse INTERFACE cholmod klu amd colamd btf suitesparseconfig)

if(LIESL_OPTIM)
  pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
  pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
endif()
if(LIESL_APPS)
  find_package(tomlplusplus REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)
  pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
endif()

# A Python with matplotlib, for pictures and checks; the system's one before others in PATH, which
# need not have it. -DLIESL_PYTHON=... chooses another; so does the environment at run time.
find_program(LIESL_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(LIESL_PYTHON python3)
if(LIESL_TESTS)
  find_package(GTest REQUIRED)
endif()
if(LIESL_BENCH)
  find_package(benchmark REQUIRED)
endif()
