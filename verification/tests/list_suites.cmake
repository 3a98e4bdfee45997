# Writes to OUTPUT the ctest entries of the GoogleTest program PROGRAM, four suites each, with the label unit and TIMEOUT
# [s]: 600 processes, one for each suite, would spend a minute and a half on their start under the sanitizers. An entry
# counts as skipped where its output ends with the list of its skipped tests: the list of failed ones, where there are
# any, comes after it.
# The address sanitizer keeps 16 MB of freed memory from being used again, where it would keep 256 MB: new pages took a
# sixth of the tests' time. Threads of SPH wait as those of the tool do.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+[.]" suites "${list}")
list(TRANSFORM suites REPLACE "\n|[.]$" "")
set(entries "")
while(suites)
  list(SUBLIST suites 0 4 together)
  list(REMOVE_ITEM suites ${together})
  list(JOIN together "+" name)
  list(JOIN together ".*:" filter)
  string(APPEND entries "add_test([=[${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}.*]=])
set_tests_properties([=[${name}]=] PROPERTIES LABELS unit TIMEOUT ${TIMEOUT}
                     ENVIRONMENT [=[ASAN_OPTIONS=quarantine_size_mb=16;GOMP_SPINCOUNT=3000]=]
                     SKIP_REGULAR_EXPRESSION [=[SKIPPED . [A-Za-z0-9_./]+[^A-Za-z0-9_./]*$]=])\n")
endwhile()
file(WRITE ${OUTPUT} "${entries}")
