#include "verification/results/cost_meter.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace slosh {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * time.tv_usec;
}

}  // namespace

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
