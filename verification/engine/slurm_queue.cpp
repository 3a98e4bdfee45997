#include "verification/engine/slurm_queue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <boost/asio/io_context.hpp>
#include <boost/process.hpp>
#include <chrono>
#include <future>
#include <sstream>
#include <thread>

#include "verification/engine/launch_settings.hpp"

namespace slosh {
namespace {

namespace bp = boost::process;

constexpr std::chrono::seconds time_limit{60};

// Polls the child, for the library's own wait with a time limit is deprecated.
bool ends_within(bp::child& child, std::chrono::seconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  std::error_code ignored;
  while (child.running(ignored)) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace

SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments,
                      const std::map<std::string, std::string>& more) {
  const auto path = bp::search_path(program);
  if (path.empty())
    throw MissingEngine(program + " is not installed: --launcher slurm needs Slurm's commands");
  bp::environment environment = boost::this_process::environment();
  for (const auto& [name, value] : more) environment[name] = value;
  boost::asio::io_context service;
  std::future<std::string> out, err;
  bp::child child(bp::exe = path, bp::args = arguments, environment,
                  bp::std_in<bp::null, bp::std_out> out, bp::std_err > err, service);
  service.run_for(time_limit);  // until its output ends
  if (!ends_within(child, time_limit)) {
    std::error_code ignored;
    child.terminate(ignored);
    throw EngineError(fmt::format("{} has not ended within {} s", program, time_limit.count()));
  }
  return {child.exit_code(), out.get(), err.get()};
}

std::optional<std::set<std::string>> queued_tasks(const std::vector<std::string>& arrays) try {
  const SlurmAnswer answer = ask_slurm(
      "squeue",
      {"--noheader", "--array", "--format=%i", fmt::format("--jobs={}", fmt::join(arrays, ","))});
  // A job that the controller no longer knows has ended.
  if (answer.err.find("Invalid job id") != std::string::npos) return std::set<std::string>{};
  if (answer.status != 0) return std::nullopt;
  std::set<std::string> tasks;
  std::istringstream lines(answer.out);
  for (std::string task; lines >> task;) tasks.insert(task);
  return tasks;
} catch (const EngineError&) {
  return std::nullopt;
}

std::string state_of_task(const std::string& task) try {
  const SlurmAnswer answer = ask_slurm("scontrol", {"--oneliner", "show", "job", task});
  const std::string mark = "JobState=";
  const std::size_t at = answer.out.find(mark);
  if (at == std::string::npos) return "no longer known to Slurm";
  const std::size_t begin = at + mark.size();
  return "Slurm says " + answer.out.substr(begin, answer.out.find(' ', begin) - begin);
} catch (const EngineError&) {
  return "Slurm does not answer";
}

}  // namespace slosh
