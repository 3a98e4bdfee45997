// Runs a case's stages one after another, each as a process of its own without a shell, its output
// in log.<stage>. The children stay in the caller's process group, so that a signal to the group
// ends them too.
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <boost/process.hpp>
#include <boost/process/extend.hpp>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <thread>

#include "openfoam_cases/preloaded_library.hpp"
#include "openfoam_cases/process_tree.hpp"
#include "openfoam_cases/read_log.hpp"
#include "openfoam_cases/sloshing_tank.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;
using namespace std::chrono_literals;

constexpr auto poll_interval = 50ms;
constexpr auto progress_interval = 100ms;

// OpenFOAM takes its case's path from PWD and refuses one with a space or a quote in it. Linux has
// this name for any process's working directory.
constexpr const char* plain_path = "/proc/self/cwd";

// By a link in the working directory, as the dynamic linker takes a space or a colon for the end of
// a name.
void preload(const fs::path& library, const fs::path& directory, bp::environment& environment) {
  constexpr const char* link = "./libslosh_dictionary_digest.so";
  std::error_code failure;
  if (library.empty()) return;
  if (!fs::is_symlink(directory / link)) fs::create_symlink(library, directory / link, failure);
  if (failure) return;  // the runs then rest on OpenFOAM's own
  const std::string others = environment["LD_PRELOAD"].to_string();
  environment["LD_PRELOAD"] = others.empty() ? link : others + ":" + link;
}

bp::environment child_environment(const fs::path& directory) {
  bp::environment environment = boost::this_process::environment();
  environment["PWD"] = plain_path;
  // Where Debian's package keeps its etc/; without it no OpenFOAM program starts.
  if (environment.count("WM_PROJECT_DIR") == 0) {
    environment["WM_PROJECT_DIR"] = "/usr/share/openfoam";
  }
  preload(preloaded_library(), directory, environment);
  return environment;
}

boost::filesystem::path find_program(const std::string& name) {
  const auto program = bp::search_path(name);
  if (program.empty()) {
    throw RunError(
        fmt::format("{}: no such program on the PATH; Debian's package \"{}\" provides it", name,
                    name == "mpirun" ? "openmpi-bin" : "openfoam"));
  }
  return program;
}

// A running program that is ended with its owner.
class Child {
 public:
  Child(const std::vector<std::string>& command, const fs::path& directory, const fs::path& log)
      : process_(
            find_program(command.front()), bp::args(tail(command)), child_environment(directory),
            bp::start_dir(directory.string()),
            bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string(),
            // Also where its owner is killed and can end nothing: mpirun ends its ranks.
            bp::extend::on_exec_setup = [](auto&) { prctl(PR_SET_PDEATHSIG, SIGTERM); }) {}

  ~Child() { end(); }

  bool running() { return process_.running(); }

  void end() {
    std::error_code ignored;
    const auto runs = [&] { return process_.running(ignored); };
    if (runs()) end_process_tree(process_.id(), runs);
  }

  double wall_time() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }

  // Empty for a normal exit with status 0.
  std::string bad_exit() const {
    const int status = process_.native_exit_code();
    if (WIFSIGNALED(status)) {
      return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
    }
    return status == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
  }

 private:
  static std::vector<std::string> tail(const std::vector<std::string>& command) {
    return {command.begin() + 1, command.end()};
  }

  bp::child process_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// Hands a growing log to its reader, whole lines only.
class LogFollower {
 public:
  explicit LogFollower(const fs::path& log) : file_(log) {}

  void read_on() {
    file_.clear();
    for (std::string piece; std::getline(file_, piece);) {
      line_ += piece;
      if (file_.eof()) return;  // the line's end is still to come
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
  Child child(stage.command, directory, log);
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

std::string text_of(const std::string& message, const fs::path& log, const std::string& lines) {
  return message + (log.empty() ? "" : " (" + log.string() + ")") +
         (lines.empty() ? "" : "\n" + lines);
}

}  // namespace

RunError::RunError(const std::string& what_went_wrong, const fs::path& log_file,
                   const std::string& lines)
    : std::runtime_error(text_of(what_went_wrong, log_file, lines)),
      message(what_went_wrong),
      log(log_file),
      words(lines) {}

void run_case(const SloshingTank& tank, const fs::path& case_directory, const Progress& progress,
              const TimeLimits& limits) {
  const auto run_utility = [&](const std::string& name) {
    run_stage({name, {name}, limits.utility}, case_directory, {});
  };
  run_utility("blockMesh");
  run_utility("topoSet");
  if (tank.processes == 1) {
    run_stage({"interFoam", {"interFoam"}, limits.solver}, case_directory, progress);
    return;
  }
  run_utility("decomposePar");
  find_program("interFoam");
  // mpirun gives its ranks a PWD of its own. Ranks bound to cores would share the first ones with
  // those of another run beside this.
  run_stage({"interFoam",
             {"mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-np",
              std::to_string(tank.processes), "env", fmt::format("PWD={}", plain_path), "interFoam",
              "-parallel"},
             limits.solver},
            case_directory, progress);
  if (!tank.snapshot_times.empty()) run_utility("reconstructPar");
}

std::string installed_version() {
  if (bp::search_path("interFoam").empty()) return "";
  const std::unique_ptr<FILE, int (*)(FILE*)> file(std::tmpfile(), std::fclose);
  if (!file) throw RunError(fmt::format("no temporary file: {}", strerror(errno)));
  const std::string output = fmt::format("/proc/self/fd/{}", fileno(file.get()));
  Child child({"interFoam", "-help"}, ".", output);
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
