#include "verification/sensitivity/sensitivity_cache.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int format_version = 1;

json to_json(const MutationTrials& trials) {
  json outcomes = json::array();
  for (const MutationOutcome& one : trials.outcomes)
    outcomes.push_back({static_cast<int>(one.mutation.kind), one.mutation.strength,
                        one.mutation.mode, one.claimed, one.detected, one.judged});
  return {trials.passes_as_it_is, std::move(outcomes)};
}

// Throws json::exception for anything that to_json() has not made.
MutationTrials trials_from(const json& kept) {
  MutationTrials trials{kept.at(0), {}};
  for (const json& one : kept.at(1))
    trials.outcomes.push_back(
        {{static_cast<MutationKind>(one.at(0).get<int>()), one.at(1), one.at(2)},
         one.at(3),
         one.at(4),
         one.at(5)});
  return trials;
}

std::map<std::string, MutationTrials> trials_in(const fs::path& file) try {
  std::map<std::string, MutationTrials> trials;
  if (!fs::is_regular_file(file)) return trials;
  const json read = parsed_json<json>(read_bytes(file));
  if (read.at("format_version") != format_version) return trials;
  for (const auto& [key, kept] : read.at("strengths").items()) trials[key] = trials_from(kept);
  return trials;
} catch (const json::exception&) {
  return {};  // the rows are tried again
}

// The text without its gate rows: each goes from a line "[[gate]]" to the next table.
std::string without_gate(const std::string& case_text) {
  std::istringstream lines(case_text);
  std::string rest;
  bool in_gate = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) in_gate = line.starts_with("[[gate]]");
    if (!in_gate) rest += line + '\n';
  }
  return rest;
}

class EvidenceHash {
 public:
  void add(const std::string& text) {
    add(static_cast<double>(text.size()));  // no text runs into the next
    hash_.add(text);
  }
  void add(double value) { hash_.add({reinterpret_cast<const char*>(&value), sizeof value}); }
  void add(const std::vector<double>& values) {
    add(static_cast<double>(values.size()));
    hash_.add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
  }
  void add(const RunCost& cost) {
    for (const double one : {cost.wall_time, cost.user_time, cost.system_time, cost.peak_memory,
                             cost.steps, cost.elements})
      add(one);
  }
  void add(const RunResult& result) {
    for (const std::string& text : {result.run_name, result.solver, result.key}) add(text);
    for (const auto& [name, value] : result.diagnostics) {
      add(name);
      add(value);
    }
    add(result.cost);
    for (const TimeSeries& series : result.series) {
      add(series.name);
      add(series.unit);
      add(series.time);
      add(series.value);
    }
    for (const FieldSnapshot& field : result.snapshots) {
      for (const double one : {field.time, field.width, field.height}) add(one);
      for (const std::vector<double>* values : {&field.x, &field.z, &field.pressure}) add(*values);
    }
  }
  std::string digits() const { return hash_.digits(); }

 private:
  ContentHash hash_;
};

// The kind counts because a regression row has other uncertainties than a validation row.
std::string key_of_row(const GateRow& row) {
  return fmt::format("{}kind {}\n", row_identity(row), static_cast<int>(row.kind));
}

}  // namespace

std::string row_identity(const GateRow& row) {
  std::string text = fmt::format("{}\n{}\n", row_name(row), row.unit);
  if (row.limit) text += fmt::format("limit {}\n", *row.limit);
  if (row.between) text += fmt::format("between {} {}\n", row.between->first, row.between->second);
  if (row.error) text += fmt::format("error {}\n", *row.error);
  return text;
}

SensitivityCache::SensitivityCache(fs::path file, std::string judge)
    : file_(std::move(file)), judge_(std::move(judge)), read_(trials_in(file_)) {}

std::string SensitivityCache::evidence_of(const CaseAssessment& assessment) const {
  EvidenceHash evidence;
  evidence.add(judge_);
  evidence.add(without_gate(assessment.definition.text));
  if (const auto& impacts = assessment.definition.impacts)
    for (const std::vector<double>& of_impact : impacts->repeats) evidence.add(of_impact);
  for (const auto& [run, status] : assessment.runs.status) {
    evidence.add(run);
    evidence.add(static_cast<double>(status.state));
  }
  for (const auto& [run, result] : assessment.runs.results) evidence.add(result);
  for (const auto& [run, timings] : assessment.runs.timings) {
    evidence.add(run);
    for (const RunCost& cost : timings) evidence.add(cost);
  }
  for (const auto& [input, bounds] : assessment.runs.input_bounds) {
    evidence.add(static_cast<double>(input));
    evidence.add(bounds.lower);
    evidence.add(bounds.upper);
    for (const RunResult& one : bounds.between) evidence.add(one);
  }
  return evidence.digits();
}

std::optional<MutationTrials> SensitivityCache::find(const std::string& evidence,
                                                     const GateRow& row) const {
  const auto found = read_.find(evidence + key_of_row(row));
  return found == read_.end() ? std::nullopt : std::optional(found->second);
}

void SensitivityCache::keep(const std::string& evidence, const GateRow& row,
                            const MutationTrials& trials) {
  const std::lock_guard lock(mutex_);
  kept_[evidence + key_of_row(row)] = trials;
}

void SensitivityCache::write() const {
  json strengths = json::object();
  for (const auto& [key, trials] : kept_) strengths[key] = to_json(trials);
  const json all{{"format_version", format_version}, {"strengths", std::move(strengths)}};
  replace_file(file_, all.dump(-1, ' ', false, json::error_handler_t::replace),
               Durability::process_crash);
}

}  // namespace slosh
