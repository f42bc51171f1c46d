# Unity builds: the sources of a folder are compiled a few at once, so that headers and the templates of
# Eigen are paid for once in a group. What stands in the unnamed namespace of one source is seen by the
# next of its folder: one name there, one meaning; tests have a namespace each, liesl::test::<source>,
# around theirs. -DLIESL_UNITY=OFF compiles each source alone, which is
# faster where one source changes at a time.
option(LIESL_UNITY "Compile the sources of a folder together" ON)

# liesl_unity(<target> <sources at once> [sources that stand alone...])
function(liesl_unity target size)
  if(NOT LIESL_UNITY)
    return()
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # an unnamed namespace of an included source is its own
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    if(source IN_LIST ARGN)
      continue()
    endif()
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
    cmake_path(GET relative PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    math(EXPR group "0${count_${folder}} / ${size}")
    math(EXPR count_${folder} "0${count_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${folder}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
