// The jobs of one start of a campaign as files in one directory. These files are all that the
// processes that run the jobs share with the one that waits for them, on this machine or on others:
//   jobs.cbor     the jobs
//   N.started     empty, made when job N starts
//   N.ended.json  how it has ended, replaced as a whole
#pragma once

#include <chrono>
#include <filesystem>
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

}  // namespace slosh
