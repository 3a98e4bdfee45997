#include "verification/files/child_process.hpp"

#include <signal.h>
#include <sys/prctl.h>

#include <boost/process.hpp>
#include <boost/process/extend.hpp>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

#include "verification/files/adopted_processes.hpp"

namespace slosh {
namespace {

namespace bp = boost::process;
using Clock = std::chrono::steady_clock;

using LogFile = std::unique_ptr<FILE, int (*)(FILE*)>;

LogFile open_log(const std::filesystem::path& file) {
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
  LogFile log(std::fopen(file.c_str(), "we"), std::fclose);
  if (!log) {
    throw std::system_error(errno, std::generic_category(),
                            "cannot write the log " + file.string());
  }
  return log;
}

// The children that this process has started here and still owns: none of them is adopted.
class OwnChildren {
 public:
  void add(pid_t child) {
    const std::lock_guard lock(mutex_);
    living_.insert(child);
  }
  void remove(pid_t child) {
    const std::lock_guard lock(mutex_);
    living_.erase(child);
  }
  std::set<pid_t> all() const {
    const std::lock_guard lock(mutex_);
    return living_;
  }

 private:
  mutable std::mutex mutex_;
  std::set<pid_t> living_;
};

OwnChildren& own_children() {
  static OwnChildren children;
  return children;
}

}  // namespace

struct ChildProcess::State {
  bp::group group;
  bp::child child;
  Clock::time_point begin = Clock::now();
  std::optional<Clock::time_point> terminated;
  std::chrono::seconds grace;

  void signal_group(int signal) const { ::kill(-group.native_handle(), signal); }
  bool group_lives() const {
    adopted_processes(own_children().all());  // reaps those of the group that have ended
    return ::kill(-group.native_handle(), 0) == 0;
  }

  ~State() {
    if (!child.valid()) return;  // it has never started
    std::error_code ignored;
    signal_group(SIGKILL);
    child.wait(ignored);
    own_children().remove(child.id());
    end_adopted_processes(own_children().all());
  }
};

ChildProcess::ChildProcess(const std::vector<std::string>& command, const ChildSettings& settings)
    : state_(std::make_unique<State>()) {
  state_->grace = settings.grace;
  const LogFile log = open_log(settings.log_file);
  const std::vector<std::string> arguments(command.begin() + 1, command.end());
  bp::environment environment = boost::this_process::environment();
  for (const auto& [name, value] : settings.environment) environment[name] = value;
  const std::filesystem::path directory =
      settings.directory.empty() ? std::filesystem::current_path() : settings.directory;
  adopt_orphans();
  const auto end_with_parent = [](auto&) { ::prctl(PR_SET_PDEATHSIG, SIGTERM); };
  state_->child = bp::child(bp::exe = command.front(), bp::args = arguments, environment,
                            bp::start_dir = directory.string(), state_->group,
                            bp::extend::on_exec_setup = end_with_parent,
                            bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.get());
  own_children().add(state_->child.id());
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
  // Out of grace a group may still show: killed processes that nobody has reaped.
  return !child_runs && (out_of_grace || !state_->group_lives());
}

int ChildProcess::wait_status() const { return state_->child.native_exit_code(); }

double ChildProcess::wall_time() const {
  return std::chrono::duration<double>(Clock::now() - state_->begin).count();
}

}  // namespace slosh
