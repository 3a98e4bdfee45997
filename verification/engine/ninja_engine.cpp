#include "verification/engine/ninja_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/process/search_path.hpp>
#include <chrono>
#include <set>
#include <thread>

#include "verification/engine/watch.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/child_process.hpp"

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
  const auto program = boost::process::search_path("ninja");
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

}  // namespace slosh
