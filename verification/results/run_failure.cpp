#include "verification/results/run_failure.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/foreign/json_text.hpp"
#include "verification/files/sealed_json.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {
namespace {

constexpr const char* failure_format = "slosh failure";

std::string text_of(const RunFailure& failure) {
  return failure.message + (failure.log.empty() ? "" : " (" + failure.log + ")") +
         (failure.details.empty() ? "" : "\n" + failure.details);
}

}  // namespace

SolverError::SolverError(const RunFailure& why) : std::runtime_error(text_of(why)), failure(why) {}

void write_failure(const RunFailure& failure, const std::filesystem::path& file) {
  write_sealed_json({{"format", failure_format},
                     {"kind", failure.kind},
                     {"message", failure.message},
                     {"details", failure.details},
                     {"log", failure.log}},
                    file);
}

std::optional<RunFailure> read_failure(const std::filesystem::path& file) try {
  if (!std::filesystem::exists(std::filesystem::symlink_status(file))) return std::nullopt;
  const nlohmann::json body = read_sealed_json(failure_format, file);
  return RunFailure{body.at("kind"), body.at("message"), body.at("details"), body.at("log")};
} catch (const ResultError& error) {
  return RunFailure{"error", error.what(), "", ""};
} catch (const nlohmann::json::exception& error) {
  return RunFailure{"error", file.string() + ": " + words_of(error), "", ""};
}

}  // namespace slosh
