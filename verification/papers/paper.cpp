#include "verification/papers/paper.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace slosh {

using Json = nlohmann::json;

NLOHMANN_JSON_SERIALIZE_ENUM(Redrawn, {{Redrawn::history, "history"},
                                       {Redrawn::spectrum, "spectrum"},
                                       {Redrawn::time_steps, "time_steps"},
                                       {Redrawn::spacings, "spacings"},
                                       {Redrawn::fields, "fields"},
                                       {Redrawn::not_at_all, "not_at_all"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Measure, {{Measure::mean, "mean"},
                                       {Measure::fluctuation, "fluctuation"},
                                       {Measure::crest, "crest"},
                                       {Measure::trough, "trough"},
                                       {Measure::largest, "largest"},
                                       {Measure::noise, "noise"},
                                       {Measure::main_frequency, "main_frequency"},
                                       {Measure::first_frequency, "first_frequency"},
                                       {Measure::second_frequency, "second_frequency"},
                                       {Measure::first_power, "first_power"},
                                       {Measure::second_power, "second_power"},
                                       {Measure::power_ratio, "power_ratio"},
                                       {Measure::peak_distance, "peak_distance"},
                                       {Measure::time_distance, "time_distance"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Stage, {{Stage::steady, "steady"},
                                     {Stage::late, "late"},
                                     {Stage::first, "first"},
                                     {Stage::first_over_steady, "first_over_steady"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Relation, {{Relation::within, "within"},
                                        {Relation::at_least, "at_least"},
                                        {Relation::at_most, "at_most"},
                                        {Relation::within_factor, "within_factor"}})
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(PaperFigure, number, shows, redrawn, cases,
                                                quantities, time_span_s, without_dimensions,
                                                not_known)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Measured, quantity, measure, stage)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Threshold, relation, lower, upper)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(FindingRow, evidence, cases, runs, name, quantity,
                                                measures, thresholds, printed, by_finest_mesh_too,
                                                by_repeats)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Claim, number, statement, figures, printed,
                                                findings, rests_on, not_decidable)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Erratum, paper, correction, computed, figures)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Deviation, of, printed, here, why)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(Paper, name, citation, schemes, particle_spacing_m,
                                                text, figures, claims, errata, deviations)

namespace {

// Findings name their thresholds, which the file states once. They are set in.
Json read(const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(SLOSH_PAPERS) / (name + ".toml");
  if (!std::filesystem::exists(file)) throw std::invalid_argument("no paper has the name " + name);
  try {
    std::ostringstream text;
    text << toml::json_formatter{toml::parse_file(file.string())};
    Json json = Json::parse(text.str());
    for (Json& claim : json.at("claims"))
      if (claim.contains("findings"))
        for (Json& finding : claim["findings"])
          for (Json& threshold : finding.at("thresholds"))
            threshold = json.at("thresholds").at(threshold.get<std::string>());
    json.erase("thresholds");
    return json;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace

const Paper& paper_named(const std::string& name) {
  static std::map<std::string, Paper> papers;
  const auto found = papers.find(name);
  return found != papers.end() ? found->second
                               : papers.emplace(name, read(name).get<Paper>()).first->second;
}

std::pair<std::string, std::string> file_and_paper(const std::string& name) {
  return {read(name).dump(), Json(paper_named(name)).dump()};
}

}  // namespace slosh
