#include "verification/solvers/external_program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <re2/re2.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <fstream>
#include <memory>
#include <thread>

#include "verification/files/child_process.hpp"
#include "verification/files/foreign/legible_text.hpp"
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

// A program may leave a link or a pipe in the place of its log.
bool is_log(const fs::path& file) { return fs::is_regular_file(fs::symlink_status(file)); }

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
    std::uintmax_t longest = 0;  // of its log, in which fail_on looks
    const auto watch_log = [&] {
      std::error_code gone;
      const std::uintmax_t size = fs::file_size(start.log, gone);
      if (!gone && size < longest) fail("made its own log shorter");
      if (!gone) longest = size;
    };
    while (!child.is_over()) {
      watch_log();
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
    if (!is_log(start.log)) fail("left something else in the place of its log");
    watch_log();
  } catch (const std::system_error& error) {
    fail(std::string("cannot be started: ") + error.what());
  }
}

namespace {

// A log piece by piece: its lines, parted at carriage returns too, which a progress bar writes.
// What is longer than `longest` letters comes in pieces that overlap. What is no log is empty.
class LogPieces {
 public:
  explicit LogPieces(const fs::path& log) {
    if (is_log(log)) stream_.open(log, std::ios::binary);
  }

  bool next() {
    constexpr std::size_t longest = 1 << 16, overlap = longest / 10;
    line_ += end_ == '\n';
    text_.erase(0, end_ == cut ? text_.size() - overlap : text_.size());
    const std::size_t old = text_.size();
    for (end_ = cut; text_.size() < longest; text_ += static_cast<char>(end_), end_ = cut) {
      end_ = stream_.rdbuf()->sbumpc();
      if (end_ == '\n' || end_ == '\r') return true;
      if (end_ == EOF) return text_.size() > old;
    }
    return true;
  }
  const std::string& text() const { return text_; }
  int line() const { return line_; }

 private:
  static constexpr int cut = -2;
  std::ifstream stream_;
  std::string text_;
  int line_ = 1, end_ = '\r';
};

// Returns the end of a long line, which is what the program wrote last.
std::string shortened(const std::string& line) {
  constexpr std::size_t quoted = 200;
  const std::string text(trimmed(line));
  return text.size() > quoted ? "..." + text.substr(text.size() - quoted) : text;
}

}  // namespace

void require_no_match(const std::vector<std::string>& fail_on, const fs::path& log) {
  std::vector<std::unique_ptr<RE2>> patterns;
  for (const std::string& text : fail_on)
    patterns.push_back(std::make_unique<RE2>(text, RE2::Quiet));
  for (LogPieces log_now(log); !patterns.empty() && log_now.next();)
    // As a terminal shows the line too: colours and other letters stand between the words.
    for (const std::string shown = legible(log_now.text()); const auto& pattern : patterns)
      if (RE2::PartialMatch(log_now.text(), *pattern) || RE2::PartialMatch(shown, *pattern))
        throw program_failure(
            fmt::format("line {} of its log matches fail_on = \"{}\": {}", log_now.line(),
                        pattern->pattern(), shortened(log_now.text())),
            log);
}

SolverError program_failure(const std::string& what, const fs::path& log) {
  constexpr std::size_t shown = 10;
  std::deque<std::string> lines;
  for (LogPieces piece(log); piece.next();) {
    if (!trimmed(piece.text()).empty()) lines.push_back(shortened(piece.text()));
    if (lines.size() > shown) lines.pop_front();
  }
  const std::string last = lines.empty() ? "it said nothing" : "its last words: " + lines.back();
  return SolverError({"solver failed", fmt::format("{}; {}", what, last),
                      fmt::format("{}", fmt::join(lines, "\n")), log.string()});
}

}  // namespace slosh
