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

RunStatus status_without_result(const JobState& state) {
  const bool unkept = state.phase == JobPhase::exited && state.status == exit_not_compared;
  return {unkept ? RunState::missing : RunState::failed,
          description(state) + ": " + complaint_in(state.job.log_file)};
}

}  // namespace slosh
