// Whole text files, with errors that name the file, and a directory for temporary ones.
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <future>
#include <string>
#include <vector>

namespace slosh::reports {

// Runs independent pieces of work on several threads.

// Calls work(i) once for each i from 0 to count - 1, on the given number of threads. Rethrows what
// a piece of work throws after all threads have ended.
template <class Work>
void side_by_side(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < threads; ++i) workers.push_back(std::async(std::launch::async, take_turns));
  for (std::future<void>& worker : workers) worker.wait();
  for (std::future<void>& worker : workers) worker.get();
}

// Comma-separated values, Base64, and what complete PNG and GIF files look like.

// A line of comma-separated values (RFC 4180, except that lines end in "\n" alone) with its line
// end, the same in any locale. A cell with a comma, a quote or a line break is quoted.
std::string csv_line(const std::vector<std::string>& cells);

// The shortest text that reads as the same number; empty for NaN.
std::string csv_number(double value);

// The bytes as text (RFC 4648, section 4).
std::string base64(const std::string& bytes);

// Whether the bytes have the signature and the last chunk of every PNG file (PNG specification,
// 5.2 and 11.2.5).
bool is_whole_png(const std::string& bytes);

// Whether the bytes have the signature and the trailer of every GIF file (GIF89a specification, 17
// and 27).
bool is_whole_gif(const std::string& bytes);

// Both throw ReportError with the path and the system's reason.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, const std::string& text);

// A new directory, which is removed with the object.
class TemporaryDirectory {
 public:
  // Its path is `name_start` and six letters. Throws ReportError where it cannot be made.
  explicit TemporaryDirectory(const std::string& name_start);
  ~TemporaryDirectory();
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace slosh::reports
