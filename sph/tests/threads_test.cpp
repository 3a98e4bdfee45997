#include "sph/threads.hpp"

#include <gtest/gtest.h>
#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "sph/tests/surging_scene.hpp"

namespace slosh::sph::threads_test {
namespace {

namespace fs = std::filesystem;

// A tree of control groups, and the membership of a process in one of them.
class ControlGroups : public testing::Test {
 protected:
  ControlGroups() { fs::remove_all(directory_); }
  ~ControlGroups() override { fs::remove_all(directory_); }

  void write(const fs::path& file, const std::string& text) const {
    const fs::path whole = directory_ / file;
    fs::create_directories(whole.parent_path());
    std::ofstream(whole) << text;
  }
  int cores() const {
    return cores_of_control_groups(directory_ / "membership", directory_ / "root");
  }

 private:
  const fs::path directory_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ControlGroups, WithoutALimitLeaveAllCores) {
  EXPECT_EQ(cores(), 0);
  write("membership", "0::/user/session\n");
  write("root/user/cpu.max", "max 100000\n");
  EXPECT_EQ(cores(), 0);
}

TEST_F(ControlGroups, LimitByTheTightestOnTheWayToTheProcess) {
  write("membership", "1:name=systemd:/elsewhere\n0::/user/session\n");
  write("root/user/cpu.max", "400000 100000\n");
  write("root/user/session/cpu.max", "600000 100000\n");
  write("root/elsewhere/cpu.max", "100000 100000\n");
  EXPECT_EQ(cores(), 4);
  write("root/user/session/cpu.max", "150000 100000\n");
  EXPECT_EQ(cores(), 2) << "one and a half cores";
  write("root/cpu.max", "50000 100000\n");
  EXPECT_EQ(cores(), 1) << "a container sees its own group as the root";
}

TEST_F(ControlGroups, AreNotMisledByWhatIsNoNumber) {
  write("membership", "0::/a\n");
  for (const char* text : {"", "many", "-100000 100000", "100000 0", "100000"}) {
    write("root/a/cpu.max", text);
    EXPECT_EQ(cores(), 0) << text;
  }
}

TEST(UsableCores, AreThoseOfTheAffinityMask) {
  cpu_set_t all, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
  EXPECT_LE(usable_cores(), CPU_COUNT(&all));
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_cores(), 1);
  EXPECT_EQ(threads_for(1'000'000), 1);
  ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
}

// Returns threads_for under a limit of `most` threads, as OMP_NUM_THREADS would set it.
int threads_with(int most, std::size_t particles) {
  const ThreadScope scope(most);
  return threads_for(particles);
}

TEST(Threads, AreNotSharedByAFewParticles) {
  for (const std::size_t particles : {0, 1, 999}) EXPECT_EQ(threads_with(64, particles), 1);
}

TEST(Threads, AreNeverMoreThanUsableCoresOrThanOpenMpWouldTake) {
  const int cores = usable_cores();
  EXPECT_EQ(threads_with(64, 1'000'000), std::min(64, cores));
  EXPECT_EQ(threads_with(1, 1'000'000), 1);
  EXPECT_EQ(threads_with(64, 1'000), std::min(2, cores));
}

TEST(Threads, AreSetWhileTheScopeLasts) {
  const int before = omp_get_max_threads();
  {
    const ThreadScope scope(before + 3);
    EXPECT_EQ(omp_get_max_threads(), before + 3);
  }
  EXPECT_EQ(omp_get_max_threads(), before);
}

// Returns the number of threads of a run, observed in its recording function.
int threads_of_a_run(Scene scene) {
  int threads = 0;
  scene.snapshot_interval = scene.sample_interval;
  scene.record_snapshot = [&](const Snapshot&) { threads = omp_get_max_threads(); };
  run("recommended", scene, {});
  return threads;
}

TEST(Threads, OfARunAreOneForASmallLiquidAndWhatTheSceneAsksFor) {
  const ThreadScope allowed(2);
  Scene scene = surging_scene(0.05, 0.01);
  EXPECT_EQ(threads_of_a_run(scene), 1);
  scene.threads = 2;
  EXPECT_EQ(threads_of_a_run(scene), 2);
  EXPECT_EQ(omp_get_max_threads(), 2) << "the caller's number is put back";
}

}  // namespace
}  // namespace slosh::sph::threads_test
