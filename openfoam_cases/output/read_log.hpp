// Reads what an OpenFOAM program printed: how far it got, what its steps cost, and whether it
// failed. An exit status of 0 is not enough: a run has succeeded only if its log also ends with the
// line "End" and contains neither an error nor a warning. One warning is counted and lets the run
// go on: interIsoFoam's isoCutFace::cutPoints finds a face whose corners all have the interface's
// value, to 1e-14, and takes the whole face as its cut.
#pragma once

#include <deque>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace slosh::openfoam {

// Reads a log line by line, so that a growing log can be followed.
class LogReader {
 public:
  void read_line(std::string_view line);

  double time() const { return time_; }    // [s] of the last step begun
  double steps() const { return steps_; }  // time steps begun
  double third_step_time() const {
    return third_step_time_;
  }  // [s]; infinite before the third step
  double max_courant_number() const { return max_courant_number_; }
  double mean_pressure_iterations() const;                           // per step
  double faces_in_interface() const { return faces_in_interface_; }  // of interIsoFoam's warning
  const std::string& version() const { return version_; }

  // Returns why the run that printed this log failed; empty where it succeeded.
  std::string failure() const;
  // Returns the first error (or, where there is none, the first warning) with the lines after it,
  // otherwise the last lines; without blank lines.
  std::string meaningful_lines() const;

 private:
  void read_numbers(std::string_view line);
  void read_failure(std::string_view line);

  double time_ = 0, steps_ = 0;
  double third_step_time_ = std::numeric_limits<double>::infinity();
  double max_courant_number_ = 0, pressure_iterations_ = 0, faces_in_interface_ = 0;
  std::string version_, failure_;
  std::deque<std::string> last_lines_, failure_lines_;
  bool ended_ = false;
};

// Throws RunError where the file cannot be read.
LogReader read_log(const std::filesystem::path& log);

}  // namespace slosh::openfoam
