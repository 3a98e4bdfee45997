#!/bin/sh
# The launcher on a small project of its own, in a directory with spaces, with the package tools, id and sudo
# replaced by stand-ins that record how they were called.
# Usage: launcher_test.sh PATH_OF_SLOSH
set -eu

slosh=$(readlink -f -- "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
project="$work/a tänk of water"
calls=$work/calls
lacking=$work/lacking # the packages that are not there
uid=$work/uid
export work calls lacking uid

fail() {
  echo "FAILED: $*"
  [ ! -s "$work/err" ] || sed 's/^/  stderr: /' "$work/err"
  [ ! -s "$work/out" ] || sed 's/^/  stdout: /' "$work/out"
  exit 1
}

# run STATUS ARGUMENTS...: starts the launcher and expects its exit status.
run() {
  expected=$1
  shift
  status=0
  : >"$calls"
  env -u HOME CI=true "$project/slosh" "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
  [ "$status" = "$expected" ] || fail "'slosh $*' ended with $status, expected $expected"
}
expect_in() { grep -qF -- "$2" "$1" || fail "'$2' is not in $(basename "$1")"; }
expect_not_in() { ! grep -qF -- "$2" "$1" || fail "'$2' is in $(basename "$1")"; }

stand_in() {  # NAME, script from stdin
  cat >"$work/bin/$1"
  chmod +x "$work/bin/$1"
}

mkdir -p "$work/bin" "$project/verification"
cp "$slosh" "$(dirname "$slosh")/CMakePresets.json" "$project/"
stand_in dpkg-query <<'END'
#!/bin/sh
case $3 in *Depends*) echo "clang-19 (>= 19~)"; exit ;; esac
echo "dpkg-query" >>"$calls"
shift 3
printf '%s\n' "$@" | awk -v file="$lacking" '
  BEGIN { while ((getline name < file) > 0) lacks[name] }
  { if ($0 in lacks) print "dpkg-query: no package " $0 > "/dev/stderr"; else print "installed " $0 " 1.0" }'
END
# Installs what it is asked for, but for openfoam, which this machine's archive does not have.
stand_in apt-get <<'END'
#!/bin/sh
echo "apt-get ${DEBIAN_FRONTEND-} $*" >>"$calls"
case " $* " in *" --print-uris "*) echo "'http://a/g++.deb' g++.deb 41234567 SHA256:0"; exit ;; esac
case " $* " in *" openfoam "*) exit 100 ;; esac
case " $* " in *" install "*)
  for name; do grep -vxF -- "$name" "$lacking" >"$lacking.rest"; mv "$lacking.rest" "$lacking"; done ;;
esac
END
stand_in id <<'END'
#!/bin/sh
cat "$uid"
END
# Asks for a password where nobody is logged in yet, and is given it by -v.
stand_in sudo <<'END'
#!/bin/sh
echo "sudo $*" >>"$calls"
if [ "$1" = -v ]; then touch "$work/password"; exit; fi
[ -e "$work/password" ] || exit 1
shift
exec "$@"
END
# As the compiler of the fuzz targets, with its runtime where `fuzzer` holds 0.
stand_in clang++ <<'END'
#!/bin/sh
case " $* " in *" -fsanitize=fuzzer,"*) exit "$(cat "$work/fuzzer")" ;; esac
exec g++ "$@"
END
echo 0 >"$work/fuzzer"
PATH=$work/bin:$PATH
export PATH

# The tool of the small project: prints where it runs and its arguments, exits with 3.
cat >"$project/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(Small LANGUAGES CXX)
add_subdirectory(verification)
END
cat >"$project/verification/CMakeLists.txt" <<'END'
add_executable(slosh_tool tool.cpp)
set_target_properties(slosh_tool PROPERTIES OUTPUT_NAME slosh)
END
cat >"$project/verification/tool.cpp" <<'END'
#include <cstdio>
int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) std::printf("<%s>\n", arguments[i]);
  return 3;
}
END

echo 1000 >"$uid"
: >"$lacking"
run 0 doctor
expect_in "$work/out" "all required packages are installed"
expect_not_in "$work/out" MISSING
# The runtime of the clang that this system has.
expect_in "$work/out" "ok       libclang-rt-19-dev"

printf '%s\n' g++ libfftw3-dev openfoam >"$lacking"
run 2 doctor
expect_in "$work/out" "MISSING  g++"
expect_in "$work/out" "(solver) without it: the interFoam runs"
expect_in "$work/out" "to install: sudo apt-get update && sudo apt-get install -y --no-install-recommends g++ libfftw3-dev openfoam"
expect_not_in "$calls" apt-get
[ ! -e "$project/build" ] || fail "the doctor wrote into build/"

# Neither root nor sudo: the exact command, and nothing is done.
run 2 campaign
expect_in "$work/err" "this user cannot install them"
expect_in "$work/err" "sudo apt-get update && sudo apt-get install -y --no-install-recommends g++ libfftw3-dev"
expect_not_in "$work/err" openfoam
expect_not_in "$calls" apt-get
expect_not_in "$calls" "sudo -v"
[ ! -e "$project/build/release" ] || fail "built without its packages"

# With sudo at a terminal: asked once, with the size, and nothing is done without a yes.
at_terminal() {  # ANSWER
  : >"$calls"
  echo "$1" | script -qec "'$project/slosh' campaign" /dev/null >"$work/out" 2>&1 || true
}
if command -v script >/dev/null; then
  at_terminal n
  expect_in "$work/out" "not installed: g++ libfftw3-dev openfoam (41 MB to download)"
  expect_in "$work/out" "install them with sudo? [Y/n]"
  expect_not_in "$calls" " install -y --no-install-recommends g++"
  cp "$lacking" "$work/before"
  at_terminal y
  expect_in "$calls" "sudo -v"
  expect_in "$calls" "apt-get noninteractive -q -o DPkg::Lock::Timeout=300 install -y --no-install-recommends g++ libfftw3-dev"
  expect_in "$work/out" "building in $project/build/release"
  [ "$(grep -c '\[Y/n\]' "$work/out")" = 1 ] || fail "asked more than once"
  cp "$work/before" "$lacking"
  rm -rf "$work/password" "$project/build"
else
  echo "SKIPPED: script is not installed: nothing is asked at a terminal"
fi

# Root: one update, the required packages together, and a solver that cannot be had is reported but stops nothing.
echo 0 >"$uid"
run 3 campaign "small amplitude" --quick
[ "$(grep -c ' update' "$calls")" = 1 ] || fail "not one apt-get update"
expect_in "$calls" "apt-get noninteractive -q -o DPkg::Lock::Timeout=300 install -y --no-install-recommends g++ libfftw3-dev"
expect_in "$work/err" "installing g++ libfftw3-dev (41 MB to download; log: "
expect_in "$work/err" "could not install openfoam, without it: the interFoam runs"
printf '<campaign>\n<small amplitude>\n<--quick>\n' | cmp - "$work/out" || fail "the arguments changed"

# A second start installs and builds nothing; it may ask dpkg-query this often.
start_again() {  # TIMES
  run 3 campaign
  expect_not_in "$calls" apt-get
  expect_not_in "$work/err" building
  asked=$(grep -c '^dpkg-query$' "$calls" || true)
  [ "$asked" -le "$1" ] || fail "a second start asked dpkg-query $asked times, expected at most $1"
}

# Each start tells of the solver that cannot be had, without delay, and tries it again a day later.
start_again 3
expect_in "$work/err" "not installed: openfoam, without it: the interFoam runs"
touch -d '2 days ago' "$project/build/launcher/solver.tried"
run 3 campaign
expect_in "$calls" "install -y --no-install-recommends openfoam"
expect_in "$work/err" "could not install openfoam"
run 3 campaign
expect_not_in "$calls" apt-get
touch -d '2 days ago' "$project/build/launcher/solver.tried"
echo 1000 >"$uid"
run 3 campaign
expect_in "$work/err" "to install: sudo apt-get update && sudo apt-get install -y --no-install-recommends openfoam"
expect_not_in "$calls" apt-get
echo 0 >"$uid"

# Once it is there no package tool is asked, nothing is said, and there is no delay.
: >"$lacking"
run 3 campaign
start_again 0
[ ! -s "$calls" ] || fail "a second start asked for packages: $(cat "$calls")"
[ ! -s "$work/err" ] || fail "a second start was not silent"

# A tool that is built tells what its store holds; the doctor itself ends as it did without.
run 0 doctor
expect_in "$work/out" "<store>"
expect_in "$work/out" "<--total>"
expect_in "$work/out" "all required packages are installed"

# A change is built; one that does not compile shows the compiler's message and starts nothing.
sed -i 's/return 3/return 4/' "$project/verification/tool.cpp"
run 4 campaign
echo 'int broken = "text";' >>"$project/verification/tool.cpp"
run 70 campaign
expect_in "$work/err" "invalid conversion"
[ ! -s "$work/out" ] || fail "the tool ran after a failed build"
sed -i '$d' "$project/verification/tool.cpp"
run 4 campaign
expect_in "$calls" dpkg-query # a package may have been what the build lacked

# A configuration that ended halfway, with a cache and without a build, is made again.
rm "$project/build/release/build.ninja"
run 4 campaign

# Two starts at once build one after the other.
touch "$project/verification/tool.cpp"
"$project/slosh" one >"$work/one" 2>&1 </dev/null &
first=$!
run 4 two
status=0
wait "$first" || status=$?
[ "$status" = 4 ] || fail "the first of two starts at once ended with $status"

# The tests: the runner's own closing line ends the output, and one failing part fails the whole.
mkdir "$project/sph" "$project/reference" "$project/openfoam_cases" "$project/reports"
stand_in clang-format <<'END'
#!/bin/sh
if [ "$1" = --version ]; then echo "Debian clang-format version $(cat "$work/format_version").0.6"; exit; fi
exit "$(cat "$work/format")"
END
echo 0 >"$work/format"
echo 14 >"$work/format_version"
sed -i 's/return 4/return count - 1/' "$project/verification/tool.cpp"
cat >>"$project/CMakeLists.txt" <<'END'
enable_testing()
add_custom_target(unit_tests DEPENDS slosh_tool)
add_custom_target(fuzz_targets DEPENDS slosh_tool)
if(SLOSH_FUZZ)
  add_test(NAME fuzz_small COMMAND sh -c "echo seconds: $SLOSH_FUZZ_SECONDS")
  set_tests_properties(fuzz_small PROPERTIES LABELS "validation;fuzz")
endif()
add_test(NAME quick COMMAND slosh_tool)
add_test(NAME long COMMAND slosh_tool one_argument)
set_tests_properties(quick PROPERTIES LABELS unit)
set_tests_properties(long PROPERTIES LABELS validation_long)
option(SLOSH_UNIT_TESTS "" ON)
file(WRITE "${CMAKE_BINARY_DIR}/unit_tests" "${SLOSH_UNIT_TESTS}")
END
run 0 test
expect_in "$project/build/release/unit_tests" OFF # they run under the sanitizers alone
[ "$(tail -n 1 "$work/out")" = "100% tests passed, 0 tests failed out of 1" ] || fail "another closing line"
expect_in "$work/out" "under the sanitizers: 100% tests passed, 0 tests failed out of 1"
! grep -q fuzz "$work/out" || fail "fuzzed without --all"
run 1 test --all
expect_in "$work/out" "fuzz targets: 100% tests passed, 0 tests failed out of 1"
[ "$(tail -n 1 "$work/out")" = "50% tests passed, 1 tests failed out of 2" ] || fail "another closing line"
expect_in "$work/out" "  failed: long (Failed)"
expect_in "$project/build/release/unit_tests" ON
run 1 test -R no_such_test
echo 1 >"$work/format"
run 1 test
expect_in "$work/out" "formatting: failed"
# Another version has other rules, and its verdict would be of those.
echo 19 >"$work/format_version"
run 0 test
expect_in "$work/out" "formatting: skipped (the files are formatted by clang-format 14, here is 19)"
echo 14 >"$work/format_version"

# A pattern: the one program that has tests of the name, in the one tree that has the program.
cat >"$project/tanks_test.cpp" <<'END'
TEST(Tank, IsFull) {}
TEST_P(Gauge,
       ReadsTheLevel) {}
END
cat >>"$project/CMakeLists.txt" <<'END'
add_executable(tanks_test EXCLUDE_FROM_ALL verification/tool.cpp)
set(sources "")
if(SLOSH_SANITIZE)
  set(sources "tanks_test\t${CMAKE_BINARY_DIR}\t${CMAKE_SOURCE_DIR}/tanks_test.cpp\n")
endif()
file(WRITE "${CMAKE_BINARY_DIR}/test_sources" "${sources}")
END
run 1 test ReadsThe # the tool's status, one argument
printf '<--gtest_filter=*Gauge.ReadsTheLevel:*Gauge.ReadsTheLevel/*>\n' | cmp - "$work/out" || fail "another filter"
run 1 test tanks_
expect_in "$work/out" "*Tank.IsFull:*Tank.IsFull/*:*Gauge.ReadsTheLevel"
run 2 test NoSuchName
expect_in "$work/err" "has a name that holds 'NoSuchName'"
[ ! -e "$project/build/release/tanks_test" ] || fail "built a test in two trees"

# The fuzz targets: all or one, for the time that is asked for; without their compiler's runtime they are left out.
echo 0 >"$work/format"
run 0 fuzz
expect_in "$work/out" "seconds: 60"
run 0 fuzz small 5
expect_in "$work/out" "seconds: 5"
run 1 fuzz no_such_target
echo 1 >"$work/fuzzer"
run 2 fuzz
expect_in "$work/err" "the fuzz targets need clang"
run 1 test --all
expect_in "$work/out" "fuzz targets: skipped"

# Without clang-format its check is left out, and does not fail the others.
mkdir "$work/programs"
for directory in /usr/local/bin /usr/bin /bin; do
  ln -s "$directory"/* "$work/programs" 2>/dev/null || true # the first of a name stays
done
rm -f "$work/bin/clang-format" "$work/programs/clang-format"
PATH=$work/bin:$work/programs run 0 test
expect_in "$work/out" "formatting: skipped (clang-format is not installed)"

# The table of terms: asks for valgrind and builds the counted program alone, whose path the script gets.
mkdir "$project/sph/counts"
cat >>"$project/CMakeLists.txt" <<'END'
add_subdirectory(sph/counts)
END
cat >"$project/sph/counts/CMakeLists.txt" <<'END'
add_executable(slosh_counted_run EXCLUDE_FROM_ALL ../../verification/tool.cpp)
END
cat >"$project/sph/counts/terms_table.sh" <<'END'
#!/bin/sh
test -x "$1" && shift && printf '<%s>\n' "$@"
END
chmod +x "$project/sph/counts/terms_table.sh"
echo 0 >"$uid"
printf '%s\n' valgrind libbenchmark-dev >"$lacking"
rm -f "$project"/build/launcher/*.seen
PATH=$work/bin:$work/programs run 0 bench terms recommended "a baffle"
printf '<recommended>\n<a baffle>\n' | cmp - "$work/out" || fail "the arguments of the table changed"
expect_in "$calls" "install -y --no-install-recommends valgrind"
expect_not_in "$calls" libbenchmark-dev
rm -f "$work/programs/valgrind"
PATH=$work/bin:$work/programs run 2 bench terms
expect_in "$work/err" "the table of terms needs valgrind"

# A campaign does not ask for PySPH.
echo python3-pysph >"$lacking"
rm -f "$project"/build/launcher/*.seen
run 2 campaign small
expect_not_in "$calls" python3-pysph

# A tree that was moved, with its build directory, is built afresh.
mv "$project" "$work/moved tank"
project="$work/moved tank"
run 1 campaign

echo "passed"
