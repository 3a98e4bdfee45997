#include "openfoam_cases/errors.hpp"

#include <fmt/format.h>

namespace slosh::openfoam {
namespace {

std::string text_of(const std::string& message, const std::filesystem::path& log,
                    const std::string& lines) {
  return message + (log.empty() ? "" : " (" + log.string() + ")") +
         (lines.empty() ? "" : "\n" + lines);
}

}  // namespace

void require(bool condition, const char* key, double value, const std::string& expected) {
  if (!condition) {
    throw std::invalid_argument(
        fmt::format("OpenFOAM tank: {} = {}: expected {}", key, value, expected));
  }
}

RunError::RunError(const std::string& what_went_wrong, const std::filesystem::path& log_file,
                   const std::string& lines)
    : std::runtime_error(text_of(what_went_wrong, log_file, lines)),
      message(what_went_wrong),
      log(log_file),
      words(lines) {}

void refuse(const std::filesystem::path& file, const std::string& what) {
  throw RunError(fmt::format("interFoam: {}: {}", file.string(), what));
}

}  // namespace slosh::openfoam
