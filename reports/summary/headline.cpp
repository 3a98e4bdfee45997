#include "reports/summary/headline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "reports/summary/shown_rows.hpp"
#include "reports/wording/case_text.hpp"
#include "verification/assessment/across_runs/speed_ups.hpp"
#include "verification/case/metric_table.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

constexpr std::size_t most_alone = 6;  // lines of rows without a reference

using RowsOfCode = std::vector<ShownRow>;  // those that count, the worst first

std::string code_of(const RunDefinition& run) {
  return std::holds_alternative<SphRun>(run.solver) ? "SPH" : family(run);
}

bool compares(const ShownRow& row) { return !row.outcome->row.reference.empty(); }

// By code, in the order of the rows, but OpenFOAM's last, as it is the reference of most.
std::vector<RowsOfCode> rows_of_codes(const CaseAssessment& assessment) {
  std::vector<RowsOfCode> codes;
  const auto code = [&](const ShownRow& row) {
    return code_of(run_named(assessment.definition, row.candidate));
  };
  for (const ShownRow& row : shown_rows(assessment)) {
    if (!row.counts()) continue;
    auto found = std::ranges::find(codes, code(row),
                                   [&](const RowsOfCode& rows) { return code(rows.front()); });
    if (found == codes.end()) found = codes.insert(found, RowsOfCode{});
    found->push_back(row);
  }
  std::ranges::stable_partition(codes,
                                [](const RowsOfCode& rows) { return !rows.front().of_mesh; });
  for (RowsOfCode& rows : codes) std::ranges::stable_sort(rows, is_worse);
  return codes;
}

// The row whose run and reference the line shows.
const GateRow& featured(const CaseDefinition& definition, const RowsOfCode& rows) {
  if (rows.front().verdict != Verdict::pass) return rows.front().outcome->row;
  const auto rank = [&](const ShownRow& one) {
    return std::tuple(compares(one), !one.regression,
                      resolution(run_named(definition, one.candidate)));
  };
  return std::ranges::max_element(rows, {}, rank)->outcome->row;
}

std::string standing_name(const RowsOfCode& rows) {
  if (rows.front().verdict != Verdict::pass) return verdict_name(rows.front().verdict);
  const bool validates = std::ranges::any_of(
      rows, [](const ShownRow& one) { return !one.regression && (!one.outcome || compares(one)); });
  const bool watches = std::ranges::any_of(rows, &ShownRow::regression);
  return validates ? "validated" : watches ? "watched, not validated" : "limits kept";
}

// The value of the code's row on the metric between the same runs; "" where it has none.
std::string judged_value(const RowsOfCode& rows, const GateRow& pair, Metric metric,
                         const std::string& mode) {
  for (const ShownRow& one : rows) {
    const GateRow& row = one.outcome->row;
    if (row.candidate == pair.candidate && row.reference == pair.reference &&
        row.quantity == pair.quantity && row.metric == metric && row.mode == mode &&
        !row.improves_on)
      return std::isfinite(one.value) ? value_text(row, {one.value, one.half_width}) : "";
  }
  return "";
}

// What a row judges is shown as it is judged; the rest as the runs compare.
void add_numbers(const CaseAssessment& assessment, const RowsOfCode& rows, const GateRow& pair,
                 HeadlineLine& line) {
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
  const std::string name = mode ? mode->mode : "forced";
  const auto number = [&](Metric metric, const std::string& of_mode, const Estimate* compared,
                          const char* unit) {
    const std::string judged = judged_value(rows, pair, metric, of_mode);
    const bool is_compared = judged.empty() && compared && std::isfinite(compared->value);
    return is_compared ? with_interval(*compared, unit) : judged;
  };
  line.amplitude =
      number(Metric::amplitude_error, name, mode ? &mode->amplitude_error : nullptr, "1");
  line.lag = judged_value(rows, pair, Metric::cross_correlation_lag, "whole");
  if (line.lag.empty())
    line.lag = number(Metric::phase_lag, name, mode ? &mode->phase_lag_degrees : nullptr, "deg");
  line.rms = number(Metric::normalised_rms, "whole", found ? &found->normalised_rms : nullptr, "1");
}

// The worst row, or of rows that pass the one nearest to its limit.
const ShownRow& deciding(const RowsOfCode& rows) {
  const auto nearest =
      std::ranges::find_if(rows, [](const ShownRow& one) { return one.share.has_value(); });
  return rows.front().verdict == Verdict::pass && nearest != rows.end() ? *nearest : rows.front();
}

HeadlineLine line_of(const CaseAssessment& assessment, const RowsOfCode& rows) {
  const CaseDefinition& definition = assessment.definition;
  const GateRow& pair = featured(definition, rows);
  const ShownRow& decides = deciding(rows);
  HeadlineLine line{
      .name = definition.name,
      .verdict = rows.front().verdict,
      .standing = standing_name(rows),
      .candidate = short_text(run_named(definition, pair.candidate)),
      .reference = pair.reference.empty() ? "" : short_text(run_named(definition, pair.reference)),
      .decides = fmt::format("{}, {}: {}", decides.candidate, decides.metric_text, decides.message),
      .row_id = decides.row_id,
      .section = case_id(definition.name) + "-gate"};
  if (is_judged(line.verdict) && !pair.reference.empty()) add_numbers(assessment, rows, pair, line);
  return line;
}

// A problem has no run of a code but one of SPH.
void add_problem(const ProblemAssessment& assessment, std::vector<HeadlineLine>& lines) {
  RowsOfCode rows = shown_rows(assessment);
  std::erase_if(rows, [](const ShownRow& row) { return !row.counts(); });
  if (rows.empty()) return;
  std::ranges::stable_sort(rows, is_worse);
  const ShownRow& worst = rows.front();
  lines.push_back(
      {.name = worst.name,
       .verdict = worst.verdict,
       .standing = standing_name(rows),
       .candidate = "SPH",
       .reference = "the exact solution",
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

}  // namespace

std::vector<HeadlineLine> headline_lines(const std::vector<CaseAssessment>& cases,
                                         const std::vector<ProblemAssessment>& problems) {
  std::vector<HeadlineLine> lines;
  for (const CaseAssessment& one : cases)
    for (const RowsOfCode& rows : rows_of_codes(one)) {
      // Loads and frequencies are questions of their own: no departure stands for them all.
      const bool is_alone = std::ranges::none_of(rows, compares) && rows.size() <= most_alone;
      if (!is_alone) lines.push_back(line_of(one, rows));
      for (const ShownRow& row : is_alone ? rows : RowsOfCode{})
        lines.push_back(line_of(one, {row}));
    }
  for (const ProblemAssessment& one : problems) add_problem(one, lines);
  return lines;
}

bool is_only_watched(const std::vector<HeadlineLine>& lines) {
  const auto any = [&](const char* standing) {
    return std::ranges::find(lines, standing, &HeadlineLine::standing) != lines.end();
  };
  return any("watched, not validated") && !any("validated");
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
  int not_comparable = 0;
  std::string why;  // of the first
  for (const CaseAssessment& one : cases) {
    if (why.empty() && !one.not_comparable.empty())
      why = fmt::format(" Not comparable: {}.", one.not_comparable.front());
    not_comparable += static_cast<int>(one.not_comparable.size());
  }
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
  add(not_comparable, "pair not comparable", "pairs not comparable");
  add(runs(RunState::failed), "run failed", "runs failed");
  add(runs(RunState::missing), "run without a result", "runs without a result");
  add(runs(RunState::not_supplied), "record not supplied", "records not supplied");
  add(rows(Verdict::not_supplied), "gate row without its record", "gate rows without their record");
  add(rows(Verdict::not_selected), "not selected");
  return text + "." + why;
}

std::string headline_sentence(const std::vector<HeadlineLine>& lines) {
  const HeadlineLine& first = *std::ranges::max_element(lines, {}, [](const HeadlineLine& line) {
    return std::pair(severity(line.verdict), line.standing == "validated");
  });
  std::vector<std::string> texts{line_text(first)};
  for (const HeadlineLine& line : lines)
    if (line.name == first.name && line.row_id != first.row_id) texts.push_back(line_text(line));
  return fmt::format("{}.", fmt::join(texts, "; "));
}

std::string headline_word(int status, const std::vector<HeadlineLine>& lines) {
  return status == exit_pass && is_only_watched(lines) ? "WATCHED, NOT VALIDATED"
                                                       : headline_word(status);
}

reports::Table headline_table(const std::vector<HeadlineLine>& lines) {
  reports::Table table{
      "headline",
      "Departures, case by case",
      "A line for each case and code: its finest run that a row compares, or the one that a row "
      "objects to. Intervals are of 95 %. A case with regression rows alone is watched: it departs "
      "no further than earlier, which validates nothing. Where no row has a reference, each row "
      "has its line.",
      {"case", "candidate", "reference", "amplitude", "lag", "rms", "standing", "decides"}};
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
