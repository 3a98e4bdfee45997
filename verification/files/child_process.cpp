#include "verification/files/child_process.hpp"

#include <fcntl.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <boost/process.hpp>
#include <boost/process/extend.hpp>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "verification/files/file_lock.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {
namespace {

namespace bp = boost::process;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

// A process that does not end on SIGKILL waits for a device, and another may hold a lock: this
// process does not wait for them.
constexpr auto patience = 5s;
constexpr auto usual_choice = 300ms;  // far longer than a child takes to start

using LogFile = std::unique_ptr<FILE, int (*)(FILE*)>;

// Closed when this process starts another child.
LogFile unnamed_file() {
  LogFile file(std::tmpfile(), std::fclose);
  if (!file)
    throw std::system_error(errno, std::generic_category(), "cannot make a temporary file");
  ::fcntl(::fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

// An earlier program may have left a link or a pipe in its place: neither is written to.
LogFile open_log(const std::filesystem::path& file) {
  if (file.empty()) return unnamed_file();
  require_no_input(file);
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  const int descriptor = ::open(
      file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  LogFile log(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w"), std::fclose);
  struct stat status;
  if (log && ::fstat(descriptor, &status) == 0 && !S_ISREG(status.st_mode)) {
    log.reset();
    errno = EINVAL;
  }
  if (!log) {
    throw std::system_error(errno, std::generic_category(),
                            "cannot write the log " + file.string());
  }
  return log;
}

std::string text_of(FILE* file) {
  std::string text;
  char part[4096];
  for (ssize_t count;
       (count = ::pread(::fileno(file), part, sizeof part, static_cast<off_t>(text.size()))) > 0;)
    text.append(part, static_cast<std::size_t>(count));
  return text;
}

// Takes the lock that is held until a child is bound to its cores, so that another one finds it so.
// It lies in a directory of this user alone. Without it, as where another user has made a directory
// of that name, or after five seconds, two children may be bound to the same cores.
void take_choice_of_cores(std::optional<FileLock>& choice) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("slosh-" + std::to_string(::getuid()));
  ::mkdir(directory.c_str(), S_IRWXU);
  struct stat status;
  if (::lstat(directory.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != ::getuid() || (status.st_mode & (S_IRWXG | S_IRWXO)) != 0)
    return;
  struct TooLong {};
  const auto begin = Clock::now();
  try {
    choice.emplace(directory / "cores.lock", [begin, tell = telling_once("chooses its cores")] {
      if (Clock::now() - begin > patience) throw TooLong();
      if (Clock::now() - begin > usual_choice) tell();
    });
  } catch (const TooLong&) {
  } catch (const std::filesystem::filesystem_error&) {
  }
}

// The kernel's own threads have no command line: most are bound to a core and do not use it.
bool has_command_line(const std::filesystem::path& process) {
  std::ifstream stream(process / "cmdline");
  return stream.peek() != std::ifstream::traits_type::eof();
}

// Adopted processes have lost their parent and became children of this process: what a child has
// started and left behind, also in a session of its own (setsid), which no signal to the child's
// process group reaches. prctl(2), PR_SET_CHILD_SUBREAPER.

constexpr auto look_interval = 2ms;

std::set<pid_t> children() {
  std::set<pid_t> found;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream list(thread.path() / "children");
    for (pid_t child; list >> child;) found.insert(child);
  }
  return found;
}

// Makes this process adopt the orphans among its descendants from now on; one call is enough.
void adopt_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

// The children that this process has started here and that are still running or not yet reaped;
// none of them counts as adopted. Other threads neither start nor look while one does.
struct OwnChildren {
  std::mutex mutex;
  std::set<pid_t> living;
};

OwnChildren& own_children() {
  static OwnChildren children;
  return children;
}

// The adopted processes: children of this process in another process group, except its own. Reaps
// those that have ended.
std::set<pid_t> adopted_processes() {
  const std::lock_guard lock(own_children().mutex);
  std::set<pid_t> adopted;
  for (const pid_t child : children())
    if (!own_children().living.contains(child) && ::getpgid(child) != ::getpgrp() &&
        ::waitpid(child, nullptr, WNOHANG) == 0)
      adopted.insert(child);
  return adopted;
}

// Ends all adopted processes and the orphans that they leave in turn, with SIGKILL.
void end_adopted_processes() {
  const auto begin = Clock::now();
  for (std::set<pid_t> left = adopted_processes(); !left.empty() && Clock::now() - begin < patience;
       left = adopted_processes()) {
    for (const pid_t process : left) ::kill(process, SIGKILL);
    std::this_thread::sleep_for(look_interval);
  }
}

}  // namespace

struct ChildProcess::State {
  explicit State(const ChildSettings& settings)
      : log(open_log(settings.log_file)),
        errors(settings.splits_errors ? unnamed_file() : LogFile(nullptr, std::fclose)),
        grace(settings.grace) {}

  LogFile log, errors;
  bp::group group;
  bp::child child;
  Clock::time_point begin = Clock::now();
  std::optional<Clock::time_point> terminated;
  std::chrono::seconds grace;

  void signal_group(int signal) const { ::kill(-group.native_handle(), signal); }
  bool group_lives() const {
    adopted_processes();  // reaps those of the group that have ended
    return ::kill(-group.native_handle(), 0) == 0;
  }

  ~State() {
    if (!child.valid()) return;  // the child has never started
    std::error_code ignored;
    signal_group(SIGKILL);
    child.wait(ignored);
    {
      const std::lock_guard lock(own_children().mutex);
      own_children().living.erase(child.id());
    }
    end_adopted_processes();
  }
};

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildSettings& settings)
    : state_(std::make_unique<State>(settings)) {
  const std::vector<std::string> arguments(command.begin() + 1, command.end());
  bp::environment environment = boost::this_process::environment();
  for (const auto& [name, value] : settings.environment) environment[name] = value;
  const std::filesystem::path directory =
      settings.directory.empty() ? std::filesystem::current_path() : settings.directory;
  adopt_orphans();
  std::optional<FileLock> choice;
  cpu_set_t cores;
  CPU_ZERO(&cores);
  if (settings.cores > 0) {
    take_choice_of_cores(choice);
    for (const int core : least_bound_cores(settings.cores)) CPU_SET(core, &cores);
  }
  const auto set_up = [&](auto&) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (settings.cores > 0) ::sched_setaffinity(0, sizeof cores, &cores);
  };
  FILE *const out = state_->log.get(), *const errors = state_->errors ? state_->errors.get() : out;
  const std::lock_guard lock(own_children().mutex);
  state_->child = bp::child(bp::exe = command.front(), bp::args = arguments, environment,
                            bp::start_dir = directory.string(), state_->group,
                            bp::extend::on_exec_setup = set_up,
                            bp::std_in<bp::null, bp::std_out> out, bp::std_err > errors);
  own_children().living.insert(state_->child.id());
}

ChildProcess::ChildProcess(ChildProcess&&) noexcept = default;
ChildProcess& ChildProcess::operator=(ChildProcess&&) noexcept = default;
ChildProcess::~ChildProcess() = default;

void ChildProcess::terminate() {
  if (state_->terminated) return;
  state_->terminated = Clock::now();
  state_->signal_group(SIGTERM);
}

bool ChildProcess::is_over() {
  const bool child_runs = state_->child.running();
  if (!state_->terminated) return !child_runs;
  const bool out_of_grace = Clock::now() - *state_->terminated > state_->grace;
  if (out_of_grace) state_->signal_group(SIGKILL);
  // After the grace the group may still exist: killed processes that nobody has reaped.
  return !child_runs && (out_of_grace || !state_->group_lives());
}

bool ChildProcess::ends_within(std::chrono::duration<double> limit) {
  const auto end = state_->begin + std::chrono::duration_cast<Clock::duration>(limit);
  for (; !is_over(); std::this_thread::sleep_for(look_interval))
    if (!state_->terminated && Clock::now() > end) terminate();
  return !state_->terminated;
}

std::string ChildProcess::output() const { return text_of(state_->log.get()); }
std::string ChildProcess::errors() const { return text_of(state_->errors.get()); }

int ChildProcess::exit_status() const { return state_->child.exit_code(); }
int ChildProcess::wait_status() const { return state_->child.native_exit_code(); }

double ChildProcess::wall_time() const {
  return std::chrono::duration<double>(Clock::now() - state_->begin).count();
}

std::filesystem::path program_on_path(const std::string& name) {
  return bp::search_path(name).string();
}

Cores allowed_cores(pid_t process) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (::sched_getaffinity(process, sizeof set, &set) != 0) return {};
  Cores cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

Cores least_bound(const Cores& cores, const std::vector<Cores>& of_others, int wanted) {
  std::vector<std::pair<int, int>> bound;  // the number of processes, and the core
  for (const int core : cores) bound.emplace_back(0, core);
  for (const Cores& of_other : of_others) {
    Cores shared;
    std::set_intersection(cores.begin(), cores.end(), of_other.begin(), of_other.end(),
                          std::back_inserter(shared));
    if (shared.size() == cores.size()) continue;
    for (auto& [processes, core] : bound)
      processes += std::binary_search(shared.begin(), shared.end(), core);
  }
  std::sort(bound.begin(), bound.end());
  Cores chosen;
  for (const auto& [processes, core] : bound)
    if (static_cast<int>(chosen.size()) < wanted) chosen.push_back(core);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

Cores least_bound_cores(int wanted) {
  std::vector<Cores> of_others;
  std::error_code none;  // without /proc nothing is known of the others
  for (const auto& entry : std::filesystem::directory_iterator("/proc", none)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") == name.npos && has_command_line(entry.path()))
      of_others.push_back(allowed_cores(std::stoi(name)));
  }
  return least_bound(allowed_cores(), of_others, wanted);
}

}  // namespace slosh
