// The subcommand compare: compares two result files on one quantity, with or without a case, and
// judges the comparison if limits are given.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <utility>

#include "reports/summary/results_json.hpp"
#include "verification/assessment/references/case_theories.hpp"
#include "verification/assessment/validity_envelope.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"
#include "verification/case_file/case_parser.hpp"
#include "verification/case_file/tables/plain_table.hpp"
#include "verification/cli/command_tree.hpp"
#include "verification/cli/limit_option.hpp"
#include "verification/cli/stored_run.hpp"
#include "verification/cli/texts/campaign_text.hpp"
#include "verification/cli/texts/result_text.hpp"
#include "verification/evidence/case_evidence.hpp"
#include "verification/evidence/soundness.hpp"
#include "verification/files/foreign/plain_file.hpp"
#include "verification/files/own_files.hpp"
#include "verification/files/protected_inputs.hpp"
#include "verification/gate/gate.hpp"
#include "verification/gate/measured_value.hpp"
#include "verification/import/import_series.hpp"
#include "verification/input/nearest_name.hpp"
#include "verification/metrics/comparison.hpp"
#include "verification/results/result_file.hpp"
#include "verification/runs/run_case.hpp"
#include "verification/solvers/external_facts.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;

struct CompareOptions {
  std::filesystem::path candidate, reference;  // result files
  std::string gauge, quantity;                 // at most one of the two
  std::string case_name;                       // empty: none
  std::vector<double> frequencies;             // [Hz], of the modes to fit without a case
  std::vector<double> window;       // [s] begin and end; empty: see docs/other_solvers.md
  std::vector<std::string> limits;  // "METRIC=VALUE", "MODE:METRIC=VALUE"
  std::filesystem::path json;       // empty: none
};

bool has_series(const RunResult& result, const std::string& name) {
  return std::any_of(result.series.begin(), result.series.end(),
                     [&](const TimeSeries& one) { return one.name == name; });
}

// Whether `export` left it of a case, with a series of each theory, as "elevation@right/linear".
bool has_theories(const RunResult& result) { return result.solver == "references"; }

// The series of this name, or nullptr. Of a file of theories the first one of "elevation@right"
// serves for it, and beside such a file the own "elevation@right" for each of them.
const TimeSeries* found(const std::string& name, const RunResult& result, const RunResult& other) {
  if (has_series(result, name)) return &result.at(name);
  const std::string quantity = name.substr(0, name.rfind('/'));
  if (has_theories(other) && has_series(result, quantity)) return &result.at(quantity);
  if (!has_theories(result)) return nullptr;
  const auto one = std::ranges::find_if(
      result.series, [&](const TimeSeries& of) { return of.name.starts_with(name + "/"); });
  return one == result.series.end() ? nullptr : &*one;
}

std::vector<std::string> common_series(const RunResult& candidate, const RunResult& reference) {
  std::vector<std::string> names;
  for (const TimeSeries& one : candidate.series)
    if (found(one.name, reference, candidate)) names.push_back(one.name);
  return names;
}

std::string compared_quantity(const CompareOptions& options, const RunResult& candidate,
                              const RunResult& reference) {
  if (!options.quantity.empty()) return options.quantity;
  if (!options.gauge.empty()) return "elevation@" + options.gauge;
  const std::vector<std::string> common = common_series(candidate, reference);
  if (common.empty())
    throw ComparisonError(fmt::format("{} and {} have no series in common",
                                      options.candidate.string(), options.reference.string()));
  if (common.size() == 1) return common.front();
  throw CaseFileError(fmt::format("--quantity is missing: expected one of {}, which both have",
                                  fmt::join(common, ", ")));
}

// Throws ResultError with the nearest names if the result has no such series.
const TimeSeries& series_of(const std::string& quantity, const RunResult& result,
                            const RunResult& other, const std::filesystem::path& file) {
  if (const TimeSeries* one = found(quantity, result, other)) return *one;
  std::vector<std::string> names;
  for (const TimeSeries& one : result.series) names.push_back(one.name);
  throw ResultError(fmt::format("{}: no series {}; nearest: {}", file.string(), quantity,
                                fmt::join(nearest_names(quantity, names, 3), ", ")));
}

std::vector<ToneRequest> modes_to_fit(const CompareOptions& options,
                                      const std::optional<CaseDefinition>& definition,
                                      const std::string& quantity) {
  if (definition)
    return has_modes(quantity) ? fitted_modes(*definition) : std::vector<ToneRequest>{};
  std::vector<ToneRequest> modes;
  for (const double frequency : options.frequencies)
    modes.push_back({modes.empty() ? "forced" : fmt::format("tone_{}", modes.size() + 1),
                     2 * std::numbers::pi * frequency, false});
  return modes;
}

// Refuses a candidate that ends early: it would be judged on the part that it has, and pass. A part
// is compared only if the user names a window.
void require_whole_reference(const TimeSeries& candidate, const TimeSeries& reference) {
  const auto &has = candidate.time, &expected = reference.time;
  const double intervals = std::max(1.0, static_cast<double>(has.size()) - 1);
  const double sample =
      (has.back() - has.front()) / intervals * (1 + 1e-6);  // a margin for rounding
  if (has.front() <= expected.front() + sample && has.back() >= expected.back() - sample) return;
  throw ComparisonError(fmt::format(
      "{}: the candidate spans {} to {} s, the reference {} to {} s; expected a candidate that "
      "covers the reference to within one sample, or --window BEGIN END for the part to compare",
      candidate.name, has.front(), has.back(), expected.front(), expected.back()));
}

TimeWindow window_of(const CompareOptions& options, const std::optional<CaseDefinition>& definition,
                     const TimeSeries& candidate, const TimeSeries& reference) {
  if (!options.window.empty()) {
    const TimeWindow asked{options.window[0], options.window[1]};
    if (!(asked.begin < asked.end))
      throw CaseFileError(fmt::format("--window {} {}: expected a begin before its end, in s",
                                      asked.begin, asked.end));
    return asked;
  }
  if (definition) return {definition->window_begin, definition->window_end};
  if (candidate.time.empty() || reference.time.empty())
    throw ComparisonError("a series without a sample");
  require_whole_reference(candidate, reference);
  return {std::max(candidate.time.front(), reference.time.front()),
          std::min(candidate.time.back(), reference.time.back())};
}

std::string peaks_text(const std::vector<SpectralPeak>& peaks) {
  std::vector<std::string> texts;
  for (const SpectralPeak& peak : peaks) texts.push_back(fmt::format("{:.4g} Hz", peak.frequency));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void print_modes(const Comparison& comparison) {
  std::cout << fmt::format("lag by cross-correlation: {:.4g} s\n",
                           0.0 + comparison.cross_correlation_lag);
  for (const ModeComparison& mode : comparison.modes) {
    std::cout << fmt::format("mode {} ({:.4g} Hz){}\n", mode.mode,
                             mode.reference.angular_frequency.value / (2 * std::numbers::pi),
                             mode.resolved() ? "" : ", cannot be resolved");
    std::cout << "  amplitude error: " << with_interval(mode.amplitude_error, "1") << "\n"
              << "  phase lag: " << with_interval(mode.phase_lag_degrees, "deg") << " ("
              << with_interval(mode.phase_lag, "s") << ")\n";
    if (mode.mode.starts_with("natural_"))
      std::cout << "  frequency error: " << with_interval(mode.frequency_error, "1") << "\n"
                << "  decay rate: " << with_interval(mode.decay_rate, "1/s") << "\n";
  }
  std::cout << "spectral peaks of the candidate: " << peaks_text(comparison.candidate_peaks)
            << "\nspectral peaks of the reference: " << peaks_text(comparison.reference_peaks)
            << "\n";
}

void print_band(const Comparison& comparison) {
  if (!comparison.margin) return;
  std::cout << fmt::format("outside the reference's band: {} of the time\n",
                           in_unit(share_outside(*comparison.margin, comparison.window), "1"));
}

void print(const Comparison& comparison) {
  std::cout << fmt::format("{} of {} against {}, {:.6g} to {:.6g} s\n", comparison.quantity,
                           comparison.candidate, comparison.reference, comparison.window.begin,
                           comparison.window.end);
  for (const std::string& doubt : comparison.doubts) std::cout << "doubtful: " << doubt << "\n";
  if (comparison.unseen)
    std::cout << "not compared: " << unseen_text(*comparison.unseen, comparison.unit) << "\n";
  const std::string offset =
      in_unit(comparison.candidate_wave.mean - comparison.reference_wave.mean, comparison.unit);
  if (comparison.reference_is_constant) {
    std::cout << "the reference is constant: only the offset and the residual are compared\n"
              << "mean offset: " << offset << "\n"
              << "largest residual: " << in_unit(comparison.maximum_residual, comparison.unit)
              << "\n";
    return;
  }
  std::cout << "normalised rms: " << with_interval(comparison.normalised_rms, "1") << "\n"
            << "mean offset: " << offset << ", normalised rms without it: "
            << in_unit(normalised_rms_without_offset(comparison), "1") << "\n"
            << "largest residual: " << in_unit(comparison.maximum_residual, comparison.unit) << "\n"
            << "Sprague and Geers: magnitude "
            << with_interval(comparison.sprague_geers_magnitude, "1") << ", phase "
            << with_interval(comparison.sprague_geers_phase, "1") << "\n";
  print_band(comparison);
  if (!comparison.modes.empty()) return print_modes(comparison);
  const auto& [lag, left] = comparison.alignment;
  std::cout << "lag that fits best: "
            << (std::isnan(lag) ? "none\n"
                                : fmt::format("{:.4g} s, normalised rms without it: {}\n",
                                              0.0 + lag, in_unit(left, "1")));
}

Json outcome_entry(const GateOutcome& outcome) {
  return {{"verdict", verdict_name(outcome.verdict)},
          {"mode", outcome.row.mode},
          {"metric", metric_name(outcome.row.metric)},
          {"unit", outcome.row.unit},
          {"value", outcome.value.value},
          {"half_width_95", outcome.value.half_width},
          {"limit", *outcome.row.limit},
          {"message", outcome.message}};
}

void write_json(const Comparison& comparison, const std::vector<GateOutcome>& outcomes, int status,
                const std::filesystem::path& file) {
  Json document{{"schema", "slosh comparison"},
                {"schema_version", 1},
                {"exit_status", status},
                {"comparison", comparison_entry(comparison)},
                {"gate", Json::array()}};
  if (comparison.margin)
    document["comparison"]["outside_band"] = share_outside(*comparison.margin, comparison.window);
  document["comparison"]["doubts"] = comparison.doubts;
  for (const GateOutcome& outcome : outcomes) document["gate"].push_back(outcome_entry(outcome));
  replace_named(file, document.dump(2) + "\n", "compare");
}

// The arrays of a comparison are as long as the series. By default each goes back to the system
// when it is freed, and the pages of the next one are made anew: of ten million samples that took
// 15 of 26 s of processor time. Kept for the next one they take 3 of 17 s.
void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

constexpr const char* hdf5_mark = "\x89HDF";

// A pipe would be waited for.
void require_plain_file(const char* role, const std::filesystem::path& file) {
  if (std::filesystem::exists(file) && !is_plain_file(file))
    throw CaseFileError(fmt::format("{} = {}: expected a regular file", role, file.string()));
}

// A result file, or a plain table whose columns the case tells.
RunResult named_candidate(const CompareOptions& options,
                          const std::optional<CaseDefinition>& definition) {
  require_plain_file("candidate", options.candidate);
  std::string begin(4, ' ');
  std::ifstream(options.candidate, std::ios::binary).read(begin.data(), 4);
  if (!definition || begin == hdf5_mark || options.candidate.extension() == ".h5")
    return named_result(options.candidate);
  protect_input(options.candidate);
  RunResult result;
  for (const SeriesSource& source : series_of_table(options.candidate, *definition))
    add_imported(import_with_seams(source), result);
  return result;
}

// The case's first theory of the liquid, or else its first theory, computed.
RunResult theory_of(const CaseDefinition& definition) {
  const RunDefinition* theory = nullptr;
  for (const RunDefinition& run : definition.runs)
    if (is_theory(run) && (!theory || (sees_gas(*theory) && !sees_gas(run)))) theory = &run;
  if (!theory)
    throw CaseFileError(fmt::format(
        "reference is missing: expected a result file, or a case with a theory; {} has none",
        definition.file.string()));
  RunSettings settings;
  settings.with_left_out = false;
  RunResult result = execute(definition, *theory, settings, [](double, double) {});
  if (const auto outside = outside_validity(definition, *theory, result))
    result.provenance[theory->name + outside_its_range] = *outside;
  return result;
}

// A file with the theory of several that serves.
std::string named(const std::filesystem::path& file, const TimeSeries& series,
                  const std::string& quantity) {
  return file.string() + (series.name == quantity ? "" : " (" + series.name + ")");
}

// Of a theory that was computed here or that `export` left.
void add_range_doubt(const RunResult& reference, const std::string& series,
                     std::vector<std::string>& doubts) {
  const std::size_t slash = series.rfind('/');
  const std::string theory =
      slash == std::string::npos ? reference.run_name : series.substr(slash + 1);
  const auto outside = reference.provenance.find(theory + outside_its_range);
  if (outside != reference.provenance.end())
    doubts.push_back(fmt::format("{} is outside its range: it {}", theory, outside->second));
}

// Whether the results, or a result and the case of --case, hold different texts of a case, so that
// tank, liquid, motion or gauges may differ. An imported result holds none.
bool are_of_other_cases(const RunResult& candidate, const RunResult& reference,
                        const std::optional<CaseDefinition>& definition) {
  const std::string asked = definition ? definition->text : "";
  const auto differ = [](const std::string& one, const std::string& other) {
    return !one.empty() && !other.empty() && one != other;
  };
  return differ(candidate.case_text, reference.case_text) || differ(candidate.case_text, asked) ||
         differ(reference.case_text, asked);
}

constexpr const char* other_cases =
    "the results and the case were read from different texts of a case: tank, liquid, motion and "
    "gauges may differ";

struct ComparedFiles {
  Comparison comparison;
  std::string impacts;  // impact_lines(), of a case whose impacts are in the quantity
  std::vector<std::string> doubts_of_runs;  // for which no limit is passed
};

ComparedFiles compared(const CompareOptions& options, const Installation& installation) {
  std::optional<CaseDefinition> definition;
  if (!options.case_name.empty())
    definition = read_case(find_case(options.case_name, installation.cases));
  if (options.reference.empty() && !definition)
    throw CaseFileError("reference is missing: expected a result file, or --case with a theory");
  const RunResult candidate = named_candidate(options, definition);
  require_plain_file("reference", options.reference);
  const RunResult reference =
      options.reference.empty() ? theory_of(*definition) : named_result(options.reference);
  const std::string quantity = compared_quantity(options, candidate, reference);
  const TimeSeries &of_candidate = series_of(quantity, candidate, reference, options.candidate),
                   &of_reference = series_of(quantity, reference, candidate, options.reference);
  const TimeWindow window = window_of(options, definition, of_candidate, of_reference);
  const std::vector<ToneRequest> modes = modes_to_fit(options, definition, quantity);
  PreparedSeries prepared("reference", of_reference, window, modes);
  if (has_series(reference, quantity + lower_edge))
    prepared.add_band({reference.at(quantity + lower_edge), reference.at(quantity + upper_edge)});
  Comparison comparison =
      compare(PreparedSeries("candidate", of_candidate, window, modes), prepared);
  std::vector<std::string> doubts_of_runs;
  for (const auto& [role, result] : {std::pair("candidate", &candidate), {"reference", &reference}})
    if (const std::string unsound =
            soundness_doubts(*result, window, !definition || definition->gravity > 0);
        !unsound.empty())
      doubts_of_runs.push_back(fmt::format("the {} is not sound: {}", role, unsound));
  add_range_doubt(reference, of_reference.name, doubts_of_runs);
  if (are_of_other_cases(candidate, reference, definition)) doubts_of_runs.push_back(other_cases);
  comparison.candidate = named(options.candidate, of_candidate, quantity);
  comparison.reference = options.reference.empty()
                             ? reference.run_name
                             : named(options.reference, of_reference, quantity);
  return {std::move(comparison),
          definition && has_impacts(*definition, quantity)
              ? impact_lines(*definition, of_candidate, of_reference)
              : "",
          doubts_of_runs};
}

int compare_results(const CompareOptions& options, const Installation& installation) {
  keep_freed_memory();
  auto [comparison, impacts, doubts_of_runs] = compared(options, installation);
  const std::vector<GateOutcome> outcomes =
      judged_by_limits(options.limits, comparison, doubts_of_runs);
  std::ranges::move(doubts_of_runs, std::back_inserter(comparison.doubts));
  print(comparison);
  std::cout << impacts;
  for (const GateOutcome& outcome : outcomes)
    std::cout << as_shown(
        fmt::format("{}: {} {}: {}\n", verdict_name(outcome.verdict), outcome.row.mode,
                    metric_name(outcome.row.metric), outcome.message),
        style_of(STDOUT_FILENO));
  const int status = outcomes.empty() ? static_cast<int>(exit_pass) : exit_status(outcomes);
  if (!options.json.empty()) write_json(comparison, outcomes, status, options.json);
  return status;
}

}  // namespace

void add_compare_command(const CommandTree& tree) {
  const auto [command, options] = add_command_with<CompareOptions>(
      tree,
      {"compare",
       "Compares two result files on a quantity, and judges by limits",
       {"./slosh run li2010_small_amplitude recommended_25mm",
        "./slosh run li2010_small_amplitude linear",
        "./slosh compare recommended_25mm.h5 linear.h5 --case li2010_small_amplitude "
        "--gauge right --limit amplitude_error=0.05"}},
      compare_results);
  add_option(command, "candidate", options.candidate, file_type,
             "A result file, or with --case a table with the columns t and elevation@GAUGE, "
             "force_x, ..., or t and one more")
      ->required();
  add_option(command, "reference", options.reference, file_type,
             "A result file (default: the first theory of --case, computed)");
  CLI::Option* gauge = command.add_option("--gauge", options.gauge, "Compares elevation@GAUGE");
  command.add_option("--quantity", options.quantity, "Compares this series")->excludes(gauge);
  CLI::Option* of_case = add_option(command, "--case", options.case_name, case_type,
                                    "A case whose window, forcing and natural modes are taken");
  command
      .add_option("--frequency", options.frequencies,
                  "Frequency of a mode to fit [Hz]; may be given again")
      ->allow_extra_args(false)
      ->check(keeps(positive("Hz")))
      ->excludes(of_case);
  command
      .add_option("--window", options.window,
                  "Begin and end [s] (default: the case's window, or what both series cover)")
      ->expected(2);
  command
      .add_option("--limit", options.limits,
                  "METRIC=VALUE or MODE:METRIC=VALUE, judged as a gate row is; may be given again")
      ->allow_extra_args(false);
  add_option(command, "--json", options.json, file_type,
             "Also write the comparison and the verdicts to this file, as JSON");
}

}  // namespace slosh
