#include "verification/files/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "verification/tests/temporary_directory.hpp"

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

double time_of_children() {
  rusage usage;
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * usage.ru_utime.tv_usec;
}

// Starts a program as a shell does, and waits for it in the foreground or the background, in a
// session of its own, as its orphan by a file that it leaves, or not at all.
TEST(ChildProcess, CountsTheTimeOfAllThatItStarts) {
  const TemporaryDirectory directory;
  const auto time_of = [&](const std::string& script) {
    const double before = time_of_children();
    std::filesystem::remove(directory.path() / "done");
    {
      ChildProcess child({"/bin/sh", "-c", script}, {.directory = directory.path()});
      EXPECT_TRUE(child.ends_within(60s));
    }
    return time_of_children() - before;
  };
  std::ofstream(directory.path() / "works")
      << "i=0; while [ $i -lt 150000 ]; do i=$((i+1)); done; echo > done";
  // The smallest of three: another process on the core may make one dearer.
  const double whole =
      std::min({time_of("sh ./works"), time_of("sh ./works"), time_of("sh ./works")});
  for (const char* script :
       {"sh ./works & wait", "setsid --wait sh ./works", "sh -c 'sh ./works & wait' & wait",
        "(setsid sh ./works &); while ! test -s done; do sleep 0.02; done",
        "(sh ./works &); while ! test -s done; do sleep 0.02; done",
        "setsid sh -c '. ./works; sleep 60' & while ! test -s done; do sleep 0.02; done"})
    EXPECT_GT(time_of(script), 0.7 * whole) << script;
}

// Which cores a process is bound to, beside others that are bound.

TEST(BoundCores, AreThoseOfTheFewestOtherProcesses) {
  const Cores all{0, 1, 2, 3};
  EXPECT_EQ(least_bound(all, {{0}, {1}, {0, 1}}, 2), (Cores{2, 3}));
  EXPECT_EQ(least_bound(all, {{0}, {2}, {3}}, 1), Cores{1});
  EXPECT_EQ(least_bound(all, {{0}, {0}, {1}, {2}, {3}}, 3), (Cores{1, 2, 3}));
}

TEST(BoundCores, DoNotCountProcessesThatMayUseAllOrNoneOfThem) {
  EXPECT_EQ(least_bound({2, 3}, {{0, 1, 2, 3}, {0}, {}, {2}}, 1), Cores{3});
  EXPECT_EQ(least_bound({2, 3}, {}, 1), Cores{2});
  EXPECT_EQ(least_bound({2, 3}, {}, 5), (Cores{2, 3})) << "there are no more";
}

TEST(BoundCores, AreOfAChildAndOfWhatItStarts) {
  const TemporaryDirectory directory;
  const std::filesystem::path log = directory.path() / "log";
  ChildProcess child({"/bin/sh", "-c", "nproc; sh -c nproc"}, {.log_file = log, .cores = 1});
  while (!child.is_over()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  std::ifstream stream(log);
  std::string first, second;
  stream >> first >> second;
  EXPECT_EQ(first, "1");
  EXPECT_EQ(second, "1");
  EXPECT_GE(allowed_cores().size(), 1u) << "this process is not bound";
}

}  // namespace
}  // namespace slosh::child_process_test
