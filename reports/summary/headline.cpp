#include "reports/summary/headline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/summary/verdict_matrix.hpp"
#include "reports/wording/case_text.hpp"
#include "reports/wording/report_places.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

// A judged row of a case and how tables show it.
struct JudgedRow {
  const GateRow* row;
  ShownRow shown;
};

using RowsOfCodes = std::vector<std::pair<std::string, std::vector<JudgedRow>>>;

std::string code_of(const RunDefinition& run) {
  return std::holds_alternative<SphRun>(run.solver) ? "SPH" : family(run);
}

bool compares(const GateRow& row) { return !row.reference.empty(); }

// By code, in the order of the rows, but OpenFOAM's last, as it is the reference of most; of each
// code the worst row first.
RowsOfCodes rows_of_codes(const CaseAssessment& assessment) {
  RowsOfCodes codes;
  const std::vector<ShownRow> shown = shown_rows(assessment);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const GateRow& row = assessment.gate[i].row;
    if (!shown[i].counts()) continue;
    const std::string code = code_of(run_named(assessment.definition, row.candidate));
    auto found = std::find_if(codes.begin(), codes.end(),
                              [&](const auto& one) { return one.first == code; });
    if (found == codes.end()) found = codes.insert(found, {code, {}});
    found->second.push_back({&row, shown[i]});
  }
  std::stable_partition(codes.begin(), codes.end(),
                        [](const auto& one) { return !one.second.front().shown.of_mesh; });
  for (auto& [code, rows] : codes)
    std::stable_sort(rows.begin(), rows.end(), [](const JudgedRow& one, const JudgedRow& other) {
      return is_worse(one.shown, other.shown);
    });
  return codes;
}

// The row whose run and reference the line shows.
const GateRow& featured(const CaseDefinition& definition, const std::vector<JudgedRow>& rows) {
  const JudgedRow& worst = rows.front();
  if (worst.shown.verdict != Verdict::pass) return *worst.row;
  const auto rank = [&](const JudgedRow& one) {
    return std::tuple(compares(*one.row), one.row->kind == RowKind::validation,
                      resolution(run_named(definition, one.row->candidate)));
  };
  return *std::max_element(rows.begin(), rows.end(), [&](const auto& one, const auto& other) {
            return rank(one) < rank(other);
          })->row;
}

// Of rows that all pass.
std::string standing_of_passing(bool any_validates, bool any_watches) {
  return any_validates ? "validated" : any_watches ? "watched, not validated" : "limits kept";
}

std::string standing_name(const std::vector<JudgedRow>& rows) {
  if (rows.front().shown.verdict != Verdict::pass) return verdict_name(rows.front().shown.verdict);
  bool validates = false, watches = false;
  for (const JudgedRow& one : rows) {
    validates |= !one.shown.regression && compares(*one.row);
    watches |= one.shown.regression;
  }
  return standing_of_passing(validates, watches);
}

// The value of the code's row on the metric between the same runs; "" where it has none.
std::string judged_value(const std::vector<JudgedRow>& rows, const GateRow& pair, Metric metric,
                         const std::string& mode) {
  for (const JudgedRow& one : rows)
    if (one.row->candidate == pair.candidate && one.row->reference == pair.reference &&
        one.row->quantity == pair.quantity && one.row->metric == metric && one.row->mode == mode &&
        !one.row->improves_on)
      return one.shown.found;
  return "";
}

std::string found_or(const std::string& judged, const Estimate& compared, const char* unit) {
  if (!judged.empty() || !std::isfinite(compared.value)) return judged;
  return with_interval(compared, unit);
}

// What a row judges is shown as it is judged; the rest as the runs compare.
void add_numbers(const CaseAssessment& assessment, const std::vector<JudgedRow>& rows,
                 const GateRow& pair, HeadlineLine& line) {
  if (!compares(pair)) return;
  const Comparison* found = nullptr;
  for (const Comparison& one : assessment.comparisons)
    if (one.candidate == pair.candidate && one.reference == pair.reference &&
        one.quantity == pair.quantity)
      found = &one;
  const auto fitted = assessment.fitted.of.find({pair.candidate, pair.reference, pair.quantity});
  if (!found && fitted != assessment.fitted.of.end()) found = &fitted->second;
  const ModeComparison* mode = nullptr;
  if (found)
    for (const ModeComparison& one : found->modes)
      if (!mode && one.resolved()) mode = &one;
  const Estimate none{not_a_number, not_a_number};
  const std::string name = mode ? mode->mode : "forced";
  line.amplitude = found_or(judged_value(rows, pair, Metric::amplitude_error, name),
                            mode ? mode->amplitude_error : none, "1");
  const std::string lag = judged_value(rows, pair, Metric::cross_correlation_lag, "whole");
  line.lag = lag.empty() ? found_or(judged_value(rows, pair, Metric::phase_lag, name),
                                    mode ? mode->phase_lag_degrees : none, "deg")
                         : lag;
  line.rms = found_or(judged_value(rows, pair, Metric::normalised_rms, "whole"),
                      found ? found->normalised_rms : none, "1");
}

// The worst row, or of rows that pass the one nearest to its limit.
const ShownRow& deciding(const std::vector<JudgedRow>& rows) {
  const auto nearest = std::find_if(
      rows.begin(), rows.end(), [](const JudgedRow& one) { return one.shown.share.has_value(); });
  return rows.front().shown.verdict == Verdict::pass && nearest != rows.end() ? nearest->shown
                                                                              : rows.front().shown;
}

HeadlineLine line_of(const CaseAssessment& assessment, const std::vector<JudgedRow>& rows) {
  const CaseDefinition& definition = assessment.definition;
  const GateRow& pair = featured(definition, rows);
  const ShownRow& decides = deciding(rows);
  HeadlineLine line{
      .name = definition.name,
      .verdict = rows.front().shown.verdict,
      .standing = standing_name(rows),
      .candidate = short_text(run_named(definition, pair.candidate)),
      .reference = compares(pair) ? short_text(run_named(definition, pair.reference)) : "",
      .amplitude = {},
      .lag = {},
      .rms = {},
      .decides = fmt::format("{}, {}: {}", decides.candidate, decides.metric_text, decides.message),
      .row_id = decides.row_id,
      .section = case_id(definition.name) + "-gate"};
  if (is_judged(line.verdict)) add_numbers(assessment, rows, pair, line);
  return line;
}

// A problem has no run of a code but one of SPH.
void add_problem(const ProblemAssessment& assessment, std::vector<HeadlineLine>& lines) {
  std::vector<ShownRow> rows = shown_rows({assessment});
  std::erase_if(rows, [](const ShownRow& row) { return !row.counts(); });
  if (rows.empty()) return;
  const ShownRow& worst = *std::min_element(rows.begin(), rows.end(), is_worse);
  const bool validates =
      std::any_of(rows.begin(), rows.end(), [](const ShownRow& row) { return !row.regression; });
  lines.push_back(
      {.name = worst.name,
       .verdict = worst.verdict,
       .standing = worst.verdict == Verdict::pass ? standing_of_passing(validates, !validates)
                                                  : verdict_name(worst.verdict),
       .candidate = "SPH",
       .reference = "the exact solution",
       .amplitude = {},
       .lag = {},
       .rms = {},
       .decides = fmt::format("{} of {}: {}", worst.metric_text, worst.candidate, worst.message),
       .row_id = worst.row_id,
       .section = "problem-" + worst.name});
}

template <class Assessment>
int count(const std::vector<Assessment>& assessed, Verdict verdict) {
  int n = 0;
  for (const Assessment& one : assessed)
    for (const auto& outcome : one.gate) n += outcome.verdict == verdict;
  return n;
}

int count(const std::vector<CaseAssessment>& cases, const std::vector<ProblemAssessment>& problems,
          RunState state) {
  int n = 0;
  for (const ProblemAssessment& one : problems) n += one.run.status.state == state;
  for (const CaseAssessment& one : cases)
    for (const auto& [run, status] : one.runs.status) n += status.state == state;
  return n;
}

int pairs_not_comparable(const std::vector<CaseAssessment>& cases) {
  int n = 0;
  for (const CaseAssessment& one : cases) n += static_cast<int>(one.not_comparable.size());
  return n;
}

}  // namespace

std::vector<HeadlineLine> headline_lines(const std::vector<CaseAssessment>& cases,
                                         const std::vector<ProblemAssessment>& problems) {
  std::vector<HeadlineLine> lines;
  for (const CaseAssessment& one : cases)
    for (const auto& [code, rows] : rows_of_codes(one)) lines.push_back(line_of(one, rows));
  for (const ProblemAssessment& one : problems) add_problem(one, lines);
  return lines;
}

bool is_only_watched(const std::vector<CaseAssessment>& cases,
                     const std::vector<ProblemAssessment>& problems) {
  const std::vector<HeadlineLine> lines = headline_lines(cases, problems);
  const auto is = [](const char* standing) {
    return [=](const HeadlineLine& line) { return line.standing == standing; };
  };
  return exit_status(cases, problems) == exit_pass &&
         std::any_of(lines.begin(), lines.end(), is("watched, not validated")) &&
         std::none_of(lines.begin(), lines.end(), is("validated"));
}

bool has_numbers(const HeadlineLine& line) {
  return !line.amplitude.empty() || !line.lag.empty() || !line.rms.empty();
}

std::string line_text(const HeadlineLine& line) {
  std::vector<std::string> numbers;
  for (const auto& [what, value] :
       {std::pair{"amplitude", line.amplitude}, {"lag", line.lag}, {"rms", line.rms}})
    if (!value.empty()) numbers.push_back(fmt::format("{} {}", what, value));
  if (!has_numbers(line)) numbers.push_back(line.decides);
  return fmt::format("{}{}: {}", line.candidate,
                     line.reference.empty() ? "" : " against " + line.reference,
                     fmt::join(numbers, ", "));
}

std::string verdict_sentence(const std::vector<CaseAssessment>& cases,
                             const std::vector<ProblemAssessment>& problems) {
  const auto rows = [&](Verdict verdict) {
    return count(cases, verdict) + count(problems, verdict);
  };
  const auto runs = [&](RunState state) { return count(cases, problems, state); };
  const int passed = rows(Verdict::pass);
  const int judged = passed + rows(Verdict::violated) + rows(Verdict::inconclusive) +
                     rows(Verdict::solver_failed) + rows(Verdict::not_compared);
  std::string text = fmt::format("{} of {} gate rows hold", passed, judged);
  const auto add = [&](int n, const char* one, const char* several = nullptr) {
    if (n > 0) text += fmt::format(", {} {}", n, n == 1 || !several ? one : several);
  };
  add(rows(Verdict::violated), "violated");
  add(rows(Verdict::inconclusive), "inconclusive");
  add(rows(Verdict::not_compared), "not compared");
  add(pairs_not_comparable(cases), "pair not comparable", "pairs not comparable");
  add(runs(RunState::failed), "run failed", "runs failed");
  add(runs(RunState::missing), "run without a result", "runs without a result");
  add(runs(RunState::not_supplied), "record not supplied", "records not supplied");
  add(rows(Verdict::not_supplied), "gate row without its record", "gate rows without their record");
  add(rows(Verdict::not_selected), "not selected");
  return text + ".";
}

std::string headline_sentence(const std::vector<CaseAssessment>& cases,
                              const std::vector<ProblemAssessment>& problems) {
  const std::vector<HeadlineLine> lines = headline_lines(cases, problems);
  if (lines.empty()) return verdict_sentence(cases, problems);
  const auto rank = [](const HeadlineLine& line) {
    return std::pair(severity(line.verdict), line.standing == "validated");
  };
  const HeadlineLine& first = *std::max_element(
      lines.begin(), lines.end(),
      [&](const auto& one, const auto& other) { return rank(one) < rank(other); });
  std::vector<std::string> texts{line_text(first)};
  for (const HeadlineLine& line : lines)
    if (line.name == first.name && line.row_id != first.row_id) texts.push_back(line_text(line));
  return fmt::format("{}.", fmt::join(texts, "; "));
}

std::string headline_word(int status, const std::vector<CaseAssessment>& cases,
                          const std::vector<ProblemAssessment>& problems) {
  const bool is_watched = status == exit_pass && is_only_watched(cases, problems);
  return is_watched ? "WATCHED, NOT VALIDATED" : headline_word(status);
}

reports::Table headline_table(const std::vector<HeadlineLine>& lines) {
  reports::Table table{
      "headline",
      "Departures, case by case",
      "A line for each case and code: its finest run that a row compares, or the one that a row "
      "objects to. Intervals are of 95 %. A case with regression rows alone is watched: it departs "
      "no further than earlier, which validates nothing.",
      {"case", "candidate", "reference", "amplitude", "lag", "rms", "standing", "decides"},
      {}};
  for (const HeadlineLine& line : lines) {
    table.rows.push_back({line.name, line.candidate, line.reference, line.amplitude, line.lag,
                          line.rms, line.standing, line.decides});
    table.links.push_back(
        {"section-" + line.section, "", "", "", "", "", "", "row-" + line.row_id});
  }
  return table;
}

std::string speed_sentence(const std::vector<CaseAssessment>& cases) {
  for (const CaseAssessment& one : cases) {
    std::vector<std::string> texts;
    for (const EqualErrorSpeed& speed : equal_error_speeds(one)) texts.push_back(speed_text(speed));
    if (!texts.empty()) return fmt::format("{}: {}.", one.definition.name, fmt::join(texts, "; "));
  }
  return "";
}

}  // namespace slosh
