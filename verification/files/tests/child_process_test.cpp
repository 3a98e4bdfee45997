#include "verification/files/child_process.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

namespace slosh::child_process_test {
namespace {

using namespace std::chrono_literals;

TEST(ChildProcess, WithoutALogKeepsItsOutputApartFromItsErrors) {
  ChildProcess child({"/bin/sh", "-c", "echo said; echo wrong >&2; exit 3"},
                     {.splits_errors = true});
  EXPECT_TRUE(child.ends_within(60s));
  EXPECT_EQ(child.exit_status(), 3);
  EXPECT_EQ(child.output(), "said\n");
  EXPECT_EQ(child.errors(), "wrong\n");
}

TEST(ChildProcess, IsEndedAtItsLimit) {
  ChildProcess child({"/bin/sleep", "600"}, {});
  EXPECT_FALSE(child.ends_within(0.1s));
  EXPECT_LT(child.wall_time(), 60);
}

// A thread that ends a child ends what it has left behind, and must not take a child that another
// thread has just started for that.
TEST(ChildProcess, InOneThreadIsNotTakenForOneThatAnotherHasLeftBehind) {
  std::atomic<int> failed = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&failed] {
      for (int i = 0; i < 20; ++i) {
        ChildProcess child({"/bin/sleep", "0.01"}, {});
        failed += !child.ends_within(60s) || child.wait_status() != 0;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failed, 0);
}

}  // namespace
}  // namespace slosh::child_process_test
