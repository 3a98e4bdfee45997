#include "verification/engine/job_list.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "verification/engine/launcher.hpp"
#include "verification/engine/slurm_engine.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh::job_list_test {
namespace {

constexpr double mebibyte = 1024 * 1024;

TEST(JobList, IsReadAsItWasWritten) {
  const TemporaryDirectory directory;
  const Job job{.name = "a tänk/`run`",
                .command = {"/bin/echo", "a \"b\"", "$HOME"},
                .log_file = "/tmp/a tänk.log",
                .progress_file = "/tmp/progress",
                .time_limit = 12.5,
                .cores = 2,
                .expected_time = 0.25,
                .expected_memory = 1e9,
                .alone = true};
  JobList::create(directory.path(), {job});
  const Job read = JobList::open(directory.path()).jobs().at(0);
  EXPECT_EQ(read.name, job.name);
  EXPECT_EQ(read.command, job.command);
  EXPECT_EQ(read.log_file, job.log_file);
  EXPECT_EQ(read.progress_file, job.progress_file);
  EXPECT_EQ(read.time_limit, job.time_limit);
  EXPECT_EQ(read.cores, job.cores);
  EXPECT_EQ(read.expected_time, job.expected_time);
  EXPECT_EQ(read.expected_memory, job.expected_memory);
  EXPECT_TRUE(read.alone);
}

TEST(JobList, TellsHowFarAJobIs) {
  const TemporaryDirectory directory;
  const Job job{.name = "a", .command = {"/bin/true"}, .log_file = "log"};
  const JobList list = JobList::create(directory.path(), {job});
  std::vector<JobState> states = list.initial_states();
  EXPECT_FALSE(list.update(states));
  EXPECT_EQ(states[0].phase, JobPhase::waiting);
  list.mark_started(0);
  EXPECT_TRUE(list.update(states));
  EXPECT_EQ(states[0].phase, JobPhase::running);
  list.mark_ended(0, {.job = job, .phase = JobPhase::exited, .status = 3});
  EXPECT_TRUE(list.update(states));
  EXPECT_EQ(states[0].status, 3);
  EXPECT_FALSE(list.update(states)) << "an end is told once";
}

// A program may write there.
TEST(JobList, TakesNoEndThatIsNone) {
  const TemporaryDirectory temporary;
  const JobList list =
      JobList::create(temporary.path(), {{.name = "a", .command = {"true"}, .log_file = "log"}});
  for (const char* text : {"{}", "[]", "{\"phase\": \"x\"}", "{"}) {
    std::ofstream(temporary.path() / "0.ended.json") << text;
    std::vector<JobState> states = list.initial_states();
    EXPECT_NO_THROW(list.update(states)) << text;
    EXPECT_FALSE(has_ended(states[0])) << text;
  }
}

TEST(JobList, KeepsPathsThatAreNoUtf8) {
  const TemporaryDirectory directory;
  JobList::create(directory.path(), {{.name = "a", .command = {"l\xe4tin"}, .log_file = "log"}});
  EXPECT_EQ(JobList::open(directory.path()).jobs().at(0).command.at(0), "l\xe4tin");
}

TEST(JobList, RefusesAListThatIsNone) {
  const TemporaryDirectory directory;
  EXPECT_THROW(JobList::open(directory.path()), std::runtime_error);
  std::ofstream(directory.path() / "jobs.cbor") << "[{\"name\": 1}]";
  EXPECT_THROW(JobList::open(directory.path()), std::runtime_error);
}

std::vector<Job> jobs_of_all_kinds() {
  const Job plain{.name = "$(touch x)", .command = {"`id`"}, .log_file = "log"};
  Job wide = plain, alone = plain;
  wide.cores = 2;
  alone.alone = true;
  return {plain, wide, alone};
}

TEST(NinjaFile, NamesJobsByNumberAlone) {
  const std::string text = ninja_file(jobs_of_all_kinds(), 4);
  EXPECT_EQ(text.find("touch"), std::string::npos);
  EXPECT_EQ(text.find("`id`"), std::string::npos);
  EXPECT_NE(text.find("command = exec \"$$SLOSH_TOOL\" job $index\n"), std::string::npos);
}

TEST(NinjaFile, RunsWhatWantsToBeAloneAfterAllOthersAndWideJobsAsTheyFit) {
  const std::string text = ninja_file(jobs_of_all_kinds(), 4);
  EXPECT_NE(text.find("build others: phony 0.ended.json 1.ended.json\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("build 2.ended.json: job || others\n  index = 2\n  pool = alone\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("pool cores_2\n  depth = 2\n"), std::string::npos) << text;
  EXPECT_NE(text.find("build 1.ended.json: job\n  index = 1\n  pool = cores_2\n"),
            std::string::npos)
      << text;
}

Job needing(double seconds, double memory, int cores = 1, bool alone = false) {
  return {.name = "a",
          .command = {"/bin/true"},
          .log_file = "log",
          .time_limit = seconds,
          .cores = cores,
          .expected_memory = memory,
          .alone = alone};
}

TEST(SlurmArrays, GatherJobsOfEqualNeedsAndPutThoseAloneLast) {
  const auto arrays = slurm_arrays({needing(600, 100 * mebibyte, 1, true),
                                    needing(600, 100 * mebibyte), needing(6000, 100 * mebibyte),
                                    needing(610, 110 * mebibyte), needing(600, 100 * mebibyte, 2)});
  ASSERT_EQ(arrays.size(), 4u);
  EXPECT_EQ(arrays[0].jobs, (std::vector<std::size_t>{1, 3}));
  EXPECT_EQ(arrays[0].memory, 512) << "twice the expected and 64 MiB, to a power of two";
  EXPECT_EQ(arrays[0].minutes, 16) << "eleven minutes, to a power of two";
  EXPECT_EQ(arrays[1].jobs, (std::vector<std::size_t>{2}));
  EXPECT_EQ(arrays[2].cores, 2);
  EXPECT_TRUE(arrays[3].alone);
}

TEST(SlurmArrays, StayBelowTheLargestIndexOfAnArray) {
  const auto arrays = slurm_arrays(std::vector<Job>(2500, needing(600, 0)));
  ASSERT_EQ(arrays.size(), 3u);
  for (const SlurmArray& array : arrays) EXPECT_LE(array.jobs.back() - array.jobs.front(), 999u);
  EXPECT_EQ(arrays[2].jobs.size(), 500u);
}

TEST(SbatchArguments, SayWhatTheArrayNeedsAndWhatItWaitsFor) {
  const SlurmArray array{{7, 9}, 2, 512, 16, true};
  EXPECT_EQ(sbatch_arguments(array, "/a tänk", {"31", "32"}),
            (std::vector<std::string>{"--parsable", "--job-name=slosh", "--array=0,2%1",
                                      "--chdir=/a tänk", "--output=slurm-%A_%a.log",
                                      "--cpus-per-task=2", "--mem=512M", "--time=16", "--exclusive",
                                      "--dependency=afterany:31:32"}));
}

}  // namespace
}  // namespace slosh::job_list_test
