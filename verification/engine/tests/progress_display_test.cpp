#include "verification/engine/progress_display.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <sstream>

#include "verification/tests/messages.hpp"

namespace slosh::progress_display_test {
namespace {

constexpr DisplayStyle plain{.live = false, .colour = false, .columns = 80};
constexpr DisplayStyle live{.live = true, .colour = false, .columns = 80};
const std::string up = "\033[1A\033[2K";

JobState state_of(const std::string& name, JobPhase phase) {
  JobState state;
  state.job.name = name;
  state.job.log_file = name + ".log";
  state.phase = phase;
  state.wall_time = 10;
  state.progress = RunProgress{.time = 5, .end_time = 20, .steps = 100};
  return state;
}

std::string shown(const std::vector<JobState>& states, const DisplayStyle& style) {
  std::ostringstream stream;
  ProgressDisplay(
      stream, [&] { return style; }, 2)
      .show(states);
  return stream.str();
}

TEST(ProgressDisplay, SaysTheEndOfARunOnceInAPlainLine) {
  std::ostringstream stream;
  ProgressDisplay display(
      stream, [] { return plain; }, 1);
  for (int i = 0; i < 3; ++i) display.show({state_of("sph", JobPhase::running)});
  for (int i = 0; i < 3; ++i) display.show({state_of("sph", JobPhase::exited)});
  EXPECT_EQ(stream.str(), "finished sph in 0:10\n");
}

TEST(ProgressDisplay, TellsWithEachPlainLineHowFarTheCampaignIs) {
  EXPECT_EQ(shown({state_of("sph", JobPhase::exited), state_of("vof", JobPhase::running)}, plain),
            "[1/2] finished sph in 0:10; 30 s left\n");
}

TEST(ProgressDisplay, WritesAPlainLineAMinuteWhereNoRunEnds) {
  std::ostringstream stream;
  ProgressDisplay display(
      stream, [] { return plain; }, 2);
  const std::vector<JobState> states{state_of("sph", JobPhase::running),
                                     state_of("vof", JobPhase::running)};
  const auto start = ProgressDisplay::Clock::now();
  for (int second = 0; second <= 130; ++second)
    display.show(states, start + std::chrono::seconds(second));
  const std::string line = "[0/2] 30 s left; running sph (0:30 left), vof (0:30 left)\n";
  EXPECT_EQ(stream.str(), line + line);
}

TEST(ProgressDisplay, NamesTheCauseAndTheLogOfAFailure) {
  JobState failed = state_of("vof", JobPhase::exited);
  failed.status = 3;
  EXPECT_EQ(shown({failed, state_of("late", JobPhase::interrupted)}, plain),
            "[2/2] failed   vof: exit status 3 (log: vof.log)\n"
            "[2/2] skipped  late: not started\n");
  JobState never = state_of("never", JobPhase::not_started);
  never.message = "see ninja.log";
  EXPECT_EQ(shown({failed, never}, plain),
            "[2/2] failed   vof: exit status 3 (log: vof.log)\n"
            "[2/2] skipped  never: not started: see ninja.log\n");
}

TEST(ProgressDisplay, DrawsALiveLineWithTimeSpeedAndRemainingTime) {
  EXPECT_EQ(shown({state_of("sph", JobPhase::running)}, live),
            "running  sph  5.00 of 20 s, 0.5 simulated s per s, 0:30 left\n");
}

TEST(ProgressDisplay, DrawsALineForTheWholeCampaignBelowThoseOfItsRuns) {
  EXPECT_EQ(shown({state_of("sph", JobPhase::running), state_of("vof", JobPhase::exited)}, live),
            "finished vof in 0:10\n"
            "running  sph  5.00 of 20 s, 0.5 simulated s per s, 0:30 left\n"
            "[1/2] 30 s left\n");
}

TEST(ProgressDisplay, ErasesItsLiveLinesBeforeItWritesAnew) {
  std::ostringstream stream;
  ProgressDisplay display(
      stream, [] { return live; }, 2);
  display.show({state_of("sph", JobPhase::running), state_of("vof", JobPhase::running)});
  stream.str("");
  display.show({state_of("sph", JobPhase::exited), state_of("vof", JobPhase::running)});
  EXPECT_TRUE(begins(stream.str(), up + up + up + "finished sph in 0:10\nrunning  vof"));
  stream.str("");
  display.erase_live_lines();
  EXPECT_EQ(stream.str(), up + up);
}

TEST(ProgressDisplay, FollowsATerminalThatIsResized) {
  std::ostringstream stream;
  DisplayStyle style = live;
  ProgressDisplay display(
      stream, [&] { return style; }, 2);
  const std::vector<JobState> states{
      state_of("a_run_with_a_name_of_some_length", JobPhase::running)};
  display.show(states);
  const std::size_t length = stream.str().size() - 1;  // without the line's end
  ASSERT_GT(length, 60u);
  stream.str("");
  style.columns = 30;
  display.show(states);
  EXPECT_TRUE(begins(stream.str(), up + up + up + "running"))
      << "the line of " << length << " columns stands in three rows of 30";
  EXPECT_EQ(stream.str().find('\n', 3 * up.size()), stream.str().size() - 1);
  EXPECT_LT(stream.str().size(), 3 * up.size() + 31);
}

TEST(ProgressDisplay, KeepsTheTimeLeftInEveryWidthThatHoldsIt) {
  const JobState state =
      state_of("li2010_small_amplitude_tank_start/recommended_10mm", JobPhase::running);
  EXPECT_EQ(running_line(state, 50, 79),
            "running  li2010_small_amplitude_tank_start/recommended_10mm  25 %, 0:30 left");
  EXPECT_EQ(running_line(state, 50, 40), "running  li2010_sm..nded_10mm  0:30 left");
  for (std::size_t columns = 9; columns < 120; ++columns) {
    const std::string line = running_line(state, 50, columns);
    EXPECT_LE(line.size(), columns);
    EXPECT_TRUE(line.ends_with("0:30 left")) << line;
  }
}

TEST(ProgressDisplay, TellsTheExpectedTimeLeftOfARunThatSaysNothing) {
  JobState state = state_of("potential", JobPhase::running);
  state.progress.reset();
  EXPECT_EQ(running_line(state, 9, 79), "running  potential  started 0:10 ago");
  state.job.expected_time = 25;
  EXPECT_EQ(running_line(state, 9, 79), "running  potential  started 0:10 ago, about 0:15 left");
}

TEST(ProgressDisplay, ColoursOnlyWhereItMay) {
  for (const bool colour : {false, true}) {
    const std::string text =
        shown({state_of("sph", JobPhase::exited)}, {.live = true, .colour = colour, .columns = 80});
    EXPECT_EQ(text.find("\033[32m") != std::string::npos, colour);
  }
}

TEST(ProgressDisplay, NeitherMovesTheCursorNorColoursOutsideATerminal) {
  if (isatty(STDERR_FILENO)) GTEST_SKIP() << "standard error is a terminal here";
  EXPECT_FALSE(style_of(STDERR_FILENO).live);
  EXPECT_FALSE(style_of(STDERR_FILENO).colour);
}

JobState job(JobPhase phase, double expected, double wall = 0) {
  JobState state;
  state.phase = phase;
  state.job.expected_time = expected;
  state.wall_time = wall;
  return state;
}

TEST(TimeLeft, LearnsFromWhatEndedJobsTookAndNothingFromAJobThatFailed) {
  std::vector<JobState> states(11, job(JobPhase::exited, 100, 200));
  states.push_back(job(JobPhase::waiting, 50));
  EXPECT_NEAR(time_left(states, 2).value(), 100, 1);
  JobState failed = job(JobPhase::exited, 100, 1);
  failed.status = 3;
  EXPECT_DOUBLE_EQ(time_left({failed, job(JobPhase::waiting, 50)}, 1).value(), 50);
}

TEST(TimeLeft, BelievesARunningJobsOwnForecastOnceItIsUnderWay) {
  JobState running = job(JobPhase::running, 10, 30);
  running.progress = RunProgress{.time = 5, .end_time = 20, .steps = 1};
  EXPECT_DOUBLE_EQ(time_left({running}, 1).value(), 90);
  running.progress->time = 0.01;
  EXPECT_DOUBLE_EQ(time_left({running}, 1).value(), 0) << "three times its time has gone by";
}

TEST(TimeLeft, SharesTheCoresAmongJobsThatWaitAsManyAsEachTakesAndAddsThoseThatRunAlone) {
  JobState timing = job(JobPhase::waiting, 40), wide = job(JobPhase::waiting, 60);
  timing.job.alone = true;
  wide.job.cores = 4;
  const std::vector<JobState> states(8, job(JobPhase::waiting, 30));
  EXPECT_DOUBLE_EQ(time_left(states, 2).value(), 120);
  EXPECT_DOUBLE_EQ(time_left(states, 100).value(), 30) << "no less than the longest";
  EXPECT_DOUBLE_EQ(time_left({states[0], timing, timing}, 4).value(), 110);
  EXPECT_DOUBLE_EQ(time_left({wide, wide}, 8).value(), 60);
  EXPECT_DOUBLE_EQ(time_left({wide, wide}, 4).value(), 120);
  EXPECT_FALSE(time_left({job(JobPhase::waiting, 0)}, 1)) << "nothing is known of it";
  EXPECT_TRUE(time_left({job(JobPhase::exited, 0)}, 1));
}

TEST(TimeLeft, IsToldInTheUnitThatItHas) {
  EXPECT_EQ(rough_time(41.7), "42 s");
  EXPECT_EQ(rough_time(185), "3 min");
  EXPECT_EQ(rough_time(9000), "2.5 h");
  EXPECT_EQ(clock_time(3750), "1:02:30");
}

}  // namespace
}  // namespace slosh::progress_display_test
