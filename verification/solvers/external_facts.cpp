#include "verification/solvers/external_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/input/case_file_error.hpp"
#include "verification/input/nearest_name.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char *liquid_particles = "liquid_particles", *steps = "steps",
                     *version = "schema_version", *compile_wall = "compile_wall_time_s",
                     *compile_processor = "compile_processor_time_s";

json read_object(const fs::path& file) {
  if (!fs::exists(file))
    throw CaseFileError(file.string() + ": expected a file that the program writes");
  constexpr std::uintmax_t largest = 1'000'000;  // [byte], of some 20 numbers and texts
  if (fs::is_regular_file(file) && fs::file_size(file) > largest)
    throw CaseFileError(fmt::format("{}: {} bytes: expected at most {}", file.string(),
                                    fs::file_size(file), largest));
  try {
    json document = parsed_json<json>(read_bytes(file));
    if (!document.is_object()) throw CaseFileError(file.string() + ": expected a JSON object");
    return document;
  } catch (const json::exception& error) {
    throw CaseFileError(fmt::format("{}: not JSON: {}", file.string(), words_of(error)));
  } catch (const fs::filesystem_error& error) {
    throw CaseFileError(error.what());
  }
}

// Throws for a key that is neither the version's nor one of `facts`, and for another version.
void require_known_form(const json& document, const std::vector<std::string>& facts,
                        const fs::path& file) {
  std::vector<std::string> known{version};
  known.insert(known.end(), facts.begin(), facts.end());
  for (const auto& [key, value] : document.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw CaseFileError(fmt::format("{}: {} = {}: expected only these keys: {}{}", file.string(),
                                      key, value.dump(), fmt::join(known, ", "),
                                      nearest_text(key, known)));
  const auto written = document.find(version);
  if (written == document.end() || *written != 1)
    throw CaseFileError(fmt::format("{}: {} = {}: expected 1", file.string(), version,
                                    written == document.end() ? "(missing)" : written->dump()));
}

void keep(const ExternalFact& fact, double value, RunResult& result) {
  if (fact.name == liquid_particles)
    result.cost.elements = value;
  else if (fact.name == steps)
    result.cost.steps = value;
  else
    result.diagnostics[fact.name] = value;
}

// Returns nullopt where the program does not know it.
std::optional<double> value_of(const ExternalFact& fact, const json& document,
                               const fs::path& file) {
  const auto found = document.find(fact.name);
  if (found == document.end() || found->is_null()) return {};
  const double value = found->is_number() ? found->get<double>() : -1;
  if (!std::isfinite(value) || (fact.is_count && value != std::floor(value)) || value < 0 ||
      (value == 0 && !fact.may_be_zero))
    throw CaseFileError(fmt::format(
        "{}: {} = {}: expected {} {} 0, or null where it is not known", file.string(), fact.name,
        found->dump(), fact.is_count ? "an integer" : "a number", fact.may_be_zero ? ">=" : ">"));
  return value;
}

// What a stored result must or may say beside the facts of a program.
constexpr const char *simulated_time = "simulated_time_s", *processor_time = "processor_time_s",
                     *wall_time = "wall_time_s", *remark = "remark";
constexpr const char* origins[] = {"software", "date", "machine"};

std::string text_of(const char* key, const json& document, const fs::path& file) {
  const auto found = document.find(key);
  if (found == document.end() || !found->is_string() || found->get<std::string>().empty())
    throw CaseFileError(fmt::format("{}: {} = {}: expected a text", file.string(), key,
                                    found == document.end() ? "(missing)" : found->dump()));
  return found->get<std::string>();
}

double time_of(const char* key, const json& document, const fs::path& file) {
  const auto value = value_of({key, false, false, ""}, document, file);
  if (!value)
    throw CaseFileError(
        fmt::format("{}: {} = (missing): expected a number > 0", file.string(), key));
  return *value;
}

bool is_of_compiling(const ExternalFact& fact) {
  return fact.name == compile_wall || fact.name == compile_processor;
}

// Whether the fact grows with the time that is simulated.
bool grows_with_time(const ExternalFact& fact) {
  return fact.name == steps || fact.name == "loop_wall_time_s" ||
         fact.name == "loop_processor_time_s";
}

}  // namespace

const std::vector<ExternalFact>& external_facts() {
  static const std::vector<ExternalFact> facts{
      {liquid_particles, true, false, "number of particles of the liquid"},
      {"wall_particles", true, true, "number of particles of the walls"},
      {steps, true, false, "number of time steps"},
      {"evaluations_per_step", true, false, "number of evaluations of the forces in a time step"},
      {"speed_of_sound_m_s", false, false, "speed of sound of the liquid"},
      {"smoothing_length_ratio", false, false, "smoothing length over particle spacing, h / dp"},
      {"loop_wall_time_s", false, false, "wall-clock time of the time loop, without set-up"},
      {"loop_processor_time_s", false, false,
       "processor time of the time loop on all cores, without set-up"},
      {compile_wall, false, true,
       "wall-clock time of compiling before the time loop, which counts as no run's"},
      {compile_processor, false, true,
       "processor time of compiling on all cores, which counts as no run's"}};
  return facts;
}

void add_external_facts(const fs::path& file, const RunCost& taken, RunResult& result) {
  const json document = read_object(file);
  std::vector<std::string> names;
  for (const ExternalFact& fact : external_facts()) names.push_back(fact.name);
  require_known_form(document, names, file);
  for (const ExternalFact& fact : external_facts()) {
    const auto value = value_of(fact, document, file);
    if (!value) continue;
    keep(fact, *value, result);
    const auto count_apart = [&](double whole, double& apart) {
      if (*value > whole)
        throw CaseFileError(
            fmt::format("{}: {} = {:.4g}: expected at most the {:.4g} s that the program took",
                        file.string(), fact.name, *value, whole));
      apart += *value;
    };
    if (fact.name == compile_wall) count_apart(taken.wall_time, result.cost.wall_time);
    if (fact.name == compile_processor) count_apart(taken.core_seconds(), result.cost.user_time);
  }
}

void add_stored_facts(const fs::path& file, double duration, RunResult& result) {
  const json document = read_object(file);
  std::vector<std::string> names{simulated_time, processor_time, wall_time, remark};
  names.insert(names.end(), std::begin(origins), std::end(origins));
  for (const ExternalFact& fact : external_facts())
    if (!is_of_compiling(fact)) names.push_back(fact.name);
  require_known_form(document, names, file);
  for (const char* origin : origins)
    result.provenance[std::string("stored_") + origin] = text_of(origin, document, file);
  if (document.contains(remark))
    result.provenance[std::string("stored_") + remark] = text_of(remark, document, file);
  const double simulated = time_of(simulated_time, document, file);
  if (simulated < duration)
    throw CaseFileError(fmt::format("{}: {} = {:g}: expected at least the case's {:g} s",
                                    file.string(), simulated_time, simulated, duration));
  const double share = duration / simulated;
  result.cost.user_time = share * time_of(processor_time, document, file);
  if (const auto wall = value_of({wall_time, false, false, ""}, document, file))
    result.cost.wall_time = share * *wall;
  for (const ExternalFact& fact : external_facts()) {
    if (is_of_compiling(fact)) continue;
    const auto value = value_of(fact, document, file);
    if (!value) continue;
    const double counted = grows_with_time(fact) ? share * *value : *value;
    keep(fact, fact.is_count ? std::round(counted) : counted, result);
  }
}

void add_imported(ImportedSeries imported, RunResult& result) {
  if (!imported.seams.empty())
    result.provenance[seams_of + imported.series.name] =
        fmt::format("{}", fmt::join(imported.seams, "; "));
  result.series.push_back(std::move(imported.series));
}

}  // namespace slosh
