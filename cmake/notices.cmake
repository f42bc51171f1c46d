# `copyright` of an installation: the licence of liesl, and the notices of what is compiled into its program, as
# Debian's packages have them (docs/licences.md).
set(noticed libeigen3-dev libspectra-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev)
foreach(archive ipopt=coinor-libipopt-dev hdf5=libhdf5-dev crypto=libssl-dev)
  string(REPLACE "=" ";" archive ${archive})
  list(POP_FRONT archive name)
  if(LIESL_ARCHIVE_${name}_LINKS)
    list(APPEND noticed ${archive})
  endif()
endforeach()

file(READ ${PROJECT_SOURCE_DIR}/LICENSE text)
file(READ ${PROJECT_SOURCE_DIR}/apps/report/page/dist/notices.txt page)
string(APPEND text "\nThe program contains what follows. The source of Ipopt (EPL-1.0) is that of Debian's source package "
                   "coinor-ipopt and of github.com/coin-or/Ipopt.\n\n======== pages of results\n\n${page}")
foreach(package ${noticed})
  set(notice "not found where this was built\n")
  if(EXISTS /usr/share/doc/${package}/copyright)
    file(READ /usr/share/doc/${package}/copyright notice)
  endif()
  string(APPEND text "\n======== ${package}\n\n${notice}")
endforeach()
file(WRITE ${PROJECT_BINARY_DIR}/copyright "${text}")
