#include "verification/campaign/job_log.hpp"

#include <fstream>
#include <string_view>

namespace slosh {

std::string complaint_in(const std::filesystem::path& log) {
  constexpr std::string_view mark = "slosh: ";  // main.cpp puts it before every error
  std::ifstream stream(log);
  std::string line, last;
  while (std::getline(stream, line)) {
    if (line.starts_with(mark)) return line.substr(mark.size());
    if (!line.empty()) last = line;
  }
  return last.empty() ? "nothing is in its log " + log.string() : last;
}

}  // namespace slosh
