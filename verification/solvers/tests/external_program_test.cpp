// What a program says in its log makes its run a failure, wherever in a line it says it.
#include "verification/solvers/external_program.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/results/run_failure.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::external_program_test {
namespace {

std::string failure(const std::string& log) try {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "log") << log;
  require_no_match({"NaN"}, directory.path() / "log");
  return "";
} catch (const SolverError& error) {
  return error.what();
}

std::string progress(const char* end) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "progress " + std::to_string(i) + end;
  return text;
}

TEST(RequireNoMatch, LooksAtTheWholeOfALongLine) {
  EXPECT_EQ(failure(progress("\r") + "\nall is well\n"), "");
  EXPECT_NE(failure(progress("\r") + "NaN detected\n").find("line 1 of its log"),
            std::string::npos);
  EXPECT_NE(failure(progress(" ") + "NaN detected\n").find("line 1 of its log"), std::string::npos);
}

// A text that lies across the border of two pieces of a line is found.
TEST(RequireNoMatch, FindsATextAnywhereInALine) {
  for (const int before : {58981, 58982, 65533, 65534, 65535, 65536, 131072})
    EXPECT_NE(failure(std::string(before, 'x') + "NaN" + std::string(9000, 'x') + "\n"), "");
}

TEST(RequireNoMatch, QuotesTheEndOfALongLineAlone) {
  EXPECT_LT(failure(progress(" ") + "NaN\n").size(), 1000u);
}

}  // namespace
}  // namespace slosh::external_program_test
