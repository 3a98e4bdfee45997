// Runs a case's stages one after another, each as a process of its own, with its output in
// log.<stage>.
#include "openfoam_cases/run_case.hpp"

#include <fmt/format.h>

#include <boost/process/search_path.hpp>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

#include "openfoam_cases/child_program.hpp"
#include "openfoam_cases/errors.hpp"
#include "openfoam_cases/output/read_log.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;
using namespace std::chrono_literals;

constexpr auto poll_interval = 50ms;
constexpr auto progress_interval = 100ms;

// Passes the complete lines of a growing log to its reader.
class LogFollower {
 public:
  explicit LogFollower(const fs::path& log) : file_(log) {}

  void read_on() {
    file_.clear();
    for (std::string piece; std::getline(file_, piece);) {
      line_ += piece;
      if (file_.eof()) return;  // the rest of the line is still to come
      reader_.read_line(line_);
      line_.clear();
    }
  }

  const LogReader& reader() const { return reader_; }

 private:
  std::ifstream file_;
  std::string line_;
  LogReader reader_;
};

struct Stage {
  std::string name;
  std::vector<std::string> command;
  double time_limit;  // [s]
};

void run_stage(const Stage& stage, const fs::path& directory, const Progress& progress) {
  const fs::path log = fs::absolute(directory) / ("log." + stage.name);
  ChildProgram child(stage.command, directory, log);
  LogFollower follower(log);
  auto next_report = std::chrono::steady_clock::now();
  while (child.running()) {
    std::this_thread::sleep_for(poll_interval);
    follower.read_on();
    if (child.wall_time() > stage.time_limit) {
      child.end();
      throw RunError(
          fmt::format("{}: ended at its time limit of {:g} s", stage.name, stage.time_limit), log,
          follower.reader().meaningful_lines());
    }
    if (progress && follower.reader().steps() > 0 &&
        std::chrono::steady_clock::now() >= next_report) {
      progress(follower.reader().time(), follower.reader().steps());
      next_report = std::chrono::steady_clock::now() + progress_interval;
    }
  }
  follower.read_on();
  const LogReader& reader = follower.reader();
  std::string failure = child.bad_exit();
  if (const std::string logged = reader.failure(); !logged.empty()) {
    failure += (failure.empty() ? "" : ", ") + logged;
  }
  if (!failure.empty()) {
    throw RunError(fmt::format("{}: {}", stage.name, failure), log, reader.meaningful_lines());
  }
}

// A directory of its own for a program that is no run, since each program leaves a link where it
// runs (child_program.cpp).
struct ScratchDirectory {
  fs::path path;

  ScratchDirectory() {
    std::string name = (fs::temp_directory_path() / "slosh.XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw RunError(fmt::format("{}: no temporary directory: {}", name, strerror(errno)));
    path = name;
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;
  ~ScratchDirectory() {
    std::error_code none;
    fs::remove_all(path, none);
  }
};

}  // namespace

void run_case(const SloshingTank& tank, const fs::path& case_directory, const Progress& progress,
              const TimeLimits& limits) {
  const auto run_utility = [&](const std::string& name) {
    run_stage({name, {name}, limits.utility}, case_directory, {});
  };
  if (tank.outline.empty()) run_utility("blockMesh");
  run_utility("topoSet");
  const char* program = program_of(tank);
  if (tank.processes == 1) {
    run_stage({program, {program}, limits.solver}, case_directory, progress);
    return;
  }
  run_utility("decomposePar");
  find_program(program);
  // mpirun sets the PWD of its ranks itself. Ranks that are bound to cores would share the first
  // cores with those of another run at the same time.
  run_stage({program,
             {"mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
              std::to_string(tank.processes), "env", fmt::format("PWD={}", plain_path), program,
              "-parallel"},
             limits.solver},
            case_directory, progress);
  if (!tank.snapshot_times.empty()) run_utility("reconstructPar");
}

std::string installed_version() {
  if (bp::search_path("interFoam").empty()) return "";
  const ScratchDirectory scratch;
  const fs::path output = scratch.path / "log.help";
  ChildProgram child({"interFoam", "-help"}, scratch.path, output);
  while (child.running()) {
    if (child.wall_time() > TimeLimits().utility)
      throw RunError("interFoam -help: ended at its time limit");
    std::this_thread::sleep_for(10ms);
  }
  std::string version;
  std::ifstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    const auto open = line.find('(');  // "Using: OpenFOAM- (1912) - visit www.openfoam.com"
    if (line.starts_with("Using: OpenFOAM") && open != line.npos) {
      version = line.substr(open + 1, line.find(')') - open - 1);
    }
  }
  return version;
}

}  // namespace slosh::openfoam
