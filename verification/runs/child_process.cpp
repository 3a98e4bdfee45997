#include "verification/runs/child_process.hpp"

#include <signal.h>

#include <boost/process.hpp>
#include <cerrno>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace slosh {
namespace {

namespace bp = boost::process;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds grace{
    3};  // from SIGTERM to SIGKILL: long enough for mpirun to end its ranks

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

}  // namespace

struct ChildProcess::State {
  bp::group group;  // kills what is left of it when it goes
  bp::child child;
  Clock::time_point begin = Clock::now();
  std::optional<Clock::time_point> terminated;

  void signal_group(int signal) const { ::kill(-group.native_handle(), signal); }
  bool group_lives() const { return ::kill(-group.native_handle(), 0) == 0; }

  ~State() {
    std::error_code ignored;
    if (!child.running(ignored)) return;
    signal_group(SIGKILL);
    child.wait(ignored);
  }
};

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::filesystem::path& log_file,
                           const std::filesystem::path& directory)
    : state_(std::make_unique<State>()) {
  const LogFile log = open_log(log_file);
  const std::vector<std::string> arguments(command.begin() + 1, command.end());
  const std::string start = (directory.empty() ? "." : directory).string();
  state_->child =
      bp::child(bp::exe = command.front(), bp::args = arguments, state_->group,
                bp::start_dir = start, bp::std_in<bp::null, (bp::std_out & bp::std_err)> log.get());
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
  const bool out_of_grace = Clock::now() - *state_->terminated > grace;
  if (out_of_grace) state_->signal_group(SIGKILL);
  // Out of grace a group may still show: killed processes that nobody has reaped.
  return !child_runs && (out_of_grace || !state_->group_lives());
}

int ChildProcess::wait_status() const { return state_->child.native_exit_code(); }

double ChildProcess::wall_time() const {
  return std::chrono::duration<double>(Clock::now() - state_->begin).count();
}

}  // namespace slosh
