#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "verification/case/cubic_spline.hpp"
#include "verification/case/motion.hpp"
#include "verification/case/motion/motion_times.hpp"
#include "verification/case_file/case_sections.hpp"
#include "verification/case_file/key_table.hpp"
#include "verification/input/input_files.hpp"
#include "verification/input/tables/time_table.hpp"

namespace slosh {

using namespace key;
using namespace needed;

namespace {

// [deg]. A larger angle is more than one turn, and probably given in another unit.
constexpr double largest_angle = 360;

// [deg]. The tank starts level. The tolerance is far above rounding errors and far below any roll.
constexpr double level_angle = 1e-3;

// Integrates the cubic spline through accelerations twice, from the position 0 and the velocity 0
// at the time 0. Over an interval of the length h between the values a, b with the spline's second
// derivatives m, n,
//   velocity + h (a + b)/2 - h^3 (m + n)/24,
//   position + h velocity + h^2 (2 a + b)/6 - h^4 (8 m + 7 n)/360,
// or with m = n = 0 the straight segments through them. The cubic spline through the positions then
// has these accelerations exactly: it has no knot at its second and its last but one point, which
// are put amid the first and the last segment.
TableMotion integrated(const TableMotion& accelerations, bool straight) {
  const CubicSpline spline(accelerations.time, accelerations.value);
  const auto on_segment = [&](double t) {
    const std::vector<double>&time = accelerations.time, &value = accelerations.value;
    const auto after = std::upper_bound(time.begin() + 1, time.end() - 1, t) - time.begin();
    const auto i = static_cast<std::size_t>(after);
    return value[i - 1] + (value[i] - value[i - 1]) * (t - time[i - 1]) / (time[i] - time[i - 1]);
  };
  std::vector<double> times = accelerations.time;
  if (straight) {
    const auto first = std::upper_bound(times.begin(), times.end(), 0.0);
    times.insert(first, *first / 2);
    times.insert(times.end() - 1, (times.back() + times[times.size() - 2]) / 2);
  }
  TableMotion motion{accelerations.file, {0}, {0}};
  double velocity = 0, position = 0;
  for (const double t : times) {
    const double start = motion.time.back(), h = t - start;
    if (!(h > 1e-9 * shortest_table_step)) continue;
    const double a = straight ? on_segment(start) : spline.value(start),
                 b = straight ? on_segment(t) : spline.value(t),
                 m = straight ? 0 : spline.second_derivative(start),
                 n = straight ? 0 : spline.second_derivative(t);
    position += h * velocity + h * h * (2 * a + b) / 6 - h * h * h * h * (8 * m + 7 * n) / 360;
    velocity += h * (a + b) / 2 - h * h * h * (m + n) / 24;
    motion.time.push_back(t);
    motion.value.push_back(position);
  }
  return motion;
}

constexpr std::size_t most_rows = 2'000'000;

// Returns the rows with the case's times.
TimeTable read_rows(const TableFile& table, const std::string& position,
                    const std::string& acceleration) {
  TimeTable rows = read_time_table(table.file, {position, acceleration});
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(table.file, rows.lines[row], "time_s", fmt::format("{}", rows.time[row]),
                      expected + ", in s" +
                          (table.time_offset == 0 ? ""
                                                  : fmt::format(", with time_offset_s = {} added",
                                                                table.time_offset)));
  };
  if (rows.time.size() > most_rows)
    refuse(most_rows, fmt::format("at most {} rows: of those that are nearer to one another than "
                                  "{} s one counts",
                                  most_rows, shortest_table_step));
  if (!(rows.time.front() + table.time_offset <= 0)) refuse(0, "0 or less in the first row");
  // An offset leaves a table that is as long as the case short by rounding.
  if (!(rows.time.back() + table.time_offset >= table.duration * (1 - 1e-9)))
    refuse(rows.time.size() - 1,
           fmt::format("a last time of at least the case's duration ({})", table.duration));
  if (!(rows.time[rows.time.size() - 3] + table.time_offset > 0))
    refuse(rows.time.size() - 3, "three rows after 0 or more");
  // Of points that are nearer one is left out: of a step, which would become the ramp to the next.
  constexpr double longest = 10 * shortest_table_step;
  for (std::size_t row = 1; row + 1 < rows.time.size(); ++row)
    if (rows.column == acceleration &&
        rows.time[row] - rows.time[row - 1] < (1 - 1e-9) * shortest_table_step &&
        rows.time[row + 1] - rows.time[row] > longest)
      refuse(row, fmt::format("a time {} s or more after the row before, as the row after is more "
                              "than {} s away",
                              shortest_table_step, longest));
  for (double& time : rows.time) time += table.time_offset;
  return rows;
}

TableMotion motion_of(const TableFile& table, const TimeTable& rows) {
  const bool of_accelerations = rows.column.starts_with("acceleration");
  TableMotion motion{table.file, rows.time, rows.value};
  if (of_accelerations) motion = integrated(motion, table.straight);
  motion = thinned(motion, shortest_table_step);
  motion.of_accelerations = of_accelerations;
  for (std::size_t i = 0; i < rows.time.size(); ++i)
    if (rows.time[i] >= 0 && rows.time[i] <= table.duration)
      motion.largest = std::max(motion.largest, std::abs(rows.value[i]));
  return motion;
}

// The three ways to give a frequency, of which a table uses one.
struct FrequencyKey {
  const char *name, *unit;
  double (*angular)(double);  // [rad/s]
};

constexpr double full_turn = 2 * std::numbers::pi;
constexpr FrequencyKey frequency_keys[] = {
    {"angular_frequency_rad_s", "rad/s", [](double angular) { return angular; }},
    {"frequency_Hz", "Hz", [](double frequency) { return full_turn * frequency; }},
    {"period_s", "s", [](double period) { return full_turn / period; }}};

// [tank lengths]. With an axis further away, a roll becomes a surge and rounding errors become
// noise.
constexpr double farthest_axis = 1000;

// The differences between the motions of a surge and a roll.
struct HistoryForm {
  std::string table, amplitude_key;  // of key_table.hpp
  KeyValue amplitude;
  double si_per_unit;
  TableMotion (*read_table)(const TableFile&);
  std::vector<std::string> other_keys = {};
};

const HistoryForm surges{"surge", "amplitude_m", number("m").above(0), 1, read_surge_table},
    rolls{"roll",
          "amplitude_deg",
          number("deg").above(0).at_most(largest_angle),
          radians_per_degree,
          read_roll_table,
          {"axis_x_m", "axis_z_m"}};

const KeyValue phases = number("deg").from(-360, 360), ramps = number("periods").at_least(0);

std::filesystem::path file_beside(const TomlTable& table, const std::filesystem::path& case_file) {
  std::filesystem::path file = case_file.parent_path() / table.get("file", any_text());
  require_data_file(table, "file", file, case_file);
  return file;
}

std::vector<std::string> sine_keys(const HistoryForm& form) {
  std::vector<std::string> keys{form.amplitude_key, "phase_deg", "ramp_periods"};
  for (const std::string& key : names_of_frequency()) keys.push_back(key);
  return keys;
}

SineMotion read_sine(const TomlTable& table, const HistoryForm& form) {
  const auto read = [&](const KeyValue& value, const std::string& key) {
    return read_value<double>(value, table, key, {});
  };
  const std::optional<double> frequency = find_angular_frequency(table);
  return {.amplitude = read(form.amplitude, form.amplitude_key) * form.si_per_unit,
          .angular_frequency =
              frequency ? *frequency : table.get("angular_frequency_rad_s", positive("rad/s")),
          .ramp_periods = table.has("ramp_periods") ? read(ramps, "ramp_periods") : 0,
          .phase = table.has("phase_deg") ? read(phases, "phase_deg") * radians_per_degree : 0};
}

SumOfSines read_sines(const TomlTable& table, const HistoryForm& form) {
  SumOfSines sum;
  for (const TomlTable& sine : table.tables("sines")) {
    sine.allow_only(sine_keys(form));
    sum.sines.push_back(read_sine(sine, form));
  }
  if (sum.sines.size() < 2)
    table.refuse("sines", "two sines or more; a single one is type = \"sine\"");
  return sum;
}

MotionHistory read_history(const TomlTable& table, const HistoryForm& form,
                           const CaseDefinition& definition) {
  const auto allow = [&](std::vector<std::string> keys) {
    keys.insert(keys.end(), form.other_keys.begin(), form.other_keys.end());
    table.allow_only(keys);
  };
  table.allow_only(keys_of(form.table));
  const std::string type = table.choice("type", "a motion", {"sine", "sines", "table"});
  if (type == "table") {
    allow({"type", "file", "time_offset_s", "segments"});
    const bool straight =
        table.has("segments") &&
        table.choice("segments", "a way between points", {"spline", "straight"}) == "straight";
    const double offset = table.find("time_offset_s", any_number("s")).value_or(0);
    const TableMotion motion = form.read_table(
        {file_beside(table, definition.file), definition.duration, offset, straight});
    if (straight && !motion.of_accelerations)
      table.refuse("segments", "\"spline\" for a table of positions, whose corners would be blows");
    return motion;
  }
  if (type == "sines") {
    allow({"type", "sines"});
    return read_sines(table, form);
  }
  std::vector<std::string> keys = sine_keys(form);
  keys.insert(keys.begin(), "type");
  allow(keys);
  return read_sine(table, form);
}

Rule<double> near_the_tank(double tank_length, const char* unit) {
  const double farthest = farthest_axis * tank_length;
  return {fmt::format("a number from -{0} to {0} ({1} tank lengths), in {2}", farthest,
                      farthest_axis, unit),
          [farthest](double place) { return place >= -farthest && place <= farthest; }, 0};
}

// A tank that starts tilted has a surface that is not parallel to its bottom, which neither SPH's
// lattice nor interFoam's mesh starts from. The reader of a table refuses it itself.
void refuse_tilted_start(const TomlTable& roll, const MotionHistory& angle) {
  double start = 0;  // [deg]
  for (const SineMotion& sine : sines_of(angle))
    if (sine.ramp_periods == 0) start += sine.amplitude * std::sin(sine.phase) / radians_per_degree;
  if (!(std::abs(start) <= level_angle))
    roll.refuse(
        roll.has("sines") ? "sines" : "phase_deg",
        fmt::format("an angle of 0 to within {} at the start, in deg, where this is {:.4g}: "
                    "the tank starts level; ramp_periods > 0 lets any phase begin level",
                    level_angle, start));
}

RollDefinition read_roll(const TomlTable& roll, const CaseDefinition& definition) {
  const double length = definition.tank.length;
  RollDefinition read{.angle = read_history(roll, rolls, definition),
                      .axis_x = roll.get("axis_x_m", near_the_tank(length, "m from the left wall")),
                      .axis_z = roll.get("axis_z_m", near_the_tank(length, "m from the bottom"))};
  refuse_tilted_start(roll, read.angle);
  return read;
}

void finish_motion(const TomlTable& motion, const CaseDefinition& definition,
                   MotionDefinition& read) {
  if (motion.has("surge")) read.surge = read_history(motion.table("surge"), surges, definition);
  if (motion.has("roll")) read.roll = read_roll(motion.table("roll"), definition);
  const bool says_still = motion.flag("still");
  if (motion.has("still") && says_still != read.still())
    motion.refuse("still", read.still() ? "true, or [motion.surge] or [motion.roll] instead"
                                        : "no such key beside [motion.surge] or [motion.roll]");
  if (read.still() && !says_still)
    motion.refuse_table("{}", "still = true, [motion.surge], [motion.roll] or both of these");
}

std::vector<KeyEntry> keys_of_sine(const HistoryForm& form, const Needed& amplitude,
                                   const Needed& frequency, const std::string& of_phase,
                                   const std::string& of_ramp) {
  return {{form.amplitude_key, form.amplitude, amplitude},
          {"angular_frequency_rad_s", number("rad/s").above(0), frequency},
          {"frequency_Hz", number("Hz").above(0), frequency},
          {"period_s", number("s").above(0), frequency},
          {"phase_deg", phases, no, of_phase},
          {"ramp_periods", ramps, no, of_ramp}};
}

// The tables of a motion's keys and of those of one of its sines.
std::vector<KeyTable> tables_of(const HistoryForm& form, const std::string& meaning,
                                const std::string& of_phase, const std::string& of_file,
                                const std::vector<KeyEntry>& of_axis) {
  const std::string heading = "[motion." + form.table + "]",
                    of_sines = "[[motion." + form.table + ".sines]]";
  std::vector<KeyEntry> keys = keys_of_sine(
      form, with("type", "sine"), one_of_three_with("type", "sine"), of_phase,
      "The time over which a sine grows to its amplitude; refused with a table. Default: 0.");
  keys.insert(keys.begin(), {"type", one_of({"sine", "sines", "table"}), yes});
  const std::vector<KeyEntry> of_table{
      {"sines", table(of_sines), with("type", "sines")},
      {"file", text("path, relative to the case file"), with("type", "table"), of_file},
      {"time_offset_s", number("s"), no,
       "Added to the times of a table's file: with -12.5 the file's 12.5 s are the case's 0 s. "
       "Refused with a sine. Default: 0."},
      {"segments", one_of({"spline", "straight"}), no,
       "How a table of accelerations goes from point to point. A spline overshoots where the "
       "acceleration has corners, as at the begin and the end of braking, and `explain` tells by "
       "how much; straight segments do not. Refused with a sine, and \"straight\" with positions. "
       "Default: \"spline\"."}};
  keys.insert(keys.end(), of_table.begin(), of_table.end());
  keys.insert(keys.end(), of_axis.begin(), of_axis.end());
  return {key_table(form.table, heading, "no", meaning, keys),
          key_table(
              form.table + ".sines", of_sines, "with type = \"sines\"",
              fmt::format(
                  "The motion is the sum of two sines or more, each with its own ramp. They read "
                  "best as one list, which may run over several lines: `sines = [{{ {0} = "
                  "0.02, period_s = 1.3 }}, {{ {0} = 0.005, period_s = 0.7, phase_deg = 90 "
                  "}}]`. Each frequency has a forced mode: forced_1, forced_2, ..., of which those "
                  "of a surge come first.",
                  form.amplitude_key),
              keys_of_sine(form, yes, one_of_three(), "", "Periods of this sine."))};
}

}  // namespace

std::vector<std::string> names_of_frequency(const std::string& prefix) {
  std::vector<std::string> names;
  for (const FrequencyKey& key : frequency_keys) names.push_back(prefix + key.name);
  return names;
}

std::optional<double> find_angular_frequency(const TomlTable& table, const std::string& prefix) {
  std::optional<double> found;
  for (const FrequencyKey& key : frequency_keys) {
    const std::string name = prefix + key.name;
    if (found && table.has(name))
      table.refuse(name,
                   fmt::format("exactly one of {}", fmt::join(names_of_frequency(prefix), " | ")));
    if (const auto given = table.find(name, positive(key.unit))) found = key.angular(*given);
  }
  return found;
}

TableMotion read_surge_table(const TableFile& table) {
  return motion_of(table, read_rows(table, "displacement_m", "acceleration_m_s2"));
}

TableMotion read_roll_table(const TableFile& table) {
  const TimeTable rows = read_rows(table, "angle_deg", "acceleration_deg_s2");
  const auto refuse = [&](std::size_t row, const std::string& expected) {
    throw table_error(table.file, rows.lines[row], rows.column, fmt::format("{}", rows.value[row]),
                      expected);
  };
  TableMotion motion = motion_of(table, rows);
  const auto after = std::upper_bound(rows.time.begin(), rows.time.end(), 0.0);
  if (!(std::abs(motion.value.front()) <= level_angle))
    refuse(static_cast<std::size_t>(after - rows.time.begin()) - 1,
           fmt::format("an angle of 0 to within {} at the start, in deg: the tank starts level",
                       level_angle));
  const std::vector<double>& angles = rows.column == "angle_deg" ? rows.value : motion.value;
  for (std::size_t row = 0; row < angles.size(); ++row)
    if (!(std::abs(angles[row]) <= largest_angle))
      refuse(std::min(row, rows.value.size() - 1),
             fmt::format("angles from -{0} to {0}, in deg", largest_angle));
  for (double& angle : motion.value) angle *= radians_per_degree;
  motion.largest *= radians_per_degree;
  return motion;
}

const FieldTable<MotionDefinition> motion_keys{
    {"motion", "[motion]", "yes", "The tank stands still, surges, rolls, or does both."},
    {{{"still", constant("true"), where("where neither table is there"), "The tank stands."}},
     {{"surge", table("[motion.surge]"), no}},
     {{"roll", table("[motion.roll]"), no}}},
    finish_motion};

std::vector<KeyTable> motion_tables() {
  std::vector<KeyTable> tables = tables_of(
      surges, "The tank's horizontal displacement.",
      "The phase of A sin(omega t + phase); refused with a table. Default: 0.",
      "A CSV file with the columns time_s,displacement_m, from the time 0 to duration_s or beyond, "
      "joined by a cubic spline. Or with time_s,acceleration_m_s2: the spline through these is "
      "integrated twice, from the position 0 and the velocity 0 at the time 0. Points less than 2 "
      "ms after another are left out. A table whose acceleration is mostly noise is doubted.",
      {});
  std::ranges::move(
      tables_of(
          rolls,
          "The tank's rotation about an axis, which moves with a surge and may lie outside the "
          "tank.",
          "The same as for a surge. The tank starts level, so that another phase than 0 or 180 "
          "needs a ramp.",
          "A CSV file with the columns time_s,angle_deg, from the time and the angle 0 to "
          "duration_s or beyond, or with time_s,acceleration_deg_s2. The same as for a surge.",
          {{"axis_x_m", number("m from the left wall"), yes, "Within 1000 tank lengths."},
           {"axis_z_m", number("m from the bottom"), yes, "Within 1000 tank lengths."}}),
      std::back_inserter(tables));
  return tables;
}

}  // namespace slosh
