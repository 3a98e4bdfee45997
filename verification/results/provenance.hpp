// How a result was made: the versions, the compiler and the processor, the time, the command that
// repeats it, and what it cost.
#pragma once

#include <chrono>
#include <map>
#include <string>

#include "verification/results/result_file.hpp"

namespace slosh {

// Returns slosh_version, compiler, compiler_flags, processor, date_utc (ISO 8601, now) and command.
std::map<std::string, std::string> provenance(const std::string& command);

// Measures the cost of this process and of the children that it waited for, by the operating
// system's account (getrusage(2)). Times count from the meter's construction. The peak memory is
// the process's own since it began, or that of its largest child.
class CostMeter {
 public:
  CostMeter();
  RunCost cost() const;  // without steps and elements, which the run fills in

 private:
  RunCost so_far() const;
  std::chrono::steady_clock::time_point begin_;
  RunCost at_begin_;
};

}  // namespace slosh
