#include "verification/files/foreign/guarded_reading.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <mutex>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace slosh {
namespace {

struct Limits {
  rlim_t time;    // [s]
  rlim_t memory;  // [byte]
};

Limits limits_of(std::uintmax_t file_size) {
  return {10 + static_cast<rlim_t>(file_size / 1'000'000),
          (rlim_t{1} << 30) + 32 * static_cast<rlim_t>(file_size)};
}

// The address space that this process has [byte], which its copy begins with.
rlim_t present_memory() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t most) {
  rlimit limits;
  ::getrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
  limits.rlim_cur = std::min(most, limits.rlim_max);
  ::setrlimit(static_cast<__rlimit_resource_t>(resource), &limits);
}

// An interrupt is for this process: the child ends with it, or comes to its own end before.
void become_reader(const Limits& limits, rlim_t memory) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::signal(signal, SIG_IGN);
  for (const int signal : {SIGXCPU, SIGALRM, SIGSEGV, SIGBUS, SIGABRT}) ::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);  // for the last words of the allocator
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.time);
  limit(RLIMIT_AS, memory + limits.memory);
  ::alarm(static_cast<unsigned>(10 * limits.time));  // also where it waits
}

// No status of a sanitizer or a shell.
enum ChildEnd : int { has_read = 0, has_refused = 101, has_no_memory = 102 };

[[noreturn]] void read_in_child(int pipe, const std::function<void()>& read) {
  ChildEnd end = has_read;
  try {
    read();
  } catch (const std::bad_alloc&) {
    end = has_no_memory;
  } catch (const std::length_error&) {
    end = has_no_memory;
  } catch (const std::exception& error) {
    end = has_refused;
    [[maybe_unused]] const ssize_t told = ::write(pipe, error.what(), std::strlen(error.what()));
  }
  ::_exit(end);
}

std::string text_from(int pipe) {
  std::string text;
  char part[4096];
  for (ssize_t count; (count = ::read(pipe, part, sizeof part)) != 0;) {
    if (count > 0) text.append(part, static_cast<std::size_t>(count));
    if (count < 0 && errno != EINTR) break;
  }
  return text;
}

int end_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

// Throws unless the child has read everything.
void judge(int status, const std::string& refusal, const Limits& limits) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == has_read) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == has_refused) throw std::runtime_error(refusal);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  throw std::runtime_error(
      WIFEXITED(status) && WEXITSTATUS(status) == has_no_memory
          ? fmt::format("reading it takes more than {} MB of memory", limits.memory >> 20)
      : signal == SIGXCPU || signal == SIGALRM
          ? fmt::format("reading it does not end within {} s", limits.time)
      : signal != 0 ? fmt::format("reading it ends with signal {} ({})", signal, strsignal(signal))
                    : fmt::format("reading it ends with status {}", WEXITSTATUS(status)));
}

}  // namespace

void read_guarded(std::uintmax_t file_size, const std::function<void()>& read) {
  // One reader at a time: the copy of a process whose other threads hold a library's locks waits
  // for them in vain.
  static std::mutex alone;
  const std::lock_guard lock(alone);
  const Limits limits = limits_of(file_size);
  const rlim_t memory = present_memory();
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "cannot read by a process apart");
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    become_reader(limits, memory);
    read_in_child(ends[1], read);
  }
  ::close(ends[1]);
  const std::string refusal = text_from(ends[0]);
  ::close(ends[0]);
  if (child < 0)
    throw std::system_error(errno, std::generic_category(), "cannot read by a process apart");
  judge(end_of(child), refusal, limits);
  read();
}

}  // namespace slosh
