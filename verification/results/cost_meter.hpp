// What a run took, by the operating system's account of this process and of the children that it
// waited for.
#pragma once

#include <chrono>

#include "verification/results/result_file.hpp"

namespace slosh {

// Starts to count when made. Times are those since then; the peak memory is the process's own since
// it began, or that of its largest child.
class CostMeter {
 public:
  CostMeter();
  RunCost cost() const;  // steps and elements are left for the run to fill in

 private:
  RunCost so_far() const;
  std::chrono::steady_clock::time_point begin_;
  RunCost at_begin_;
};

}  // namespace slosh
