# Writes to OUTPUT one ctest entry per suite of the GoogleTest program PROGRAM, with the label unit and
# TIMEOUT [s]: a process for each of 2000 tests would take longer than most of the tests do. A suite counts as skipped where its output ends
# with the list of its skipped tests: the list of failed ones, where there are any, comes after it.
# The address sanitizer keeps 16 MB of freed memory from being used again, where it would keep 256 MB: new pages took a
# sixth of the tests' time. Threads of SPH wait as those of the tool do.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+[.]" suites "${list}")
set(entries "")
foreach(suite ${suites})
  string(REGEX REPLACE "\n|[.]$" "" suite ${suite})
  string(APPEND entries "add_test([=[${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}.*]=])
set_tests_properties([=[${suite}]=] PROPERTIES LABELS unit TIMEOUT ${TIMEOUT}
                     ENVIRONMENT [=[ASAN_OPTIONS=quarantine_size_mb=16;GOMP_SPINCOUNT=3000]=]
                     SKIP_REGULAR_EXPRESSION [=[SKIPPED . [A-Za-z0-9_./]+[^A-Za-z0-9_./]*$]=])\n")
endforeach()
file(WRITE ${OUTPUT} "${entries}")
