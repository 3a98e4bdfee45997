// Which cores a process is bound to, beside others that are bound.
#include "verification/files/bound_cores.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <thread>

#include "verification/files/child_process.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::bound_cores_test {
namespace {

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
}  // namespace slosh::bound_cores_test
