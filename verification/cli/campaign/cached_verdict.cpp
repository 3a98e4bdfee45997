#include "verification/cli/campaign/cached_verdict.hpp"

#include <iostream>
#include <nlohmann/json.hpp>

#include "verification/campaign/campaign_plan.hpp"
#include "verification/campaign/problem_run.hpp"
#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* file_name = "standing.json";

// Returns the path and the hash of the file, or null if it is absent or cannot be read.
json content_of(const fs::path& file) try {
  return {file.string(), content_hash(read_bytes(file))};
} catch (const fs::filesystem_error&) {
  return nullptr;
}

// Returns the content of each file of the report by its name there.
json report_in(const fs::path& directory) {
  json files = json::object();
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(directory).string()] = content_of(entry.path());
  return files;
}

// Whether these files are there, and nobody has edited them. Others beside them do not count.
bool stands(const json& files, const fs::path& directory) {
  for (const auto& [name, content] : files.items())
    if (content.is_null() || content_of(directory / name) != content) return false;
  return !files.empty();
}

}  // namespace

std::optional<std::string> fingerprint_of(const CampaignDefinition& campaign,
                                          const std::vector<CaseDefinition>& cases,
                                          const CampaignSettings& settings,
                                          const std::string& judge) {
  json all{{"campaign", campaign.text},
           {"selection", selection_options(settings.selection)},
           {"experiments", settings.experiments.string()},
           {"place", settings.output.string()},
           {"judge", judge},
           {"cases", json::array()},
           {"results", json::array()}};
  for (const CaseDefinition& one : cases) {
    all["cases"].push_back(one.text);
    if (one.impacts) all["cases"].push_back(content_of(one.impacts->peak_table));
  }
  for (const PlannedRun& planned : plan_runs(cases, settings)) {
    if (is_pending(planned) || !timing_jobs(planned, settings).empty()) return std::nullopt;
    all["results"].push_back({static_cast<int>(planned.status.state), planned.status.message});
    if (planned.status.state != RunState::finished) continue;
    all["results"].push_back(content_of(planned.file));
    all["results"].push_back(content_of(settings.store.file(planned.key, ".timings.json")));
  }
  for (const ProblemDefinition& problem : campaign.problems) {
    const ProblemRun run = standing_problem(problem, settings);
    if (run.status.state == RunState::missing) return std::nullopt;
    all["results"].push_back({static_cast<int>(run.status.state), run.status.message});
    if (run.result)
      all["results"].push_back(content_of(settings.store.file(run.result->key, ".json")));
  }
  return content_hash(all.dump(-1, ' ', false, json::error_handler_t::replace));
}

std::optional<CachedVerdict> read_cached_verdict(const fs::path& output) {
  const fs::path file = output / file_name;
  if (!fs::is_regular_file(file)) return std::nullopt;
  const json read = json::parse(read_bytes(file), nullptr, false);
  const auto has = [&](const char* key, json::value_t type) {
    return read.is_object() && read.contains(key) && read.at(key).type() == type;
  };
  if (has("fingerprint", json::value_t::string) && has("out", json::value_t::string) &&
      has("status", json::value_t::number_unsigned) && has("report", json::value_t::object)) {
    if (!stands(read.at("report"), output / "report")) return std::nullopt;
    return CachedVerdict{read.at("fingerprint"), read.at("status"), read.at("out")};
  }
  std::cerr << file.string() << ": no verdict of an earlier start can be read from it; the results "
            << "are judged again\n";
  return std::nullopt;
}

void forget_cached_verdict(const fs::path& output) { fs::remove(output / file_name); }

void write_cached_verdict(const CachedVerdict& cached, const fs::path& output) {
  const json all{{"fingerprint", cached.fingerprint},
                 {"status", cached.status},
                 {"out", cached.out},
                 {"report", report_in(output / "report")}};
  replace_file(output / file_name, all.dump(1, ' ', false, json::error_handler_t::replace),
               Durability::process_crash);
}

}  // namespace slosh
