// The jobs of one start of a campaign as files in one directory. These files are all that the
// processes that run the jobs share with the one that waits for them, on this machine or on others:
//   jobs.cbor     the jobs
//   N.started     empty, made when job N starts
//   N.ended.json  how it has ended, replaced as a whole
// Below, how a process runs one job, and how the one that waits follows them all.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "verification/engine/job.hpp"

namespace slosh {

class JobList {
 public:
  // Writes a new list to the directory, which is made and must not have one yet.
  // Throws std::filesystem::filesystem_error.
  static JobList create(const std::filesystem::path& directory, const std::vector<Job>& jobs);

  // Reads the list in the directory. Throws std::runtime_error naming the file where it cannot be
  // read.
  static JobList open(const std::filesystem::path& directory);

  const std::filesystem::path& directory() const { return directory_; }
  const std::vector<Job>& jobs() const { return jobs_; }

  void mark_started(std::size_t index) const;
  void mark_ended(std::size_t index, const JobState& state) const;

  // Reads the files of the jobs that had not ended in `states`, which is as long as the list.
  // Returns whether a job's phase has changed.
  bool update(std::vector<JobState>& states) const;

  // Returns a state for each job, all of them waiting.
  std::vector<JobState> initial_states() const;

 private:
  JobList(std::filesystem::path directory, std::vector<Job> jobs)
      : directory_(std::move(directory)), jobs_(std::move(jobs)) {}
  std::filesystem::path file(std::size_t index, const char* suffix) const;
  bool update(std::size_t index, JobState& state) const;

  std::filesystem::path directory_;
  std::vector<Job> jobs_;
};

// Starts the job, waits for it, enforces its time limit, records in the list how it has ended, and
// returns that. Once `stop` is true the job's process group gets SIGTERM, three seconds later
// what is left of it SIGKILL. Throws std::filesystem::filesystem_error where the list cannot be
// written.
JobState run_job(const JobList& list, std::size_t index, const std::atomic<bool>& stop);

// Follows the jobs of a list while an engine runs them.
class Watch {
 public:
  static constexpr std::chrono::milliseconds interval{20};  // between calls of look()

  Watch(const JobList& list, const ObserveJobs& observe);

  // Reads the list, and calls the observer at each change and about five times a second.
  void look();

  const std::vector<JobState>& states() const { return states_; }

  // Marks a job that the engine no longer knows and of whose end the list has no record: as lost,
  // or as not started where the list has no record of its start either.
  void lose(std::size_t index, const std::string& what_is_known);

  // Is called once the engine has ended. A job without a record of its end is marked as interrupted
  // where `stopped`, else as lose() does.
  std::vector<JobState> finish(bool stopped, const std::string& what_is_known);

 private:
  using Clock = std::chrono::steady_clock;
  void tell();

  const JobList& list_;
  const ObserveJobs& observe_;
  std::vector<JobState> states_;
  Clock::time_point told_ = {};
};

}  // namespace slosh
