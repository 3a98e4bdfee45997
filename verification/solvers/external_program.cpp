#include "verification/solvers/external_program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstring>
#include <deque>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>

#include "verification/files/bound_cores.hpp"
#include "verification/files/child_process.hpp"
#include "verification/input/tables/table_reader.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto poll_interval = 50ms;
// From the signal that ends this process to the kill of the program's process group: less than the
// time that a campaign leaves its runs before it kills them.
constexpr auto grace = 1s;

// While an object of this class lives, the signals that would end this process are held back, so
// that the program, which has a process group of its own, is ended first.
class AwaitedEnd {
 public:
  AwaitedEnd() {
    for (std::size_t i = 0; i < std::size(signals); ++i)
      former_[i] = std::signal(signals[i], [](int signal) { asked = signal; });
  }
  AwaitedEnd(const AwaitedEnd&) = delete;
  AwaitedEnd& operator=(const AwaitedEnd&) = delete;
  ~AwaitedEnd() {
    for (std::size_t i = 0; i < std::size(signals); ++i) std::signal(signals[i], former_[i]);
    if (const int signal = asked.exchange(0)) std::raise(signal);
  }
  static bool is_asked() { return asked != 0; }

 private:
  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
  static inline std::atomic<int> asked{0};
  void (*former_[std::size(signals)])(int);
};

// Returns how the program ended; empty for exit status 0.
std::string bad_end(int wait_status) {
  if (WIFSIGNALED(wait_status))
    return fmt::format("killed by signal {} ({})", WTERMSIG(wait_status),
                       strsignal(WTERMSIG(wait_status)));
  const int status = WEXITSTATUS(wait_status);
  return status == 0 ? "" : fmt::format("exit status {}", status);
}

}  // namespace

void run_program(const ProgramStart& start) {
  const AwaitedEnd end;
  const auto fail = [&](const std::string& how) {
    throw program_failure(start.command.front() + ": " + how, start.log);
  };
  ChildSettings settings{.log_file = start.log, .directory = start.directory};
  if (start.cores) {
    const int allowed = static_cast<int>(allowed_cores().size());
    if (*start.cores > allowed)
      throw SolverError(fmt::format("cores = {}: expected at most the {} that this process may use",
                                    *start.cores, allowed));
    settings.cores = *start.cores;
    settings.environment["OMP_NUM_THREADS"] = std::to_string(*start.cores);
  }
  try {
    ChildProcess child(start.command, settings);
    while (!child.is_over()) {
      if (AwaitedEnd::is_asked()) {
        child.terminate();
        for (auto waited = 0ms; waited < grace && !child.is_over(); waited += poll_interval)
          std::this_thread::sleep_for(poll_interval);
        fail("interrupted");
      }
      if (start.time_limit && child.wall_time() > *start.time_limit) {
        child.terminate();
        while (!child.is_over()) std::this_thread::sleep_for(poll_interval);
        fail(fmt::format("did not end within its time_limit_s = {}", *start.time_limit));
      }
      std::this_thread::sleep_for(poll_interval);
    }
    if (const std::string how = bad_end(child.wait_status()); !how.empty()) fail(how);
  } catch (const std::system_error& error) {
    fail(std::string("cannot be started: ") + error.what());
  }
}

namespace {

// Splits a line at its carriage returns, which a progress bar writes, and cuts what is still longer
// than `longest` letters into overlapping pieces.
std::vector<std::string> parts_of(const std::string& line, std::size_t longest) {
  const std::size_t overlap = longest / 10;
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string shown; std::getline(stream, shown, '\r');)
    for (std::size_t at = 0; at == 0 || at + overlap < shown.size(); at += longest - overlap)
      parts.push_back(shown.substr(at, longest));
  return parts;
}

// Returns the end of a long line, which is what the program wrote last.
std::string shortened(const std::string& line) {
  constexpr std::size_t quoted = 200;
  const std::string text(trimmed(line));
  return text.size() > quoted ? "..." + text.substr(text.size() - quoted) : text;
}

}  // namespace

void require_no_match(const std::vector<std::string>& fail_on, const fs::path& log) {
  // The library's search takes stack for each letter of a line.
  constexpr std::size_t longest = 10000;
  std::vector<std::regex> patterns;
  for (const std::string& text : fail_on) patterns.emplace_back(text);
  std::ifstream stream(log);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
    for (const std::string& part : parts_of(line, longest))
      for (std::size_t i = 0; i < patterns.size(); ++i)
        if (std::regex_search(part, patterns[i]))
          throw program_failure(fmt::format("line {} of its log matches fail_on = \"{}\": {}",
                                            number, fail_on[i], shortened(part)),
                                log);
}

SolverError program_failure(const std::string& what, const fs::path& log) {
  constexpr std::size_t shown = 10;
  std::deque<std::string> lines;
  std::ifstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    if (!trimmed(line).empty()) lines.push_back(shortened(line));
    if (lines.size() > shown) lines.pop_front();
  }
  const std::string last = lines.empty() ? "it said nothing" : "its last words: " + lines.back();
  return SolverError({"solver failed", fmt::format("{}; {}", what, last),
                      fmt::format("{}", fmt::join(lines, "\n")), log.string()});
}

}  // namespace slosh
