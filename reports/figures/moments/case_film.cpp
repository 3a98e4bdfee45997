// A case's animation: the finest run of each scheme and solver side by side, and their history.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "reports/figures/figure_runs.hpp"
#include "reports/figures/moments/case_fields.hpp"
#include "reports/model/is_one_of.hpp"
#include "reports/wording/shown_quantity.hpp"
#include "verification/case/case_definition.hpp"
#include "verification/case/quantities.hpp"
#include "verification/case/solver_kinds.hpp"

namespace slosh {
namespace {

using reports::Curve;
using reports::FieldFigure;
using reports::Figure;
using reports::Film;

using Names = std::vector<std::string>;

// The elevation at the first gauge or, where nothing recorded one, the first quantity that was
// recorded.
std::string followed_quantity(const CaseAssessment& assessment) {
  Names quantities = compared_quantities(assessment.definition);
  std::stable_partition(quantities.begin(), quantities.end(), [](const std::string& quantity) {
    return quantity.starts_with("elevation@");
  });
  for (const std::string& quantity : quantities)
    if (!finest_runs(assessment, quantity).empty()) return quantity;
  return "";
}

// The references and the film's own runs that have the quantity, references first.
Names followed_runs(const CaseAssessment& assessment, const std::string& quantity,
                    const Names& runs) {
  Names followed;
  for (const std::string& name : finest_runs(assessment, quantity))
    if (!is_simulation(run_named(assessment.definition, name))) followed.push_back(name);
  for (const std::string& name : runs)
    if (has_series(assessment.runs, name, quantity)) followed.push_back(name);
  return followed;
}

void cut_to(const std::pair<double, double>& times, Curve& curve) {
  const double slack = 1e-9 * times.second;  // of a multiple of the sample interval
  std::vector<bool> is_inside;
  for (const double x : curve.x)
    is_inside.push_back(x >= times.first - slack && x <= times.second + slack);
  for (std::vector<double>* values :
       {&curve.x, &curve.y, &curve.y_error, &curve.x_error, &curve.lower, &curve.upper}) {
    if (values->empty()) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < is_inside.size(); ++i)
      if (is_inside[i]) (*values)[kept++] = (*values)[i];
    values->resize(kept);
  }
}

Figure film_history(const CaseAssessment& assessment, const std::string& quantity,
                    const Names& runs, const std::pair<double, double>& times) {
  const CaseDefinition& definition = assessment.definition;
  const HistoryAxes axes = axes_with_units(definition, quantity);
  Figure figure;
  figure.id = definition.name + "-animation-history";
  figure.title = shown_quantity(definition, quantity).title + " during the animation";
  figure.x_label = axes.x_label;
  figure.y_label = axes.y_label;
  figure.x_range = times;
  figure.has_cursor = true;
  for (const std::string& run : runs) {
    Curve curve = history_curve(assessment, run, quantity, axes.scales);
    cut_to(times, curve);
    if (!curve.x.empty()) figure.curves.push_back(std::move(curve));
  }
  return figure;
}

// The run whose highest value chooses the poster: the first reference inside its range, or else the
// mesh, or else the film's first run.
std::string guiding_run(const CaseAssessment& assessment, const Names& followed) {
  const auto rank = [&](const std::string& name) {
    const RunDefinition& run = run_named(assessment.definition, name);
    if (!is_simulation(run)) return is_in_range(assessment, name) ? 0 : 3;
    return std::holds_alternative<InterFoamRun>(run.solver) ? 1 : 2;
  };
  return *std::min_element(
      followed.begin(), followed.end(),
      [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
}

struct Poster {
  std::size_t row = 0;
  std::string why;  // a sentence
};

// The moment next to the highest value of the guiding run, of those that all runs recorded if there
// are such.
Poster poster_of(const CaseAssessment& assessment, const std::string& quantity,
                 const std::string& guide, const Names& runs, const std::vector<double>& times) {
  const TimeSeries& series = assessment.runs.results.at(guide).at(quantity);
  double highest = -INFINITY, when = times.front();
  for (std::size_t i = 0; i < series.time.size(); ++i)
    if (series.time[i] >= times.front() && series.time[i] <= times.back() &&
        series.value[i] > highest)
      std::tie(highest, when) = std::pair{series.value[i], series.time[i]};
  const auto distance = [&](double time) {
    const bool is_whole = std::all_of(runs.begin(), runs.end(), [&](const std::string& run) {
      return snapshot_at(assessment, run, time);
    });
    return std::pair{!is_whole, std::abs(time - when)};
  };
  const auto nearest = std::min_element(
      times.begin(), times.end(), [&](double a, double b) { return distance(a) < distance(b); });
  return {static_cast<std::size_t>(nearest - times.begin()),
          fmt::format("Until it is played it stands at {:g} s, next to the highest {} of {}.",
                      *nearest, shown_quantity(assessment.definition, quantity).word, guide)};
}

// Says which runs recorded only a part of the moments, or none.
std::string recorded_text(const CaseAssessment& assessment, const Names& runs,
                          const std::vector<double>& times) {
  std::string text;
  Names families;
  for (const std::string& run : runs) {
    families.push_back(family(run_named(assessment.definition, run)));
    const auto count = std::count_if(times.begin(), times.end(), [&](double time) {
      return snapshot_at(assessment, run, time);
    });
    if (count < std::ssize(times))
      text += fmt::format(" {} recorded {} of these moments.", run, count);
  }
  for (const std::string& run : finest_runs(assessment, [](const RunResult&) { return true; }))
    if (is_simulation(run_named(assessment.definition, run)) &&
        !is_one_of(family(run_named(assessment.definition, run)), families))
      text += fmt::format(" {} recorded none of them.", run);
  return text;
}

FieldFigure frames(const CaseAssessment& assessment, const Names& runs,
                   const std::vector<double>& times) {
  const CaseDefinition& definition = assessment.definition;
  const int decimals =
      std::max(2, static_cast<int>(std::ceil(-std::log10(definition.sample_interval) - 1e-9)));
  FieldFigure figure;
  figure.id = definition.name + "-animation";
  figure.title = fmt::format("The flow from {:g} to {:g} s", times.front(), times.back());
  figure.value_label = field_quantity;
  figure.columns = static_cast<int>(runs.size());
  figure.film = Film{.times = times, .labels = {}, .names = runs};
  for (const double time : times) {
    figure.film->labels.push_back(moment_label(definition, time, decimals));
    for (const std::string& run : runs) figure.panels.push_back(panel_of(assessment, run, time));
  }
  return figure;
}

}  // namespace

std::optional<FieldFigure> case_film(const CaseAssessment& assessment) {
  const CaseDefinition& definition = assessment.definition;
  std::vector<double> times = definition.animation_times;
  const Names runs = finest_runs(assessment, [&](const RunResult& result) {
    return std::any_of(times.begin(), times.end(),
                       [&](double time) { return snapshot_at(definition, result, time); });
  });
  std::erase_if(times, [&](double time) {
    return std::none_of(runs.begin(), runs.end(),
                        [&](const std::string& run) { return snapshot_at(assessment, run, time); });
  });
  const std::string quantity = followed_quantity(assessment);
  const Names followed = followed_runs(assessment, quantity, runs);
  if (times.size() < 2 || followed.empty()) return std::nullopt;
  FieldFigure figure = frames(assessment, runs, times);
  const Poster poster =
      poster_of(assessment, quantity, guiding_run(assessment, followed), runs, times);
  figure.film->poster = poster.row;
  figure.film->history =
      film_history(assessment, quantity, followed, {times.front(), times.back()});
  figure.caption = fmt::format(
      "Animation of {} moments, {:g} s apart, of the finest run of each scheme and solver; press "
      "Play, or move the slider. {} Below: the {} of these runs and of the references; the upright "
      "line is the moment shown.{}{} {}",
      times.size(), definition.animation_times[1] - definition.animation_times[0], poster.why,
      shown_quantity(definition, quantity).word, cut_off_text(figure.film->history),
      recorded_text(assessment, runs, times), field_caption(definition, runs));
  return figure;
}

}  // namespace slosh
