#include "verification/engine/launcher.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include "verification/engine/job_list.hpp"
#include "verification/engine/slurm_engine.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/child_process.hpp"
#include "verification/files/own_files.hpp"

namespace slosh {
namespace {

constexpr const char* head = R"(ninja_required_version = 1.8
pool alone
  depth = 1
rule job
  command = exec "$$SLOSH_TOOL" job $index
  description = job $index
)";

// Longer than a job needs to kill a process that ignores SIGTERM.
constexpr std::chrono::seconds grace{15};

std::string pool_of(const Job& job) {
  if (job.alone) return "  pool = alone\n";
  return job.cores > 1 ? fmt::format("  pool = cores_{}\n", job.cores) : "";
}

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

std::string ninja_file(const std::vector<Job>& jobs, int at_once) {
  std::string text = head, others;
  std::set<int> widths;
  for (const Job& job : jobs)
    if (job.cores > 1) widths.insert(job.cores);
  for (const int cores : widths)
    text += fmt::format("pool cores_{}\n  depth = {}\n", cores, std::max(1, at_once / cores));
  for (std::size_t i = 0; i < jobs.size(); ++i)
    if (!jobs[i].alone) others += fmt::format(" {}.ended.json", i);
  text += fmt::format("build others: phony{}\n", others);
  for (std::size_t i = 0; i < jobs.size(); ++i)
    text += fmt::format("build {0}.ended.json: job{1}\n  index = {0}\n{2}", i,
                        jobs[i].alone ? " || others" : "", pool_of(jobs[i]));
  return text;
}

std::vector<JobState> run_by_ninja(const JobList& list, const LaunchSettings& settings,
                                   const std::atomic<bool>& stop, const ObserveJobs& observe) {
  const std::filesystem::path program = program_on_path("ninja");
  if (program.empty())
    throw MissingEngine("ninja is not installed: it runs the jobs of a campaign");
  replace_file(list.directory() / "build.ninja", ninja_file(list.jobs(), settings.at_once),
               Durability::process_crash);
  ChildProcess ninja({program.string(), "-k", "0", "-j", std::to_string(settings.at_once)},
                     {.log_file = list.directory() / "ninja.log",
                      .directory = list.directory(),
                      .environment = {{"SLOSH_TOOL", settings.tool.string()}},
                      .grace = grace});
  Watch watch(list, observe);
  while (!ninja.is_over()) {
    if (stop) ninja.terminate();
    watch.look();
    std::this_thread::sleep_for(Watch::interval);
  }
  return watch.finish(stop, "see " + (list.directory() / "ninja.log").string());
}

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
