#include "verification/results/progress_file.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/protected_inputs.hpp"

namespace slosh {

void write_progress(const RunProgress& progress, const std::filesystem::path& file) {
  const nlohmann::json document{
      {"time_s", progress.time}, {"end_time_s", progress.end_time}, {"steps", progress.steps}};
  replace_file(file, document.dump() + "\n", Durability::process_crash);
}

void require_progress_place(const std::filesystem::path& file) {
  require_no_input(file);
  std::error_code absent;
  const bool holds_text =
      std::filesystem::is_regular_file(file, absent) && !std::filesystem::is_empty(file, absent);
  if (holds_text && !read_progress(file))
    throw std::filesystem::filesystem_error(
        "will not replace what is no progress of a run; expected another place", file,
        std::make_error_code(std::errc::file_exists));
}

std::optional<RunProgress> read_progress(const std::filesystem::path& file) try {
  const auto document = parsed_json<nlohmann::json>(read_bytes(file));
  return RunProgress{.time = document.at("time_s"),
                     .end_time = document.at("end_time_s"),
                     .steps = document.at("steps")};
} catch (const std::exception&) {  // absent or not readable
  return std::nullopt;
}

}  // namespace slosh
