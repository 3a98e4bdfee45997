# Writes to OUTPUT the ctest entries of the GoogleTest program PROGRAM, four suites each, with the label unit and TIMEOUT
# [s]: 600 processes, one for each suite, would spend a minute and a half on their start under the sanitizers. An entry
# counts as skipped where its output ends with the list of its skipped tests: the list of failed ones, where there are
# any, comes after it. Entries of many tests start first: one that takes a minute would otherwise end alone.
# The address sanitizer keeps 1 MB of freed memory from being used again, where it would keep 256 MB: what the processor's
# cache does not hold took a third of the time of tests that fit (28 November 2026). Threads of SPH wait as those of the
# tool do.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE list COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " +#[^\n]*" "" list "\n${list}")
string(REGEX MATCHALL "\n[^ \n]+[.](\n  [^\n]+)+" suites "${list}")
set(entries "")
while(suites)
  list(SUBLIST suites 0 4 together)
  list(REMOVE_ITEM suites ${together})
  string(REGEX MATCHALL "\n  " tests "${together}")
  list(LENGTH tests count)
  list(TRANSFORM together REPLACE "^\n|[.]\n.*" "")
  list(JOIN together "+" name)
  list(JOIN together ".*:" filter)
  string(APPEND entries "add_test([=[${name}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${filter}.*]=])
set_tests_properties([=[${name}]=] PROPERTIES LABELS unit TIMEOUT ${TIMEOUT} COST ${count}
                     ENVIRONMENT [=[ASAN_OPTIONS=quarantine_size_mb=1;GOMP_SPINCOUNT=3000]=]
                     SKIP_REGULAR_EXPRESSION [=[SKIPPED . [A-Za-z0-9_./]+[^A-Za-z0-9_./]*$]=])\n")
endwhile()
file(WRITE ${OUTPUT} "${entries}")
