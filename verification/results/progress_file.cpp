#include "verification/results/progress_file.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "verification/files/atomic_file.hpp"

namespace slosh {

void write_progress(const RunProgress& progress, const std::filesystem::path& file) {
  const nlohmann::json document{
      {"time_s", progress.time}, {"end_time_s", progress.end_time}, {"steps", progress.steps}};
  replace_file(file, document.dump() + "\n", Durability::process_crash);
}

std::optional<RunProgress> read_progress(const std::filesystem::path& file) try {
  std::ifstream stream(file);
  const nlohmann::json document = nlohmann::json::parse(stream);
  return RunProgress{.time = document.at("time_s"),
                     .end_time = document.at("end_time_s"),
                     .steps = document.at("steps")};
} catch (const std::exception&) {  // absent or not readable
  return std::nullopt;
}

}  // namespace slosh
