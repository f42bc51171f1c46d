# One place for every package; which folder uses which is said in the folder's CMakeLists.txt.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)

find_path(SUITESPARSE_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse REQUIRED)
add_library(liesl_suitesparse INTERFACE)
target_include_directories(liesl_suitesparse SYSTEM INTERFACE ${SUITESPARSE_INCLUDE_DIR})
# What factorises meshed parts: CHOLMOD, whose supernodal module is under the GPL, or the sequential MUMPS
# that comes with Ipopt, slower (docs/licences.md).
set(LIESL_FACTORISATION cholmod CACHE STRING "Factorisation of meshed parts: cholmod or mumps")
set_property(CACHE LIESL_FACTORISATION PROPERTY STRINGS cholmod mumps)
if(LIESL_FACTORISATION STREQUAL "mumps")
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
  target_include_directories(liesl_suitesparse SYSTEM INTERFACE ${MUMPS_INCLUDE_DIR})
  set(factorisation dmumps_seq)
elseif(LIESL_FACTORISATION STREQUAL "cholmod")
  set(factorisation cholmod)
else()
  message(FATAL_ERROR "LIESL_FACTORISATION is '${LIESL_FACTORISATION}'; expected cholmod or mumps")
endif()
target_link_libraries(liesl_suitesparse INTERFACE ${factorisation} klu amd colamd btf suitesparseconfig)

# liesl_package(<name> <prefix of pkg_check_modules> <archive> <symbol> [what the archive needs...]):
# liesl_<name> is the archive in programs with the property LIESL_ARCHIVES, if a program with a symbol of it
# links, and the shared library elsewhere. Half of the start of `liesl` was spent on 31 shared libraries,
# HDF5, libcrypto, Ipopt and what they bring; archives are not for shared modules, as their code is tied to
# its place, and not worth the time to link each test with them.
include(CheckCXXSourceCompiles)
define_property(TARGET PROPERTY LIESL_ARCHIVES BRIEF_DOCS "Linked with archives of packages")
function(liesl_package name prefix archive symbol)
  add_library(liesl_${name} INTERFACE)
  target_include_directories(liesl_${name} SYSTEM INTERFACE ${${prefix}_INCLUDE_DIRS})
  find_library(LIESL_ARCHIVE_${name} ${archive} PATHS ${${prefix}_LIBRARY_DIRS} ${${prefix}_LIBDIR}
               NO_DEFAULT_PATH)
  mark_as_advanced(LIESL_ARCHIVE_${name})
  if(LIESL_ARCHIVE_${name})
    set(CMAKE_REQUIRED_LIBRARIES ${LIESL_ARCHIVE_${name}} ${ARGN})
    check_cxx_source_compiles("extern \"C\" int ${symbol}(); int main() { return ${symbol}(); }"
                              LIESL_ARCHIVE_${name}_LINKS)
  endif()
  if(LIESL_ARCHIVE_${name}_LINKS)
    add_library(liesl_${name}_archive INTERFACE)
    target_link_libraries(liesl_${name}_archive INTERFACE ${LIESL_ARCHIVE_${name}} ${ARGN})
    target_link_libraries(liesl_${name} INTERFACE
      $<IF:$<BOOL:$<TARGET_PROPERTY:LIESL_ARCHIVES>>,liesl_${name}_archive,PkgConfig::${prefix}>)
  else()
    target_link_libraries(liesl_${name} INTERFACE PkgConfig::${prefix})
  endif()
endfunction()

if(LIESL_OPTIM)
  pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
  set(IPOPT_NEEDS ${IPOPT_LINK_LIBRARIES})
  list(FILTER IPOPT_NEEDS EXCLUDE REGEX "/libipopt[^/]*$")
  liesl_package(ipopt IPOPT libipopt.a CreateIpoptProblem ${IPOPT_NEEDS})
  pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
endif()
if(LIESL_APPS)
  find_package(tomlplusplus REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)
  liesl_package(hdf5 HDF5 libhdf5.a H5Fopen sz z)
  pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
  liesl_package(crypto CRYPTO libcrypto.a EVP_Digest)
endif()

# A Python with matplotlib, for pictures and checks; the system's one before others in PATH, which
# need not have it. -DLIESL_PYTHON=... chooses another; so does the environment at run time.
find_program(LIESL_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(LIESL_PYTHON python3)

# What the Python package is built with: headers of the same Python, NumPy, pybind11.
if(LIESL_PYTHON_MODULE AND LIESL_APPS)
  set(Python_EXECUTABLE ${LIESL_PYTHON})
  find_package(Python COMPONENTS Interpreter Development.Module NumPy)
  find_package(pybind11 2.10 CONFIG)
  if(NOT Python_FOUND OR NOT pybind11_FOUND)
    message(STATUS "liesl: no Python package: needs python3-dev, python3-numpy and pybind11-dev")
    set(LIESL_PYTHON_MODULE OFF)
  endif()
endif()
if(LIESL_TESTS)
  find_package(GTest REQUIRED)
endif()
if(LIESL_BENCH)
  find_package(benchmark REQUIRED)
endif()
