#include "openfoam_cases/child_program.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <boost/process.hpp>
#include <boost/process/extend.hpp>
#include <cstring>
#include <fstream>
#include <functional>
#include <system_error>
#include <thread>

#include "openfoam_cases/errors.hpp"

namespace slosh::openfoam {
namespace {

namespace fs = std::filesystem;
namespace bp = boost::process;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto grace = 3s;
constexpr auto look_interval = 20ms;

// Preloads the library by a link in the working directory, as the dynamic linker takes a space or a
// colon for the end of a name.
void preload(const fs::path& library, const fs::path& directory, bp::environment& environment) {
  constexpr const char* link = "./libslosh_dictionary_digest.so";
  std::error_code failure;
  if (library.empty()) return;
  if (!fs::is_symlink(directory / link)) fs::create_symlink(library, directory / link, failure);
  if (failure) return;  // the run then uses OpenFOAM's own function
  const std::string others = environment["LD_PRELOAD"].to_string();
  environment["LD_PRELOAD"] = others.empty() ? link : others + ":" + link;
}

bp::environment child_environment(const fs::path& directory) {
  bp::environment environment = boost::this_process::environment();
  environment["PWD"] = plain_path;
  // No OpenFOAM program starts without WM_PROJECT_DIR; Debian's package keeps its etc/ here.
  if (environment.count("WM_PROJECT_DIR") == 0) {
    environment["WM_PROJECT_DIR"] = "/usr/share/openfoam";
  }
  preload(preloaded_library(), directory, environment);
  return environment;
}

std::vector<std::string> arguments_of(const std::vector<std::string>& command) {
  return {command.begin() + 1, command.end()};
}

// Appends the children of the process's main thread, which starts all processes in the programs
// used here, and their descendants.
void append_descendants(pid_t process, std::vector<pid_t>& list) {
  std::ifstream children(fmt::format("/proc/{0}/task/{0}/children", process));
  for (pid_t child; children >> child;) {
    list.push_back(child);
    append_descendants(child, list);
  }
}

// `runs` returns whether the child still runs, and reaps it where it does not.
void end_process_tree(pid_t child, const std::function<bool()>& runs) {
  std::vector<pid_t> tree{child};
  append_descendants(child, tree);  // before a process is orphaned and can no longer be found
  ::kill(child, SIGTERM);
  for (const auto end = Clock::now() + grace; runs() && Clock::now() < end;)
    std::this_thread::sleep_for(look_interval);
  const std::size_t first = runs() ? 0 : 1;  // the number of a reaped process is no longer its own
  for (std::size_t i = first; i < tree.size(); ++i) ::kill(tree[i], SIGKILL);
  while (runs()) std::this_thread::sleep_for(look_interval);
}

}  // namespace

boost::filesystem::path find_program(const std::string& name) {
  auto program = bp::search_path(name);
  if (program.empty()) {
    throw RunError(
        fmt::format("{}: no such program on the PATH; Debian's package \"{}\" provides it", name,
                    name == "mpirun" ? "openmpi-bin" : "openfoam"));
  }
  return program;
}

fs::path preloaded_library() {
  std::error_code unknown;
  fs::path place = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  for (; place.has_relative_path(); place = place.parent_path()) {
    fs::path library = place / "openfoam_cases/libslosh_dictionary_digest.so";
    if (fs::exists(library, unknown)) return library;
  }
  return {};
}

ChildProgram::ChildProgram(const std::vector<std::string>& command, const fs::path& directory,
                           const fs::path& log)
    : process_(
          find_program(command.front()), bp::args(arguments_of(command)),
          child_environment(directory), bp::start_dir(directory.string()),
          bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.string(),
          // The program also ends where its owner is killed; mpirun then ends its ranks.
          bp::extend::on_exec_setup = [](auto&) { prctl(PR_SET_PDEATHSIG, SIGTERM); }) {}

ChildProgram::~ChildProgram() { end(); }

bool ChildProgram::running() { return process_.running(); }

void ChildProgram::end() {
  std::error_code ignored;
  const auto runs = [&] { return process_.running(ignored); };
  if (runs()) end_process_tree(process_.id(), runs);
}

double ChildProgram::wall_time() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
}

std::string ChildProgram::bad_exit() const {
  const int status = process_.native_exit_code();
  if (WIFSIGNALED(status)) {
    return fmt::format("killed by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return status == 0 ? "" : fmt::format("exit status {}", WEXITSTATUS(status));
}

}  // namespace slosh::openfoam
