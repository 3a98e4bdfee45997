#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "verification/case/shape/outline.hpp"
#include "verification/case/shape/tank_shape.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/tables/time_table.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

// Each impact is sought within a quarter of a period of its time (impact_peaks.hpp). These
// intervals must lie within the run and must not overlap.
void refuse_times(const TomlTable& impacts, const ImpactsDefinition& read, double duration) {
  const double margin = read.period / 4;
  const std::vector<double>& times = read.times;
  if (times.empty()) impacts.refuse("times_s", "an array of at least one number, in s");
  for (std::size_t i = 0; i < times.size(); ++i)
    if (!(times[i] >= margin && times[i] <= duration - margin))
      impacts.refuse_element("times_s", i,
                             fmt::format("a number from {:.6g} to {:.6g}, in s: a quarter of the "
                                         "period inside the run",
                                         margin, duration - margin));
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] - times[i - 1] >= 2 * margin))
      impacts.refuse("times_s", fmt::format("numbers at least half a period ({:.6g}) apart, in s",
                                            2 * margin));
  if (impacts.has("sought_within_s") && times.size() > 1)
    impacts.refuse("sought_within_s", "period_s in its place where there are several times_s");
}

void refuse_other_counts(const TomlTable& impacts, std::size_t count) {
  for (const auto& [key, unit] : {std::pair{"peaks_Pa", "Pa"},
                                  {"peaks_sd_Pa", "Pa"},
                                  {"arrivals_s", "s"},
                                  {"impulses_Pa_s", "Pa s"},
                                  {"rise_times_s", "s"}})
    if (impacts.has(key) && impacts.numbers(key, any_number(unit)).size() != count)
      impacts.refuse(key, fmt::format("as many numbers as times_s has, {}, in {}", count, unit));
}

// The keys that need another one beside them.
void refuse_lonely_keys(const TomlTable& impacts) {
  if (impacts.has("sought_within_s") && impacts.has("period_s"))
    impacts.refuse("sought_within_s", "no such key beside period_s, a quarter of which it is");
  const auto refuse = [&](const char* key, bool alone, const char* without) {
    if (impacts.has(key) && alone)
      impacts.refuse(key, fmt::format("no such key without {}", without));
  };
  const bool arrivals = impacts.has("arrival_share") || impacts.has("arrivals_s"),
             impulses = impacts.has("impulse_duration_s") || impacts.has("impulses_Pa_s");
  for (const char* key :
       {"arrivals_half_width_s", "impulse_duration_s", "impulses_Pa_s", "impulses_half_width_Pa_s"})
    refuse(key, !arrivals, "arrival_share and arrivals_s");
  refuse("impulses_half_width_Pa_s", !impulses, "impulses_Pa_s");
  refuse("rise_times_half_width_s", !impacts.has("rise_times_s"), "rise_times_s");
}

const Bound half_the_sampling_rate{
    "half the sampling rate", [](const CaseDefinition& it) { return 0.5 / it.sample_interval; }};

bool has_period(const TomlTable& impacts) { return !impacts.has("sought_within_s"); }

// A case of repeated impacts must publish a plateau.
bool tells_plateau(const TomlTable& impacts) {
  bool given = has_period(impacts);
  for (const char* key :
       {"plateau_begin_s", "plateau_end_s", "plateau_Pa", "plateau_half_width_Pa"})
    given |= impacts.has(key);
  return given;
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

void finish_impacts(const TomlTable& impacts, const CaseDefinition& definition,
                    ImpactsDefinition& read) {
  refuse_lonely_keys(impacts);
  refuse_times(impacts, read, definition.duration);
  refuse_other_counts(impacts, read.times.size());
  read_repeats(impacts, definition.experiments, read);
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

void read_place(const TomlTable& gauge, const CaseDefinition& definition,
                PressureGaugeDefinition& read) {
  const bool on_rectangle = is_rectangle(definition.tank);
  refuse_keys_of_other_shape(gauge, on_rectangle);
  const double widest = on_rectangle ? read_place_on_wall(gauge, definition.tank, read)
                                     : read_place_on_outline(gauge, definition.tank, read);
  const Rule<double> width{
      fmt::format("a number >= 0 and <= {:.6g}, in m: the whole sensor lies on the wall", widest),
      [widest](double given) { return given >= 0 && given <= widest; }};
  read.width = gauge.find("width_m", width).value_or(0);
}

void refuse_place_outside(const TomlTable& probe, const CaseDefinition& definition,
                          const ProbeDefinition& read) {
  if (is_rectangle(definition.tank) || contains(definition.tank.outline, {read.x, read.z})) return;
  const auto [left, right] = extent_at(definition.tank.outline, read.z);
  probe.refuse("x_m", fmt::format("a place inside the tank's outline, which reaches from x = "
                                  "{:.6g} to {:.6g} at z_m = {:g}, in m",
                                  left, right, read.z));
}

}  // namespace

const FieldTable<GaugeDefinition> gauge_keys{
    {"gauge", "[[gauge]]", "at least one gauge of either kind",
     "A gauge of the surface's elevation. SPH measures the depth of liquid there, so a gauge "
     "should stand six particle spacings away from an obstacle: nearer, it reads too low."},
    {field("name", &GaugeDefinition::name, name(), yes, "The NAME in elevation@NAME."),
     field("x_m", &GaugeDefinition::x, number("m").from(0, tank_length).by(over_still_surface), yes,
           "The distance from the left wall. In a tank that is no rectangle it lies where the "
           "still surface reaches at the fill depth.")}};

const FieldTable<PressureGaugeDefinition> pressure_gauge_keys{
    {"pressure_gauge", "[[pressure_gauge]]", "at least one gauge of either kind",
     "A pressure sensor in a wall."},
    {field("name", &PressureGaugeDefinition::name, name(), yes, "The NAME in wall_pressure@NAME."),
     {{"wall", one_of({"left", "right", "bottom", "roof"}), where("in a rectangular tank")}},
     {{"position_m", number("m").at_least(0), where("in a rectangular tank"),
       "The middle of the sensor: above the bottom, or on the bottom or the roof from the left "
       "wall; within that wall."}},
     {{"x_m", number("m"), where("in another tank"),
       "With z_m: the middle of the sensor, a place on the outline to within a millionth of the "
       "tank's size."}},
     {{"z_m", number("m"), where("in another tank")}},
     {{"width_m", number("m").at_least(0), no,
       "The sensor's extent along the wall. The whole sensor must lie on the wall, of an outline "
       "on one side. Default: 0, a point."}},
     field("filter_cutoff_Hz", &PressureGaugeDefinition::filter_cutoff,
           number("Hz").above(0).below(half_the_sampling_rate), no,
           "Adds the series wall_pressure@NAME/filtered, through a low-pass filter.")},
    read_place};

const FieldTable<ProbeDefinition> probe_keys{
    {"probe", "[[probe]]", "no",
     "A place in the tank, which moves with it, where velocity and pressure are recorded. The "
     "velocity is relative to the tank, along its axes. While the surface is below the place, "
     "all three are 0. Linear theory records them only at a place below the still level, as it "
     "has no liquid above it."},
    {field("name", &ProbeDefinition::name, name(), yes,
           "The NAME in velocity_x@NAME, velocity_z@NAME and pressure@NAME."),
     field("x_m", &ProbeDefinition::x,
           number("m").from(0, tank_length).noting(" from the left wall"), yes,
           "The distance from the left wall. The place lies inside the tank's outline."),
     field("z_m", &ProbeDefinition::z, number("m").from(0, tank_height).noting(" from the bottom"),
           yes, "The height above the bottom.")},
    refuse_place_outside};

const FieldTable<ImpactsDefinition> impacts_keys{
    {"impacts", "[impacts]", "no",
     "Published impacts on a pressure gauge, for the metrics of impacts."},
    {field("gauge", &ImpactsDefinition::gauge,
           known("name of a pressure gauge", "a pressure gauge",
                 [](const CaseDefinition& it) { return names_of(it.pressure_gauges); }),
           yes),
     field("times_s", &ImpactsDefinition::times, increasing_list_of(number("s")), yes,
           "The published times of the peaks, one or more, at least half a period apart and a "
           "quarter of it inside the run."),
     field("period_s", &ImpactsDefinition::period, number("s").above(0),
           where("where sought_within_s is absent").when(has_period),
           "The period of the motion that brings the impacts."),
     field("sought_within_s", &ImpactsDefinition::period, number("s").above(0), no,
           "In place of period_s, for a single impact: it is sought this long to either side of "
           "its time, of which a quarter of the period is the measure otherwise.",
           4),
     field("peaks_Pa", &ImpactsDefinition::peak_means, list_of(number("Pa").above(0)), yes,
           "The published mean peak of each impact: as many as times_s."),
     field("peaks_sd_Pa", &ImpactsDefinition::peak_deviations, list_of(number("Pa").above(0)),
           beside("period_s").when(has_period),
           "The standard deviation of each, over the repeats."),
     field("peaks_half_width_Pa", &ImpactsDefinition::peaks_half_width, number("Pa").above(0), no,
           "Half the 95 % interval of the mean peaks."),
     field("plateau_begin_s", &ImpactsDefinition::plateau_begin, number("s").at_least(0),
           beside("period_s").when(tells_plateau),
           "The plateau may be left out beside sought_within_s."),
     field("plateau_end_s", &ImpactsDefinition::plateau_end,
           number("s").above(Bound("plateau_begin_s")).at_most(case_duration),
           beside("plateau_begin_s").when(tells_plateau)),
     field("plateau_Pa", &ImpactsDefinition::plateau, number("Pa").above(0),
           beside("plateau_begin_s").when(tells_plateau),
           "The published mean pressure between the two."),
     field("arrival_share", &ImpactsDefinition::arrivals, &ArrivalsDefinition::share,
           number().above(0).below(1).noting(": a share of the published peak"),
           beside("arrivals_s"),
           "An impact arrives when the pressure comes to this share of its published peak and "
           "holds it."),
     field("arrivals_s", &ImpactsDefinition::arrivals, &ArrivalsDefinition::times,
           list_of(number("s").above(0)), beside("arrival_share"),
           "The published arrivals: as many as times_s."),
     field("arrivals_half_width_s", &ImpactsDefinition::arrivals, &ArrivalsDefinition::half_width,
           number("s").above(0), no, "Half the 95 % interval of the arrivals."),
     field("rise_times_s", &ImpactsDefinition::rise_times, &RiseTimesDefinition::values,
           list_of(number("s").above(0)), no,
           "The published rise times, twice the time from half the peak to the peak, for the "
           "tables: as many as times_s."),
     field("rise_times_half_width_s", &ImpactsDefinition::rise_times,
           &RiseTimesDefinition::half_width, number("s").above(0), no,
           "Half the 95 % interval of the rise times."),
     field("impulse_duration_s", &ImpactsDefinition::impulses, &ImpulsesDefinition::duration,
           number("s").above(0), beside("impulses_Pa_s"),
           "The time from the arrival on over which the impulse is taken."),
     field("impulses_Pa_s", &ImpactsDefinition::impulses, &ImpulsesDefinition::values,
           list_of(number("Pa s").above(0)), beside("impulse_duration_s"),
           "The published impulses: as many as times_s."),
     field("impulses_half_width_Pa_s", &ImpactsDefinition::impulses,
           &ImpulsesDefinition::half_width, number("Pa s").above(0), no,
           "Half the 95 % interval of the impulses."),
     field("plateau_half_width_Pa", &ImpactsDefinition::plateau_half_width, number("Pa").above(0),
           no, "Half the 95 % interval of the plateau."),
     {{"peak_table", text("path below the directory of the user's records"), no,
       "The repeats' own peaks, of up to four impacts."}},
     field("source", &ImpactsDefinition::source, text(), yes)},
    finish_impacts};

void read_wall_forces(const KeyEntry& key, const TomlTable& root, const CaseDefinition&,
                      CaseDefinition& read) {
  if (!root.has(key.name)) return;
  const std::vector<std::string> names = all_names(wall_names);
  for (const PlacedText& text : root.texts(key.name, any_text())) {
    const bool is_wall = std::find(names.begin(), names.end(), text.text) != names.end();
    if (is_wall) read.wall_forces.push_back(value_of(text.text, wall_names));
    if (!is_wall ||
        std::count(read.wall_forces.begin(), read.wall_forces.end(), read.wall_forces.back()) > 1)
      root.refuse(key.name, fmt::format("a list of walls ({}), each once", fmt::join(names, ", ")));
  }
}

}  // namespace slosh
