# `cpack --config build/NAME/CPackConfig.cmake` makes a package of an installation in /usr; the preset
# "package" is for machines other than this one. What may be handed out is in docs/licences.md.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME liesl)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "the liesl authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # needs dpkg-dev
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-matplotlib")
set(CPACK_STRIP_FILES ON)
if(TARGET _liesl)
  math(EXPR next "${Python_VERSION_MINOR} + 1")  # the module is compiled for one version
  set(python ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3 (>= ${python}), python3 (<< ${Python_VERSION_MAJOR}.${next}), python3-numpy")
endif()
include(CPack)
