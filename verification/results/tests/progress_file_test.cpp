#include "verification/results/progress_file.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/tests/temporary_directory.hpp"

namespace slosh::progress_file_test {
namespace {

TEST(ProgressFile, GivesBackWhatWasWrittenLast) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "run.progress";
  write_progress({.time = 1, .end_time = 20, .steps = 100}, file);
  write_progress({.time = 1.25, .end_time = 20, .steps = 120}, file);
  const auto progress = read_progress(file);
  ASSERT_TRUE(progress);
  EXPECT_EQ(progress->time, 1.25);
  EXPECT_EQ(progress->end_time, 20);
  EXPECT_EQ(progress->steps, 120);
}

TEST(ProgressFile, MayBeAbsentOrDamaged) {
  const TemporaryDirectory directory;
  const auto file = directory.path() / "run.progress";
  EXPECT_FALSE(read_progress(file));
  EXPECT_FALSE(read_progress(""));
  EXPECT_FALSE(read_progress(directory.path())) << "reading it fails";
  for (const char* text : {"", "{\"time_s\": 1", "{\"time_s\": 1}", "[]", "{\"time_s\": \"x\"}"}) {
    std::ofstream(file) << text;
    EXPECT_FALSE(read_progress(file)) << text;
  }
}

}  // namespace
}  // namespace slosh::progress_file_test
