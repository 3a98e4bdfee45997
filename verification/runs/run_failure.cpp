#include "verification/runs/run_failure.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/sealed_json.hpp"
#include "verification/runs/result_file.hpp"

namespace slosh {
namespace {

constexpr const char* format = "slosh failure";

}  // namespace

void write_failure(const RunFailure& failure, const std::filesystem::path& file) {
  write_sealed_json({{"format", format},
                     {"kind", failure.kind},
                     {"message", failure.message},
                     {"details", failure.details},
                     {"log", failure.log}},
                    file);
}

std::optional<RunFailure> read_failure(const std::filesystem::path& file) try {
  const nlohmann::json body = read_sealed_json(format, file);
  return RunFailure{body.at("kind"), body.at("message"), body.at("details"), body.at("log")};
} catch (const ResultError&) {
  return std::nullopt;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

}  // namespace slosh
