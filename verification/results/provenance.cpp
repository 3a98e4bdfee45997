#include "verification/results/provenance.hpp"

#include <fmt/chrono.h>
#include <sys/resource.h>

#include <algorithm>
#include <ctime>
#include <fstream>

namespace slosh {
namespace {

// Returns the model name of the first processor that Linux lists; empty where it lists none.
std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec;
}

}  // namespace

std::map<std::string, std::string> provenance(const std::string& command) {
  return {{"slosh_version", SLOSH_VERSION},
          {"compiler", SLOSH_COMPILER},
          {"compiler_flags", SLOSH_COMPILER_FLAGS},
          {"processor", processor()},
          {"date_utc", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"command", command}};
}

CostMeter::CostMeter() : begin_(std::chrono::steady_clock::now()), at_begin_(so_far()) {}

RunCost CostMeter::so_far() const {
  RunCost total;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage;
    getrusage(who, &usage);
    total.user_time += seconds(usage.ru_utime);
    total.system_time += seconds(usage.ru_stime);
    // Linux counts ru_maxrss in KiB (getrusage(2)).
    total.peak_memory = std::max(total.peak_memory, 1024.0 * usage.ru_maxrss);
  }
  return total;
}

RunCost CostMeter::cost() const {
  RunCost cost = so_far();
  cost.user_time -= at_begin_.user_time;
  cost.system_time -= at_begin_.system_time;
  cost.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  return cost;
}

}  // namespace slosh
