#include "verification/engine/progress_display.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>

namespace slosh {
namespace {

constexpr DisplayStyle plain{.live = false, .colour = false, .columns = 80};
constexpr DisplayStyle live{.live = true, .colour = false, .columns = 80};

JobState state_of(const std::string& name, JobPhase phase) {
  JobState state;
  state.job.name = name;
  state.job.log_file = name + ".log";
  state.phase = phase;
  state.wall_time = 10;
  state.progress = RunProgress{.time = 5, .end_time = 20, .steps = 100};
  return state;
}

TEST(ProgressDisplay, SaysStartAndEndOnceEachInPlainLines) {
  std::ostringstream stream;
  ProgressDisplay display(stream, plain);
  for (int i = 0; i < 3; ++i) display.show({state_of("sph", JobPhase::running)});
  for (int i = 0; i < 3; ++i) display.show({state_of("sph", JobPhase::exited)});
  EXPECT_EQ(stream.str(), "start    sph\nfinished sph in 0:10\n");
}

TEST(ProgressDisplay, NamesTheCauseAndTheLogOfAFailure) {
  std::ostringstream stream;
  ProgressDisplay display(stream, plain);
  JobState failed = state_of("vof", JobPhase::exited);
  failed.status = 3;
  display.show({failed, state_of("late", JobPhase::interrupted)});
  EXPECT_EQ(stream.str(),
            "failed   vof: exit status 3 (log: vof.log)\nskipped  late: not started\n");
}

TEST(ProgressDisplay, DrawsALiveLineWithTimeSpeedAndRemainingTime) {
  std::ostringstream stream;
  ProgressDisplay display(stream, live);
  display.show({state_of("sph", JobPhase::running), state_of("vof", JobPhase::waiting)});
  EXPECT_EQ(stream.str(), "running  sph  5.00 of 20 s, 0.5 simulated s per s, 0:30 left\n");
}

TEST(ProgressDisplay, ErasesItsLiveLinesBeforeItWritesAnew) {
  std::ostringstream stream;
  ProgressDisplay display(stream, live);
  display.show({state_of("sph", JobPhase::running), state_of("vof", JobPhase::running)});
  stream.str("");
  display.show({state_of("sph", JobPhase::exited), state_of("vof", JobPhase::running)});
  const std::string up = "\033[1A\033[2K";
  EXPECT_EQ(stream.str().find(up + up + "finished sph in 0:10\nrunning  vof"), 0u) << stream.str();
}

TEST(ProgressDisplay, CutsLiveLinesToTheTerminal) {
  std::ostringstream stream;
  ProgressDisplay display(stream, {.live = true, .colour = false, .columns = 20});
  display.show({state_of("sph", JobPhase::running)});
  EXPECT_EQ(stream.str(), "running  sph  5.00 \n");
}

TEST(ProgressDisplay, ColoursOnlyWhereItMay) {
  for (const bool colour : {false, true}) {
    std::ostringstream stream;
    ProgressDisplay display(stream, {.live = true, .colour = colour, .columns = 80});
    display.show({state_of("sph", JobPhase::exited)});
    EXPECT_EQ(stream.str().find("\033[32m") != std::string::npos, colour);
  }
}

TEST(ProgressDisplay, NeitherMovesTheCursorNorColoursOutsideATerminal) {
  if (isatty(2)) GTEST_SKIP() << "standard error is a terminal here";
  EXPECT_FALSE(style_of_standard_error().live);
  EXPECT_FALSE(style_of_standard_error().colour);
}

}  // namespace
}  // namespace slosh
