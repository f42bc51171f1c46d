# One place for every package; which folder uses which is said in the folder's CMakeLists.txt.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
pkg_check_modules(MUPARSER REQUIRED IMPORTED_TARGET muparser)

# Half of the start of `liesl` was spent on 36 shared libraries and 14,000 symbols of OpenBLAS. Not shared
# modules, as code of archives is tied to its place, nor tests: it takes time to link each of them so.
define_property(TARGET PROPERTY LIESL_ARCHIVES BRIEF_DOCS "Linked with archives of packages")
include(CheckCXXSourceCompiles)

# liesl_archives(<name> <symbol> FILES <files...> [PATHS <folders...>]): LIESL_ARCHIVE_<name>_LINKS, whether all
# are there and a program with the symbol links; LIESL_ARCHIVE_<name>_FILES, the archives with the shared
# libraries that they need.
function(liesl_archives name symbol)
  cmake_parse_arguments(PARSE_ARGV 2 of "" "" "FILES;PATHS")
  set(files "")
  foreach(file IN LISTS of_FILES)
    find_library(LIESL_FILE_${file} ${file} HINTS ${of_PATHS})
    mark_as_advanced(LIESL_FILE_${file})
    list(APPEND files ${LIESL_FILE_${file}})
  endforeach()
  set(LIESL_ARCHIVE_${name}_FILES ${files} PARENT_SCOPE)
  if(NOT LIESL_ARCHIVES OR files MATCHES "NOTFOUND")
    set(LIESL_ARCHIVE_${name}_LINKS OFF CACHE INTERNAL "")
  else()
    unset(LIESL_ARCHIVE_${name}_LINKS CACHE)
    set(CMAKE_REQUIRED_LIBRARIES ${files})
    check_cxx_source_compiles("extern \"C\" int ${symbol}(); int main() { return ${symbol}(); }"
                              LIESL_ARCHIVE_${name}_LINKS)
  endif()
endfunction()

# liesl_package(<name> <shared libraries...>): liesl_<name> is its archives, in programs with the property
# LIESL_ARCHIVES, if they link; elsewhere the shared libraries.
function(liesl_package name)
  add_library(liesl_${name} INTERFACE)
  if(LIESL_ARCHIVE_${name}_LINKS)
    add_library(liesl_${name}_archives INTERFACE)
    target_link_libraries(liesl_${name}_archives INTERFACE ${LIESL_ARCHIVE_${name}_FILES})
    add_library(liesl_${name}_shared INTERFACE)
    target_link_libraries(liesl_${name}_shared INTERFACE ${ARGN})
    set(chosen $<BOOL:$<TARGET_PROPERTY:LIESL_ARCHIVES>>)
    target_link_libraries(liesl_${name} INTERFACE
      $<BUILD_INTERFACE:$<IF:${chosen},liesl_${name}_archives,liesl_${name}_shared>>
      "$<INSTALL_INTERFACE:${ARGN}>")
  else()
    if(LIESL_ARCHIVES)
      message(STATUS "liesl: shared libraries of ${name}, as its archives are not all there")
    endif()
    target_link_libraries(liesl_${name} INTERFACE ${ARGN})
  endif()
endfunction()

# BLAS and LAPACK of archives, and the sequential MUMPS.
find_library(LIESL_FILE_libopenblas.a libopenblas.a)
if(LIESL_FILE_libopenblas.a)
  set(BLAS_FILES libopenblas.a libgfortran.so.5)
else()
  set(BLAS_FILES liblapack.so.3 libblas.so.3 libgfortran.so.5)
endif()
set(MUMPS_FILES libdmumps_seq.a libmumps_common_seq.a libpord_seq.a libmpiseq_seq.a libesmumps-7.0.so
                libscotch-7.0.so libscotcherr-7.0.so)

find_path(SUITESPARSE_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse REQUIRED)
# What factorises meshed parts: CHOLMOD, whose supernodal module is under the GPL, or the sequential MUMPS
# that comes with Ipopt, slower (docs/licences.md).
set(LIESL_FACTORISATION cholmod CACHE STRING "Factorisation of meshed parts: cholmod or mumps")
set_property(CACHE LIESL_FACTORISATION PROPERTY STRINGS cholmod mumps)
if(LIESL_FACTORISATION STREQUAL "mumps")
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
  set(factorisation dmumps_seq)
  set(factorise dmumps_c)
  set(FACTORISATION_FILES ${MUMPS_FILES})
elseif(LIESL_FACTORISATION STREQUAL "cholmod")
  set(factorisation cholmod)
  set(factorise cholmod_factorize)
  set(FACTORISATION_FILES libcholmod.a libccolamd.a libcamd.a libmetis.so.5 libgomp.so.1)
else()
  message(FATAL_ERROR "LIESL_FACTORISATION is '${LIESL_FACTORISATION}'; expected cholmod or mumps")
endif()
liesl_archives(suitesparse ${factorise} FILES
  ${FACTORISATION_FILES} libklu.a libamd.a libcolamd.a libbtf.a libsuitesparseconfig.a ${BLAS_FILES})
if(LIESL_OPTIM)
  pkg_check_modules(IPOPT REQUIRED IMPORTED_TARGET ipopt)
  liesl_archives(ipopt CreateIpoptProblem FILES libipopt.a ${MUMPS_FILES} ${BLAS_FILES}
                 PATHS ${IPOPT_LIBRARY_DIRS} ${IPOPT_LIBDIR})
  # Both or neither: a program has one OpenBLAS.
  if(NOT LIESL_ARCHIVE_suitesparse_LINKS OR NOT LIESL_ARCHIVE_ipopt_LINKS)
    set(LIESL_ARCHIVE_suitesparse_LINKS OFF)
    set(LIESL_ARCHIVE_ipopt_LINKS OFF)
  endif()
else()
  set(LIESL_ARCHIVE_ipopt_LINKS OFF)
endif()
liesl_package(suitesparse ${factorisation} klu amd colamd btf suitesparseconfig)
target_include_directories(liesl_suitesparse SYSTEM INTERFACE ${SUITESPARSE_INCLUDE_DIR}
                           $<$<BOOL:${MUMPS_INCLUDE_DIR}>:${MUMPS_INCLUDE_DIR}>)

if(LIESL_OPTIM)
  liesl_package(ipopt PkgConfig::IPOPT)
  target_include_directories(liesl_ipopt SYSTEM INTERFACE ${IPOPT_INCLUDE_DIRS})
  pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
endif()
if(LIESL_APPS)
  find_package(tomlplusplus REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(CLI11 REQUIRED)
  pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5)
  liesl_archives(hdf5 H5Fopen FILES libhdf5.a libsz.a libaec.a libz.a PATHS ${HDF5_LIBRARY_DIRS} ${HDF5_LIBDIR})
  liesl_package(hdf5 PkgConfig::HDF5)
  target_include_directories(liesl_hdf5 SYSTEM INTERFACE ${HDF5_INCLUDE_DIRS})
  pkg_check_modules(CRYPTO REQUIRED IMPORTED_TARGET libcrypto)
  liesl_archives(crypto EVP_Digest FILES libcrypto.a PATHS ${CRYPTO_LIBRARY_DIRS} ${CRYPTO_LIBDIR})
  liesl_package(crypto PkgConfig::CRYPTO)
  target_include_directories(liesl_crypto SYSTEM INTERFACE ${CRYPTO_INCLUDE_DIRS})
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
