#include "verification/results/result_seals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "verification/files/result_error.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;

// Longer than any seal. Returns an empty text where the file cannot be read.
std::string end_of(const fs::path& file) {
  constexpr std::uintmax_t length = 80;  // [byte]
  std::error_code absent;
  const std::uintmax_t size = fs::file_size(file, absent);
  if (absent) return "";
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(size - std::min(size, length)));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

ResultSeals::ResultSeals(const std::vector<fs::path>& files) {
  for (const fs::path& file : files)
    if (std::string seal = end_of(file); !seal.empty()) seals_[file] = std::move(seal);
}

void ResultSeals::require_unchanged() const {
  std::vector<std::string> changed;
  for (const auto& [file, seal] : seals_)
    if (fs::exists(file) && end_of(file) != seal) {
      changed.push_back(file.string());
      fs::remove_all(file);
    }
  if (!changed.empty())
    throw ResultError(
        fmt::format("a program of the user's has changed {} results of the store: {}; they are "
                    "removed, and nothing is judged",
                    changed.size(), fmt::join(changed, ", ")));
}

}  // namespace slosh
