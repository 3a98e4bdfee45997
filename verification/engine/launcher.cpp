#include "verification/engine/launcher.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "verification/engine/job_list.hpp"
#include "verification/engine/ninja_engine.hpp"
#include "verification/engine/slurm_engine.hpp"
#include "verification/files/own_files.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Returns a name that no earlier start had.
fs::path fresh_list(const fs::path& directory) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return directory / fmt::format("list_{}_{}", now.count(), ::getpid());
}

void remove_lists(const fs::path& directory) {
  if (!fs::is_directory(directory)) return;
  for (const auto& entry : fs::directory_iterator(directory))
    // Processes left of an earlier start may write there at this moment; the next start removes it.
    if (std::error_code none;
        entry.path().filename().string().starts_with("list_") && !foreign_at(entry.path()))
      fs::remove_all(entry.path(), none);
}

// What the jobs write beside their progress.
std::vector<fs::path> outputs_of(const std::vector<Job>& jobs, const fs::path& list) {
  std::vector<fs::path> outputs{list};
  for (const Job& job : jobs) {
    if (!job.progress_file.empty()) require_progress_place(job.progress_file);
    if (!job.log_file.empty()) outputs.push_back(job.log_file);
  }
  return outputs;
}

}  // namespace

std::vector<JobState> launch(const std::vector<Job>& jobs, const LaunchSettings& settings,
                             const std::atomic<bool>& stop, const ObserveJobs& observe) {
  if (settings.at_once < 1)
    throw std::invalid_argument(
        fmt::format("at_once = {}: expected at least one core to fill", settings.at_once));
  if (jobs.empty()) return {};
  remove_lists(settings.directory);
  const fs::path place = fresh_list(settings.directory);
  const OpenOutputs outputs(outputs_of(jobs, place));
  // A job that never starts must not show an old log. What is foreign is set aside already.
  for (const Job& job : jobs) fs::remove(job.log_file);
  const JobList list = JobList::create(place, jobs);
  return settings.engine == Engine::slurm ? run_by_slurm(list, settings, stop, observe)
                                          : run_by_ninja(list, settings, stop, observe);
}

}  // namespace slosh
