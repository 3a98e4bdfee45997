#include "verification/sensitivity/known_strengths.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "verification/files/atomic_file.hpp"
#include "verification/files/content_hash.hpp"
#include "verification/sensitivity/case_coverage.hpp"

namespace slosh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int format_version = 1;

json to_json(const GateStrength& strength) {
  json outcomes = json::array();
  for (const MutationOutcome& one : strength.outcomes)
    outcomes.push_back({static_cast<int>(one.mutation.kind), one.mutation.strength,
                        one.mutation.mode, one.claimed, one.detected, one.judged});
  return {strength.passes_as_it_is, std::move(outcomes)};
}

// Throws json::exception for what to_json() has not made.
GateStrength strength_of(const json& kept) {
  GateStrength strength{kept.at(0), {}};
  for (const json& one : kept.at(1))
    strength.outcomes.push_back(
        {{static_cast<MutationKind>(one.at(0).get<int>()), one.at(1), one.at(2)},
         one.at(3),
         one.at(4),
         one.at(5)});
  return strength;
}

std::map<std::string, GateStrength> strengths_in(const fs::path& file) try {
  std::map<std::string, GateStrength> strengths;
  if (!fs::is_regular_file(file)) return strengths;
  const json read = json::parse(read_bytes(file));
  if (read.at("format_version") != format_version) return strengths;
  for (const auto& [key, kept] : read.at("strengths").items()) strengths[key] = strength_of(kept);
  return strengths;
} catch (const json::exception&) {
  return {};  // they are found out again
}

// From each line "[[gate]]" to the next line that begins another table.
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

class Evidence {
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
  }
  std::string digits() const { return hash_.digits(); }

 private:
  ContentHash hash_;
};

// A regression row has other uncertainties than a validation row.
std::string key_of_row(const GateRow& row) {
  return fmt::format("{}kind {}\n", bound_text(row), static_cast<int>(row.kind));
}

}  // namespace

KnownStrengths::KnownStrengths(fs::path file, std::string judge)
    : file_(std::move(file)), judge_(std::move(judge)), read_(strengths_in(file_)) {}

std::string KnownStrengths::evidence_of(const CaseAssessment& assessment) const {
  Evidence evidence;
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
  }
  return evidence.digits();
}

std::optional<GateStrength> KnownStrengths::find(const std::string& evidence,
                                                 const GateRow& row) const {
  const auto found = read_.find(evidence + key_of_row(row));
  return found == read_.end() ? std::nullopt : std::optional(found->second);
}

void KnownStrengths::keep(const std::string& evidence, const GateRow& row,
                          const GateStrength& strength) {
  const std::lock_guard lock(mutex_);
  kept_[evidence + key_of_row(row)] = strength;
}

void KnownStrengths::write() const {
  json strengths = json::object();
  for (const auto& [key, strength] : kept_) strengths[key] = to_json(strength);
  const json all{{"format_version", format_version}, {"strengths", std::move(strengths)}};
  replace_file(file_, all.dump(-1, ' ', false, json::error_handler_t::replace),
               Durability::process_crash);
}

}  // namespace slosh
