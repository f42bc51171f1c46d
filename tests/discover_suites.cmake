# One ctest for each suite of a GoogleTest program, so that what a suite computes once (a static,
# SetUpTestSuite) is computed once. Runs after the program is linked:
#   cmake -D PROGRAM=... -D FOLDER=... -D FULL=... -D LONG=... -D SHAPE=... -D OUTPUT=F -P discover_suites.cmake
# The suites are those that the program lists, hence none is lost. FULL, LONG and SHAPE are
# regular expressions of names, see CMakeLists.txt.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "${PROGRAM} --gtest_list_tests: ${failed}")
endif()
string(REGEX MATCHALL "[^\n]+" lines "${listed}")
set(suites)
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.( .*)?$")
    set(listed_name "${CMAKE_MATCH_1}")
    string(REGEX REPLACE "/[0-9]+$" "" suite "${listed_name}")  # Suite/0, Suite/1: types of one suite
    list(APPEND suites "${suite}")
    list(APPEND "filter of ${suite}" "${listed_name}.*")
  endif()
endforeach()
list(REMOVE_DUPLICATES suites)
set(text "")
foreach(suite IN LISTS suites)
  set(labels ${FOLDER})
  set(timeout 900)
  set(cost 1)
  if(suite MATCHES "^(${FULL})$")
    list(APPEND labels full)
    set(timeout 3600)
    set(cost 100)
  elseif(suite MATCHES "^(${LONG})$")
    list(APPEND labels long)
    set(timeout 1800)
    set(cost 10)
  endif()
  if(suite MATCHES "^(${SHAPE})$")
    list(APPEND labels shape)
  endif()
  list(JOIN "filter of ${suite}" ":" filter)
  string(APPEND text "add_test([=[${FOLDER}.${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}]=]"
         " --gtest_brief=1)\nset_tests_properties([=[${FOLDER}.${suite}]=] PROPERTIES"
         " LABELS [=[${labels}]=] TIMEOUT ${timeout} COST ${cost})\n")
endforeach()
file(WRITE ${OUTPUT} "${text}")
