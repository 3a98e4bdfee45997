#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/tables/peak_table.hpp"

namespace slosh {
namespace {

std::vector<std::string> pressure_gauge_names(const CaseDefinition& definition) {
  std::vector<std::string> names;
  for (const PressureGaugeDefinition& gauge : definition.pressure_gauges)
    names.push_back(gauge.name);
  return names;
}

// Each impact is sought within a quarter of a period of its time (impact_peaks.hpp). These
// intervals must lie within the run and must not overlap.
std::vector<double> read_times(const TomlTable& impacts, double period, double duration) {
  const double margin = period / 4;
  const Rule<double> inside_the_run{
      fmt::format("a number from {:.6g} to {:.6g}, in s: a quarter of the period inside the run",
                  margin, duration - margin),
      [=](double time) { return time >= margin && time <= duration - margin; }};
  std::vector<double> times = impacts.increasing_numbers("times_s", inside_the_run);
  if (times.empty()) impacts.refuse("times_s", "an array of at least one number, in s");
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] - times[i - 1] >= 2 * margin))
      impacts.refuse("times_s", fmt::format("numbers at least half a period ({:.6g}) apart, in s",
                                            2 * margin));
  return times;
}

std::vector<double> read_of_each_impact(const TomlTable& impacts, const char* key, const char* unit,
                                        std::size_t count) {
  std::vector<double> values = impacts.numbers(key, positive(unit));
  if (values.size() != count)
    impacts.refuse(key, fmt::format("as many numbers as times_s has, {}, in {}", count, unit));
  return values;
}

// The motion's period; of a single impact, which no period brings, four times the time within which
// it is sought.
double read_period(const TomlTable& impacts) {
  if (!impacts.has("sought_within_s")) return impacts.get("period_s", positive("s"));
  if (impacts.has("period_s"))
    impacts.refuse("sought_within_s", "no such key beside period_s, a quarter of which it is");
  return 4 * impacts.get("sought_within_s", positive("s"));
}

void read_plateau(const TomlTable& impacts, double duration, ImpactsDefinition& read) {
  read.plateau_half_width = impacts.find("plateau_half_width_Pa", positive("Pa"));
  bool given = read.plateau_half_width.has_value();
  for (const char* key : {"plateau_begin_s", "plateau_end_s", "plateau_Pa"})
    given |= impacts.has(key);
  // A case of repeated impacts must publish one, as it always had to.
  if (!given && impacts.has("sought_within_s")) return;
  read.plateau_begin = impacts.get("plateau_begin_s", not_negative("s"));
  read.plateau_end =
      impacts.get("plateau_end_s", end_after("plateau_begin_s", read.plateau_begin, duration));
  read.plateau = impacts.get("plateau_Pa", positive("Pa"));
}

void read_arrivals(const TomlTable& impacts, ImpactsDefinition& read) {
  if (!impacts.has("arrival_share") && !impacts.has("arrivals_s")) {
    for (const char* key : {"arrivals_half_width_s", "impulse_duration_s", "impulses_Pa_s",
                            "impulses_half_width_Pa_s"})
      if (impacts.has(key)) impacts.refuse(key, "no such key without arrival_share and arrivals_s");
    return;
  }
  const Rule<double> a_share{"a number > 0 and < 1, of the published peak",
                             [](double share) { return share > 0 && share < 1; }, 0.5};
  read.arrivals =
      ArrivalsDefinition{impacts.get("arrival_share", a_share),
                         read_of_each_impact(impacts, "arrivals_s", "s", read.times.size()),
                         impacts.find("arrivals_half_width_s", positive("s"))};
  if (!impacts.has("impulse_duration_s") && !impacts.has("impulses_Pa_s")) {
    if (impacts.has("impulses_half_width_Pa_s"))
      impacts.refuse("impulses_half_width_Pa_s", "no such key without impulses_Pa_s");
    return;
  }
  read.impulses =
      ImpulsesDefinition{impacts.get("impulse_duration_s", positive("s")),
                         read_of_each_impact(impacts, "impulses_Pa_s", "Pa s", read.times.size()),
                         impacts.find("impulses_half_width_Pa_s", positive("Pa s"))};
}

void read_rise_times(const TomlTable& impacts, ImpactsDefinition& read) {
  if (impacts.has("rise_times_s"))
    read.rise_times =
        RiseTimesDefinition{read_of_each_impact(impacts, "rise_times_s", "s", read.times.size()),
                            impacts.find("rise_times_half_width_s", positive("s"))};
  else if (impacts.has("rise_times_half_width_s"))
    impacts.refuse("rise_times_half_width_s", "no such key without rise_times_s");
}

void read_repeats(const TomlTable& impacts, const std::filesystem::path& experiments,
                  ImpactsDefinition& read) {
  const auto table = impacts.find("peak_table", path_below_experiments("a peak table's"));
  if (!table) return;
  const std::size_t most = PeakTable{}.impacts.size();
  if (read.times.size() > most)
    impacts.refuse("peak_table",
                   fmt::format("at most {} times_s beside it, one for each impact of a "
                               "row; here are {}",
                               most, read.times.size()));
  const bool named = !experiments.empty();
  read.peak_table = (named ? experiments : "SLOSH_EXPERIMENTS") / std::filesystem::path(*table);
  if (!named || !is_record_in(experiments, impacts, "peak_table", read.peak_table)) return;
  const PeakTable peaks = read_peak_table(read.peak_table);
  const auto used = static_cast<std::ptrdiff_t>(read.times.size());
  read.repeats.assign(peaks.impacts.begin(), peaks.impacts.begin() + used);
}

// A gauge measures the surface where that is at rest.
Rule<double> over_still_surface(const CaseDefinition& definition) {
  if (is_rectangle(definition.tank))
    return {fmt::format("a number from 0 to the tank's length ({}), in m from the left wall",
                        definition.tank.length),
            [length = definition.tank.length](double x) { return x >= 0 && x <= length; }, 0};
  const Extent surface = still_surface(definition);
  return {fmt::format("a number from {:.6g} to {:.6g}, in m: the still surface at the fill depth "
                      "({}) reaches from there to there",
                      surface.left, surface.right, definition.liquid.fill_depth),
          [surface](double x) { return x >= surface.left && x <= surface.right; }, surface.left};
}

void refuse_keys_of_other_shape(const TomlTable& gauge, bool on_rectangle) {
  const char *own = on_rectangle ? "wall and position_m" : "x_m and z_m",
             *shape = on_rectangle ? "a rectangular tank" : "a tank that is no rectangle";
  const std::vector<const char*> others = on_rectangle
                                              ? std::vector<const char*>{"x_m", "z_m"}
                                              : std::vector<const char*>{"wall", "position_m"};
  for (const char* key : others)
    if (gauge.has(key))
      gauge.refuse(key,
                   fmt::format("no {} in {}, where {} tell a sensor's place", key, shape, own));
}

// Reads the place of a sensor and returns the greatest width that it may have there [m]. The
// tolerance is for the rounding of a sensor that ends where the wall does.
double read_place_on_wall(const TomlTable& gauge, const TankDefinition& tank,
                          PressureGaugeDefinition& read) {
  read.wall = gauge.choice("wall", "a wall", wall_names);
  const bool is_level = read.wall == Wall::bottom || read.wall == Wall::roof;
  const double extent = is_level ? tank.length : tank.height;
  read.position = gauge.get<double>(
      "position_m",
      {fmt::format("a number from 0 to the tank's {} ({}), in m from the {}",
                   is_level ? "length" : "height", extent, is_level ? "left wall" : "bottom"),
       [extent](double at) { return at >= 0 && at <= extent; }});
  return 2 * std::min(read.position, extent - read.position) + 1e-9 * extent;
}

// The place is written with a few decimals and put on the outline.
double read_place_on_outline(const TomlTable& gauge, const TankDefinition& tank,
                             PressureGaugeDefinition& read) {
  const double size = std::max(tank.length, tank.height), tolerance = 1e-6 * size;
  const Corner given{gauge.get("x_m", any_number("m")), gauge.get("z_m", any_number("m"))};
  const PlaceOnOutline on = nearest_on(tank.outline, given);
  if (!(on.distance <= tolerance))
    gauge.refuse("x_m", fmt::format("x_m and z_m of a place on the tank's outline to within {:.1g} "
                                    "m, where the nearest to ({:g}, {:g}) is ({:.9g}, {:.9g})",
                                    tolerance, given.x, given.z, on.place.x, on.place.z));
  read.wall = Wall::bottom;
  read.at = on.place;
  return 2 * std::min(on.along, side_length(tank.outline, on.side) - on.along) + 1e-9 * size;
}

}  // namespace

GaugeDefinition read_gauge(const TomlTable& gauge, const CaseDefinition& definition) {
  gauge.allow_only(keys_of("gauge"));
  return {.name = gauge.get("name", file_safe_name()),
          .x = gauge.get("x_m", over_still_surface(definition))};
}

PressureGaugeDefinition read_pressure_gauge(const TomlTable& gauge,
                                            const CaseDefinition& definition) {
  gauge.allow_only(keys_of("pressure_gauge"));
  const bool on_rectangle = is_rectangle(definition.tank);
  refuse_keys_of_other_shape(gauge, on_rectangle);
  PressureGaugeDefinition read{};
  read.name = gauge.get("name", file_safe_name());
  const double widest = on_rectangle ? read_place_on_wall(gauge, definition.tank, read)
                                     : read_place_on_outline(gauge, definition.tank, read);
  read.width =
      gauge
          .find<double>(
              "width_m",
              {fmt::format("a number >= 0 and <= {:.6g}, in m: the whole sensor lies on the wall",
                           widest),
               [widest](double width) { return width >= 0 && width <= widest; }})
          .value_or(0);
  const double highest = 0.5 / definition.sample_interval;
  read.filter_cutoff = gauge.find<double>(
      "filter_cutoff_Hz",
      {fmt::format("a number > 0 and below half the sampling rate ({:.6g}), in Hz", highest),
       [highest](double cutoff) { return cutoff > 0 && cutoff < highest; }});
  return read;
}

ProbeDefinition read_probe(const TomlTable& probe, const CaseDefinition& definition) {
  probe.allow_only(keys_of("probe"));
  const auto inside = [](const char* extent, double most, const char* from) {
    return Rule<double>{
        fmt::format("a number from 0 to the tank's {} ({}), in m from the {}", extent, most, from),
        [most](double at) { return at >= 0 && at <= most; }, 0};
  };
  const ProbeDefinition read{
      .name = probe.get("name", file_safe_name()),
      .x = probe.get("x_m", inside("length", definition.tank.length, "left wall")),
      .z = probe.get("z_m", inside("height", definition.tank.height, "bottom"))};
  if (!is_rectangle(definition.tank) && !contains(definition.tank.outline, {read.x, read.z})) {
    const auto [left, right] = extent_at(definition.tank.outline, read.z);
    probe.refuse("x_m", fmt::format("a place inside the tank's outline, which reaches from x = "
                                    "{:.6g} to {:.6g} at z_m = {:g}, in m",
                                    left, right, read.z));
  }
  return read;
}

std::vector<Wall> read_wall_forces(const TomlTable& root) {
  std::vector<Wall> walls;
  const std::string expected =
      fmt::format("a list of walls ({}), each once", fmt::join(all_names(wall_names), ", "));
  for (const PlacedText& text : root.texts("wall_forces", any_text())) {
    const std::vector<std::string> names = all_names(wall_names);
    if (std::find(names.begin(), names.end(), text.text) == names.end())
      root.refuse("wall_forces", expected);
    walls.push_back(value_of(text.text, wall_names));
    if (std::count(walls.begin(), walls.end(), walls.back()) > 1)
      root.refuse("wall_forces", expected);
  }
  return walls;
}

ImpactsDefinition read_impacts(const TomlTable& impacts, const CaseDefinition& definition,
                               const std::filesystem::path& experiments) {
  impacts.allow_only(keys_of("impacts"));
  ImpactsDefinition read{};
  read.gauge = impacts.choice("gauge", "a pressure gauge", pressure_gauge_names(definition));
  read.period = read_period(impacts);
  read.times = read_times(impacts, read.period, definition.duration);
  if (impacts.has("sought_within_s") && read.times.size() > 1)
    impacts.refuse("sought_within_s", "period_s in its place where there are several times_s");
  const std::size_t count = read.times.size();
  read.peak_means = read_of_each_impact(impacts, "peaks_Pa", "Pa", count);
  if (impacts.has("peaks_sd_Pa") || !impacts.has("sought_within_s"))
    read.peak_deviations = read_of_each_impact(impacts, "peaks_sd_Pa", "Pa", count);
  read.peaks_half_width = impacts.find("peaks_half_width_Pa", positive("Pa"));
  read_plateau(impacts, definition.duration, read);
  read_arrivals(impacts, read);
  read_rise_times(impacts, read);
  read_repeats(impacts, experiments, read);
  read.source = impacts.get("source", any_text());
  return read;
}

}  // namespace slosh
