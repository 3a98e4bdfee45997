#include "reports/figures/figure_runs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "reports/drawing/figure_layout.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/ensemble.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

// Adds the band of the experiment's repeats, where the record has it of this quantity.
reports::Curve with_band(reports::Curve curve, const RunResult& record, const std::string& quantity,
                         double scale) {
  for (const TimeSeries& edge : record.series) {
    if (edge.name == quantity + lower_edge) curve.lower = scaled(edge.value, scale);
    if (edge.name == quantity + upper_edge) curve.upper = scaled(edge.value, scale);
  }
  if (curve.lower.size() != curve.y.size() || curve.upper.size() != curve.y.size()) {
    curve.lower.clear();
    curve.upper.clear();
  } else {
    curve.ribbon = "band of the experiment's repeats";
  }
  return curve;
}

constexpr std::size_t hues = 6, shapes = 10;

// A family's hue, and the marker and dash of its finest run.
struct FamilyLook {
  std::string_view family;
  std::size_t hue, shape;

  bool is_alike(const FamilyLook& other) const { return hue == other.hue && shape == other.shape; }
};

// The families of the shipped cases. There are more than hues that the colour-blind tell apart:
// those that share a hue have other markers, filled and hollow.
constexpr FamilyLook known_families[] = {
    {"recommended", 0, 0},     {"interFoam", 1, 1},        {"li2010", 2, 2},
    {"zhao2021_moving", 3, 3}, {"zhao2021_fixed", 4, 4},   {"delta_sph", 5, 5},
    {"interIsoFoam", 1, 6},    {"pysph_delta_sph", 3, 8},  {"pysph_edac", 4, 9},
    {"pysph_adami", 5, 8},     {"dualsphysics_mdbc", 2, 7}};

const FamilyLook* known_look(std::string_view family) {
  const auto found = std::find_if(std::begin(known_families), std::end(known_families),
                                  [&](const FamilyLook& known) { return known.family == family; });
  return found == std::end(known_families) ? nullptr : &*found;
}

// The first look that none of these has: of a hue that none of them has, else of any.
FamilyLook free_look(const std::string& family, const std::vector<FamilyLook>& taken) {
  const auto is_none = [&](const auto& is_like) {
    return std::none_of(taken.begin(), taken.end(), is_like);
  };
  for (std::size_t hue = 0; hue < hues; ++hue)
    if (is_none([&](const FamilyLook& one) { return one.hue == hue; })) return {family, hue, hue};
  for (std::size_t shape = 0; shape < shapes; ++shape)
    for (std::size_t hue = 0; hue < hues; ++hue) {
      const FamilyLook look{family, hue, (hue + shape) % shapes};
      if (is_none([&](const FamilyLook& one) { return one.is_alike(look); })) return look;
    }
  return {family, 0, 0};  // more than 60 families
}

// The look of a family among others: its own where it is known, else one that no known family and
// no earlier one has.
FamilyLook look_among(const std::string& family, const std::vector<std::string>& families) {
  if (const FamilyLook* known = known_look(family)) return *known;
  std::vector<FamilyLook> taken;
  for (const std::string& one : families)
    if (const FamilyLook* known = known_look(one)) taken.push_back(*known);
  for (const std::string& one : families) {
    if (one == family) break;
    if (!known_look(one)) taken.push_back(free_look(one, taken));
  }
  return free_look(family, taken);
}

void add_once(const std::string& name, std::vector<std::string>& names) {
  if (!is_one_of(name, names)) names.push_back(name);
}

// Returns how many runs of the family, an ensemble as one, come before the run: those with less of
// the scheme changed, the finer ones, and those that the case names earlier.
std::size_t rank_of(const CaseDefinition& definition, const RunDefinition& run) {
  const auto order = [](const RunDefinition& one) {
    return std::tuple{is_changed(one), -resolution(one)};
  };
  std::size_t rank = 0;
  bool is_earlier = true;
  for (const RunDefinition& other : definition.runs) {
    is_earlier = is_earlier && other.name != run.name;
    if (is_simulation(other) && !is_later_member(other) && family(other) == family(run))
      rank += order(other) < order(run) || (is_earlier && order(other) == order(run));
  }
  return rank;
}

}  // namespace

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::function<bool(const RunResult&)>& has) {
  const auto preference = [](const RunDefinition& run) {
    const std::string changes = changes_of(run);
    return std::tuple{changes.empty(), resolution(run),
                      -std::count(changes.begin(), changes.end(), ',')};
  };
  std::vector<std::string> families;
  std::map<std::string, const RunDefinition*> finest;
  for (const RunDefinition& run : assessment.definition.runs) {
    const auto result = assessment.runs.results.find(run.name);
    if (result == assessment.runs.results.end() || !has(result->second)) continue;
    const RunDefinition*& best = finest[family(run)];
    if (!best) families.push_back(family(run));
    if (!best || preference(run) > preference(*best)) best = &run;
  }
  std::vector<std::string> names;
  for (const std::string& one : families) names.push_back(finest[one]->name);
  return names;
}

std::vector<std::string> finest_runs(const CaseAssessment& assessment,
                                     const std::string& quantity) {
  return finest_runs(assessment, [&](const RunResult& result) {
    return std::any_of(result.series.begin(), result.series.end(),
                       [&](const TimeSeries& series) { return series.name == quantity; });
  });
}

bool is_in_range(const CaseAssessment& assessment, const std::string& run) {
  return assessment.runs.status.at(run).state != RunState::out_of_range;
}

std::string run_label(const CaseAssessment& assessment, const std::string& run) {
  return is_in_range(assessment, run) ? run : run + " (out of its range)";
}

HistoryAxes axes_with_units(const CaseDefinition& definition, const std::string& quantity) {
  const ShownQuantity shown = shown_quantity(definition, quantity);
  return {{.value = shown.scale}, "time [s]", fmt::format("{} [{}]", shown.word, shown.unit)};
}

std::optional<HistoryAxes> axes_over_depth(const CaseDefinition& definition,
                                           const std::string& quantity) {
  const char* label = find_quantity(quantity)->label_over_depth;
  const double frequency = forcing_frequency(definition) / (2 * std::numbers::pi);
  if (!label || !(frequency > 0)) return std::nullopt;
  const double depth = definition.liquid.fill_depth;
  return HistoryAxes{{.time = frequency, .value = 1 / depth},
                     "time over the forcing period, t/T [1]",
                     label,
                     fmt::format("h = {:.4g} m, T = {:.4g} s. ", depth, 1 / frequency)};
}

// More points would overlap.
constexpr std::size_t most_points = 200;

reports::Curve history_curve(const CaseAssessment& assessment, const std::string& run,
                             const std::string& quantity, const AxisScales& scales) {
  const TimeSeries& series = assessment.runs.results.at(run).at(quantity);
  reports::Curve curve{run_label(assessment, run),
                       scaled(series.time, scales.time),
                       scaled(series.value, scales.value),
                       {},
                       {}};
  curve.look = look_of(assessment.definition, run);
  curve.sets_scale = is_in_range(assessment, run);
  if (const auto* record = std::get_if<RecordRun>(&run_named(assessment.definition, run).solver)) {
    if (record->has_band)
      return with_band(std::move(curve), assessment.runs.results.at(run), quantity, scales.value);
    if (record->time.size() <= most_points) curve.style = reports::Curve::Style::points;
    if (record->uncertainty)
      set_uncertainty(curve, std::vector(curve.y.size(), scales.value * *record->uncertainty),
                      "95 % interval of the record");
  }
  return curve;
}

reports::Figure histories(const CaseAssessment& assessment, const std::string& quantity,
                          const std::vector<std::string>& runs, const HistoryAxes& axes) {
  reports::Figure figure{.id = "", .title = "", .x_label = axes.x_label, .y_label = axes.y_label};
  for (const std::string& run : runs)
    figure.curves.push_back(history_curve(assessment, run, quantity, axes.scales));
  return figure;
}

void set_uncertainty(reports::Curve& curve, const std::vector<double>& half_widths,
                     const std::string& what) {
  if (half_widths.size() != curve.y.size())
    throw std::invalid_argument(fmt::format("{}: {} half widths of {} samples", curve.label,
                                            half_widths.size(), curve.y.size()));
  if (curve.style == reports::Curve::Style::points) {
    curve.y_error = half_widths;
    return;
  }
  for (std::size_t i = 0; i < curve.y.size(); ++i) {
    curve.lower.push_back(curve.y[i] - half_widths[i]);
    curve.upper.push_back(curve.y[i] + half_widths[i]);
  }
  curve.ribbon = what;
}

void add_tolerance_band(reports::Band band, reports::Figure& figure) {
  const auto is_near = [](double one, double other) {
    return std::abs(one - other) <= 1e-6 * std::abs(one);
  };
  for (reports::Band& known : figure.bands)
    if (is_near(known.lower, band.lower) && is_near(known.upper, band.upper)) {
      known.label += ", " + band.label;
      known.look = {};
      return;
    }
  band.label = "tolerance, " + band.label;
  figure.bands.push_back(std::move(band));
}

void let_most_set_scale(reports::Figure& figure,
                        const std::function<double(const reports::Curve&)>& size) {
  constexpr std::size_t fewest = 3;
  constexpr double far = 4;
  std::vector<double> sizes;
  for (const reports::Curve& curve : figure.curves)
    if (curve.look && !curve.look->is_reference) sizes.push_back(size(curve));
  if (sizes.size() < fewest) return;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>((sizes.size() - 1) / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  if (!(*middle > 0)) return;
  for (reports::Curve& curve : figure.curves)
    if (curve.look && !curve.look->is_reference && size(curve) > far * *middle)
      curve.sets_scale = false;
}

double farthest_from(double level, const reports::Curve& curve) {
  double farthest = 0;
  for (const double value : curve.y)
    if (std::isfinite(value)) farthest = std::max(farthest, std::abs(value - level));
  return farthest;
}

std::string cut_off_text(const reports::Figure& figure) {
  const reports::AxisRange frame = reports::plot_ranges(figure).vertical;
  std::string text;
  for (const reports::Curve& curve : figure.curves) {
    if (curve.sets_scale) continue;
    double lowest = INFINITY, highest = -INFINITY;
    for (const double value : curve.y)
      if (std::isfinite(value)) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
      }
    if (lowest < frame.lower || highest > frame.upper)
      text += fmt::format(
          " The thin line of {} is cut off at the frame, which is scaled to the other curves: it "
          "lies between {:.3g} and {:.3g}.",
          curve.label, lowest, highest);
  }
  return text;
}

std::vector<const Comparison*> shown_comparisons(const CaseAssessment& assessment) {
  const std::vector<std::string> finest =
      finest_runs(assessment, compared_quantities(assessment.definition).front());
  std::vector<const Comparison*> shown = judging_comparisons(assessment);
  std::erase_if(shown, [&](const Comparison* one) { return !is_one_of(one->candidate, finest); });
  return shown;
}

std::vector<reports::Span> outside_window(const CaseDefinition& definition,
                                          const std::string& quantity, double time_scale) {
  double first = definition.window_begin, last = definition.window_end;
  for (const GateRow& row : definition.gate) {
    if (row.quantity != quantity) continue;
    const auto [begin, end] = judged_time(row, definition);
    first = std::min(first, begin);
    last = std::max(last, end);
  }
  std::vector<reports::Span> spans;
  for (const auto& [begin, end] : {std::pair{0.0, first}, std::pair{last, definition.duration}})
    if (begin < end)
      spans.push_back({"outside the comparison window", time_scale * begin, time_scale * end});
  return spans;
}

std::string who_is_who(const CaseDefinition& definition, const std::vector<std::string>& runs) {
  std::vector<std::string> texts;
  bool bars = false;
  std::string bands;
  for (const std::string& name : runs) {
    const RunDefinition& run = run_named(definition, name);
    texts.push_back(name + ": " + caption_text(run));
    const auto* record = std::get_if<RecordRun>(&run.solver);
    bars |= record && record->uncertainty && !record->has_band;
    if (record && record->has_band)
      bands += fmt::format(
          " The ribbon about {} is the band of the experiment's repeats, from a lower to an upper "
          "quantile.",
          name);
  }
  return fmt::format("{}.{}{}", fmt::join(texts, "; "),
                     bars ? " Bars, or a ribbon, show the 95 % interval of a record." : "", bands);
}

reports::Look look_of(const CaseDefinition& definition, const std::string& name) {
  const RunDefinition& run = run_named(definition, name);
  std::vector<std::string> families;
  std::size_t references_before = 0;
  bool is_earlier = true;
  for (const RunDefinition& other : definition.runs) {
    is_earlier = is_earlier && other.name != name;
    if (is_simulation(other))
      add_once(family(other), families);
    else
      references_before += is_earlier;
  }
  if (!is_simulation(run)) return {true, references_before, references_before / 2};
  const FamilyLook own = look_among(family(run), families);
  return {false, own.hue, own.shape + rank_of(definition, run)};
}

reports::Look look_of_family(const CaseDefinition& definition, const std::string& name) {
  const RunDefinition* first = nullptr;
  for (const RunDefinition& run : definition.runs)
    if (is_simulation(run) && family(run) == name && (!first || rank_of(definition, run) == 0))
      first = &run;
  if (first) return look_of(definition, first->name);
  const FamilyLook mesh = look_among("interFoam", {});
  return {false, mesh.hue, mesh.shape};
}

std::vector<reports::Look> looks_of_models(const std::vector<std::string>& models) {
  const auto family_of = [](const std::string& model) { return model.substr(0, model.find(", ")); };
  std::vector<std::string> families;
  for (const std::string& model : models) add_once(family_of(model), families);
  std::vector<reports::Look> looks;
  for (std::size_t i = 0; i < models.size(); ++i) {
    const FamilyLook own = look_among(family_of(models[i]), families);
    const auto before = std::count_if(
        models.begin(), models.begin() + static_cast<long>(i),
        [&](const std::string& other) { return family_of(other) == family_of(models[i]); });
    looks.push_back({false, own.hue, own.shape + static_cast<std::size_t>(before)});
  }
  return looks;
}

}  // namespace slosh
