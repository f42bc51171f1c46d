# Flags that every target of liesl is built with, carried by one interface target.
add_library(liesl_options INTERFACE)
target_compile_features(liesl_options INTERFACE cxx_std_20)
target_compile_options(liesl_options INTERFACE -fno-math-errno)
if(LIESL_ARCH)
  # Part of the interface: Eigen's alignment depends on it, so that users of the library must agree
  # (see install.cmake). AVX2 and FMA, not AVX-512: blocks of 3 and 6 do not fill its registers.
  target_compile_options(liesl_options INTERFACE -march=${LIESL_ARCH})
endif()

# Compilers are called through ccache where there is one; what it must be told for precompiled headers
# is in its manual, "Precompiled headers". It takes the sources that a compiler has read (CCACHE_DEPEND)
# and runs no preprocessor before it. With the memory of tcmalloc in place of the C library's a compiler
# takes 7 to 9 % less time (docs/performance.md).
find_program(LIESL_CCACHE ccache)
find_library(LIESL_COMPILER_MALLOC NAMES libtcmalloc_minimal.so.4)
mark_as_advanced(LIESL_CCACHE LIESL_COMPILER_MALLOC)
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
  if(LIESL_COMPILER_MALLOC)
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER LD_PRELOAD=${LIESL_COMPILER_MALLOC})
  endif()
  if(LIESL_CCACHE)
    list(APPEND CMAKE_CXX_COMPILER_LAUNCHER CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_DEPEND=1
                                            ${LIESL_CCACHE})
  endif()
  if(CMAKE_CXX_COMPILER_LAUNCHER)
    list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env)
  endif()
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects garbage from 128 MB on, about a tenth of its time; a compiler takes 1.5 GB at most.
  add_compile_options(-fpch-preprocess --param=ggc-min-heapsize=1000000)
else()
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

# Warnings are for our own sources only, hence a private list and not an interface.
set(LIESL_WARNINGS -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wpedantic)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12: its own AVX headers when Eigen's small products are inlined, and sums of
  # std::string (GCC bug 105651).
  list(APPEND LIESL_WARNINGS -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow
       -Wno-stringop-overread
       -Wno-restrict)
else()
  list(APPEND LIESL_WARNINGS -Wno-overlength-strings)  # the page of a report is one
endif()
if(LIESL_WERROR)
  list(APPEND LIESL_WARNINGS -Werror)
endif()

# liesl_add_library(<name> [sources...]): the library of one folder.
function(liesl_add_library name)
  add_library(${name} ${ARGN})
  add_library(liesl::${name} ALIAS ${name})
  target_compile_options(${name} PRIVATE ${LIESL_WARNINGS})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/liesl>)
  target_link_libraries(${name} PUBLIC liesl_options)
endfunction()
