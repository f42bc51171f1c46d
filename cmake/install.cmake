# find_package(liesl): targets liesl::liegroup, liesl::mbs and, with LIESL_OPTIM, liesl::esl and
# liesl::optim. Headers go to include/liesl, so that `#include "mbs/model/mechanism.hpp"` reads the
# same inside and outside. The program and what it needs to draw come along with LIESL_APPS.
#
# liesl_options is exported too: it carries -march=${LIESL_ARCH}, because the layout and alignment of
# Eigen's types follow the instruction set, and a user who compiles with another one would disagree
# with the library about both. Packages for any x86-64 machine are built with -DLIESL_ARCH=x86-64.
include(CMakePackageConfigHelpers)
set(LIESL_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/liesl)

set(targets liesl_options liesl_suitesparse liegroup mbs)
set(folders liegroup mbs)
if(LIESL_OPTIM)
  list(APPEND targets esl optim)
  list(APPEND folders esl optim)
endif()
install(TARGETS ${targets} EXPORT liesl-targets)
install(DIRECTORY ${folders} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/liesl
        FILES_MATCHING PATTERN *.hpp)
install(EXPORT liesl-targets NAMESPACE liesl:: DESTINATION ${LIESL_CONFIG_DIR})

configure_package_config_file(cmake/liesl-config.cmake.in liesl-config.cmake
                              INSTALL_DESTINATION ${LIESL_CONFIG_DIR})
write_basic_package_version_file(liesl-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/liesl-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/liesl-config-version.cmake
        DESTINATION ${LIESL_CONFIG_DIR})

if(TARGET liesl)
  install(TARGETS liesl)
  install(TARGETS liesl_program RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR})
  set(written ${CMAKE_BINARY_DIR}/written)
  install(FILES ${written}/liesl.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${written}/liesl DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(DIRECTORY apps/plot/ DESTINATION ${CMAKE_INSTALL_DATADIR}/liesl/plot
          FILES_MATCHING PATTERN *.py)
  install(DIRECTORY data/schema DESTINATION ${CMAKE_INSTALL_DATADIR}/liesl)
endif()
include(cmake/notices.cmake)
install(FILES LICENSE docs/licences.md ${PROJECT_BINARY_DIR}/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})
