#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/case_file/case_sections.hpp"

namespace slosh {

const std::vector<KeyTable>& case_key_tables() {
  using namespace key;
  using namespace needed;
  static const std::vector<KeyTable> all{
      key_table(
          "case", "Top level", "yes", "The first keys of a case file, and its tables.",
          {{"schema_version", constant("1"), yes, "The version of this format."},
           {"name", name(), yes, "The name of the case."},
           {"title", text(), yes, "The title in reports."},
           {"source", text(), yes, "Where the case comes from: paper, section, figure."},
           {"tags", list("list of texts"), no, "Words by which `--tag` selects the case."},
           {"gravity_m_s2", number("m/s2").at_least(0), no,
            fmt::format("It may be 0 only where the tank moves. Default: {}.", usual_gravity)},
           {"tank", table("[tank]"), yes},
           {"liquid", table("[liquid]"), yes},
           {"gas", table("[gas]"), no},
           {"obstacle", table("[[obstacle]]"), no},
           {"initial_wave", table("[initial_wave]"), no},
           {"motion", table("[motion]"), yes},
           {"time", table("[time]"), yes},
           {"animation", table("[animation]"), no},
           {"gauge", table("[[gauge]]"), at_least_one(" gauge of either kind")},
           {"pressure_gauge", table("[[pressure_gauge]]"), at_least_one(" gauge of either kind")},
           {"probe", table("[[probe]]"), no},
           {"wall_forces", list("list of \"left\", \"right\", \"bottom\", \"roof\""), no,
            "The walls on which the force is recorded: force_x@WALL and force_z@WALL. Runs are "
            "compared on the component normal to the wall. Beside outline_m or diameter_m a wall "
            "is "
            "what faces its way: \"left\" has the force x on all sides whose outward normal points "
            "to the left."},
           {"impacts", table("[impacts]"), no},
           {"comparison", table("[comparison]"), yes},
           {"run", table("[[run]]"), at_least_one("")},
           {"refinement", table("[[refinement]]"), no},
           {"input", table("[[input]]"), no},
           {"gate", table("[[gate]]"), no}}),
      tank_table,
      liquid_table,
      gas_table,
      obstacle_table,
      initial_wave_table,
      key_table(
          "motion", "[motion]", "yes", "The tank stands still, surges, rolls, or does both.",
          {{"still", constant("true"), where("where neither table is there"), "The tank stands."},
           {"surge", table("[motion.surge]"), no},
           {"roll", table("[motion.roll]"), no}}),
      key_table(
          "surge", "[motion.surge]", "no", "The tank's horizontal displacement.",
          {{"type", one_of({"sine", "sines", "table"}), yes},
           {"amplitude_m", number("m").above(0), with("type", "sine")},
           {"angular_frequency_rad_s", number("rad/s").above(0), one_of_three_with("type", "sine")},
           {"frequency_Hz", number("Hz").above(0), one_of_three_with("type", "sine")},
           {"period_s", number("s").above(0), one_of_three_with("type", "sine")},
           {"phase_deg", number("deg").from(-360, 360), no,
            "The phase of A sin(omega t + phase); refused with a table. Default: 0."},
           {"ramp_periods", number("periods").at_least(0), no,
            "The time over which a sine grows to its amplitude; refused with a table. Default: 0."},
           {"sines", table("[[motion.surge.sines]]"), with("type", "sines")},
           {"file", text("path, relative to the case file"), with("type", "table"),
            "A CSV file with the columns time_s,displacement_m, from the time 0 to duration_s or "
            "beyond, joined by a cubic spline. Or with time_s,acceleration_m_s2: the spline "
            "through these is integrated twice, from the position 0 and the velocity 0 at the time "
            "0. Points less than 2 ms after another are left out. A table whose acceleration is "
            "mostly noise is doubted."},
           {"time_offset_s", number("s"), no,
            "Added to the times of a table's file: with -12.5 the file's 12.5 s are the case's 0 "
            "s. Refused with a sine. Default: 0."},
           {"segments", one_of({"spline", "straight"}), no,
            "How a table of accelerations goes from point to point. A spline overshoots where the "
            "acceleration has corners, as at the begin and the end of braking, and `explain` tells "
            "by how much; straight segments do not. Refused with a sine, and \"straight\" with "
            "positions. Default: \"spline\"."}}),
      key_table("surge.sines", "[[motion.surge.sines]]", "with type = \"sines\"",
                "The motion is the sum of two sines or more, each with its own ramp. They read "
                "best as one list, which may run over several lines: `sines = [{ amplitude_m = "
                "0.02, period_s = 1.3 }, { amplitude_m = 0.005, period_s = 0.7, phase_deg = 90 "
                "}]`. Each frequency has a forced mode: forced_1, forced_2, ...",
                {{"amplitude_m", number("m").above(0), yes},
                 {"angular_frequency_rad_s", number("rad/s").above(0), one_of_three()},
                 {"frequency_Hz", number("Hz").above(0), one_of_three()},
                 {"period_s", number("s").above(0), one_of_three()},
                 {"phase_deg", number("deg").from(-360, 360), no},
                 {"ramp_periods", number("periods").at_least(0), no, "Periods of this sine."}}),
      key_table(
          "roll", "[motion.roll]", "no",
          "The tank's rotation about an axis, which moves with a surge and may lie outside the "
          "tank.",
          {{"type", one_of({"sine", "sines", "table"}), yes},
           {"amplitude_deg", number("deg").above(0).at_most(360), with("type", "sine")},
           {"angular_frequency_rad_s", number("rad/s").above(0), one_of_three_with("type", "sine")},
           {"frequency_Hz", number("Hz").above(0), one_of_three_with("type", "sine")},
           {"period_s", number("s").above(0), one_of_three_with("type", "sine")},
           {"phase_deg", number("deg").from(-360, 360), no,
            "The same as for a surge. The tank starts level, so that another phase than 0 or 180 "
            "needs a ramp."},
           {"ramp_periods", number("periods").at_least(0), no, "The same as for a surge."},
           {"sines", table("[[motion.roll.sines]]"), with("type", "sines")},
           {"file", text("path, relative to the case file"), with("type", "table"),
            "A CSV file with the columns time_s,angle_deg, from the time and the angle 0 to "
            "duration_s or beyond, or with time_s,acceleration_deg_s2. The same as for a surge."},
           {"time_offset_s", number("s"), no, "The same as for a surge."},
           {"segments", one_of({"spline", "straight"}), no, "The same as for a surge."},
           {"axis_x_m", number("m from the left wall"), yes, "Within 1000 tank lengths."},
           {"axis_z_m", number("m from the bottom"), yes, "Within 1000 tank lengths."}}),
      key_table("roll.sines", "[[motion.roll.sines]]", "with type = \"sines\"",
                "As for a surge. The forced modes of a surge come first.",
                {{"amplitude_deg", number("deg").above(0).at_most(360), yes},
                 {"angular_frequency_rad_s", number("rad/s").above(0), one_of_three()},
                 {"frequency_Hz", number("Hz").above(0), one_of_three()},
                 {"period_s", number("s").above(0), one_of_three()},
                 {"phase_deg", number("deg").from(-360, 360), no},
                 {"ramp_periods", number("periods").at_least(0), no, "Periods of this sine."}}),
      time_table,
      animation_table,
      gauge_table,
      pressure_gauge_table,
      probe_table,
      impacts_table,
      comparison_table,
      key_table(
          "run", "[[run]]", "at least one",
          "A solution of the case. These keys are common to all solvers; each solver adds its own. "
          "Where the name is a pattern, a key may hold a list: there is a run for every "
          "combination of the listed values.",
          {{"name", text("name, or a pattern of keys"), yes,
            "The run's name in gate rows, reports and file names. In a pattern {key} stands for "
            "the value at the key, with a 'p' for a '.'; {particle_spacing_mm} for that length in "
            "millimetres; {start_seed:02} for a number of two digits."},
           {"solver", text(), yes, "The solver: one of the tables below."},
           {"quick",
            KeyValue{KeyKind::flag_or_texts, "true or false, or a list of names or patterns"}, no,
            "Whether the run belongs to the quick form of campaigns, or which of the runs of a "
            "pattern."}}),
      sph_table,
      interfoam_table,
      linear_table,
      viscous_wave_table,
      potential_table,
      key_table(
          "run.record", "[[run]] with solver = \"record\", shipped", "no",
          "A published series that lies beside the case file. It serves only as a reference.",
          {{"file", text("path, relative to the case file"), yes,
            "A CSV file: time_s and a compared quantity with its unit, as in front_position_m."},
           {"time_offset_s", number("s"), no, "Added to the file's times. Default: 0."},
           {"earlier_run", flag(), no,
            "Whether the series is an earlier run of this harness. Only rows of kind = "
            "\"regression\" may then rest on it."},
           {"uncertainty", number("the record's unit").above(0), no,
            "Half the width of the record's 95 % interval."}},
          {"record"}),
      key_table("run.experiment", "[[run]] with solver = \"record\", supplied by the user", "no",
                "A published series below the directory that `--experiments` or "
                "`SLOSH_EXPERIMENTS` names. Rows that need it are not compared where it is absent.",
                {{"experiment", text("path below that directory"), yes, "A CSV file."},
                 {"time_column", text(), yes,
                  "The name of the column of times, in s where the file does not say it."},
                 {"value_column", text(), yes, "The name of the column of values."},
                 {"quantity", text("compared quantity"), yes, "What the record measures."},
                 {"unit", text("unit of the quantity"), yes, "The unit of the values."},
                 {"time_offset_s", number("s"), no, "The same as for a shipped record."},
                 {"scale", number().above(0), no,
                  "The values, and those of the band, are scale times their column. Default: 1."},
                 {"lower_column", text(), beside("upper_column"),
                  "The name of the column of a lower quantile of the experiment's repeats. The two "
                  "make a band about the values, for outside_band."},
                 {"upper_column", text(), beside("lower_column"), "The same of an upper quantile."},
                 {"uncertainty", number("the record's unit").above(0), no,
                  "The same as for a shipped record."}},
                {"record"}),
      external_table,
      stored_table,
      series_table,
      key_table(
          "run.pysph", "[[run]] with solver = \"pysph\"", "no",
          "PySPH, from Debian's package python3-pysph, by the driver that Slosh ships: see "
          "[PySPH](other_solvers.md#pysph). It is an external run of the method pysph_SCHEME. The "
          "tank surges or stands still, with or without an initial wave, and has no obstacle.",
          {{"scheme", one_of({"delta_sph", "edac", "adami"}), yes, "One of PySPH's own schemes."},
           {"particle_spacing_m", number("m").above(0), yes,
            "A whole fraction of the tank's length and of the fill depth, another one in each run "
            "of the scheme."}},
          {"pysph"}),
      key_table(
          "refinement", "[[refinement]]", "no",
          "Runs that differ in one number only. They give the order and the numerical uncertainty.",
          {{"name", name(), yes},
           {"number", text(), yes,
            "particle_spacing, smoothing_length_ratio, speed_of_sound, courant_number or mesh."},
           {"runs", list("list of run names"), yes,
            "Two or more, each once: SPH runs, with number = \"particle_spacing\" also the runs of "
            "one method of an external program, or with number = \"mesh\" the runs of one program "
            "of OpenFOAM."}}),
      key_table(
          "input", "[[input]]", "no", "An input that the experiment knows only within an interval.",
          {{"name", text(), yes,
            "fill_depth, period, amplitude, start_phase, sensor_position, density, "
            "kinematic_viscosity or gravity, each at most once. A still tank has neither period "
            "nor amplitude nor start_phase; a tank that surges and rolls has no amplitude, and a "
            "motion by a table no start_phase."},
           {"half_width", number().above(0), yes,
            "Half the width of the 95 % interval, in `unit`."},
           {"unit", text(), yes, "The input's unit."},
           {"source", text(), yes},
           {"coarse_run", text("name of an SPH or OpenFOAM run"), no,
            "Where no theory of the case holds, this run is repeated at both ends of the interval. "
            "Without it the input's share of such a row's uncertainty is unknown."}}),
      key_table(
          "gate", "[[gate]]", "no",
          "One requirement, or with candidates, modes and limits several: one for each run, mode "
          "and metric that they list. Exactly one of limit, lower with upper, and improves_on is "
          "given for each metric. No two rows have the same candidate, reference, quantity, mode, "
          "metric, error, part and improves_on.",
          {{"candidate", text("run name"), where("where candidates is absent"),
            "The run that is judged. A record is never a candidate."},
           {"candidates", list("list of run names or patterns"), no,
            "In place of candidate: runs, or patterns such as recommended_*, each of which must "
            "match a run. A pattern never means the reference."},
           {"reference", text("run name"),
            where("yes, but refused with a metric of the candidate alone or of impacts"),
            "What the candidate is compared with; for a metric of fields an OpenFOAM run. Beside "
            "limits it is that of the metrics that take one."},
           {"quantity", text("quantity"), no,
            "A compared quantity, below. A metric of the candidate alone takes any series, one of "
            "impacts the pressure at their gauge, one of fields pressure_field, and a row against "
            "a record the record's quantity, of a pressure also the filtered one. Default: the "
            "case's first, which is that of its first gauge but for a dam's front."},
           {"mode", text(), no,
            "forced, forced_1, ..., natural_1, ..., impact_1, ..., moment_1, ..., or whole, as the "
            "metric asks. Of impacts and of several forced modes one must be named. Default: "
            "forced where the tank moves and the metric can be of it, else natural_1; whole for "
            "the other metrics."},
           {"modes", list("list of texts"), no, "In place of mode: a row for each."},
           {"metric", text(), where("where limits is absent"), "One of the metrics below."},
           {"limits", KeyValue{KeyKind::limits, "table of metrics"}, no,
            "In place of metric and its bound: each metric with its limit, as in limits.phase_lag "
            "= 5, or with a table of the keys that differ from those of the group, as in "
            "limits.phase_lag = { lower = 0, upper = 5, reason = \"...\" }."},
           {"unit", text(), no,
            "The metric's unit, which a series that is not compared must name for a metric that "
            "has the quantity's. Default: the unit that it must be."},
           {"limit", number().above(0), one_of_three(),
            "The largest magnitude that passes. cost_to_reach takes only a limit."},
           {"lower", number(), one_of_three(),
            "With upper: the range that passes, narrower than twice the widest bound. The p-values "
            "take only a range."},
           {"upper", number().above(Bound("lower")), beside("lower")},
           {"improves_on", text("run name"), one_of_three(),
            "The candidate must be nearer to zero than this third run, by more than the "
            "intervals."},
           {"error", number().above(0).below(1), with("metric", "cost_to_reach", " alone"),
            "The normalised rms error whose cost is bounded."},
           {"part_begin_s", number("s").at_least(0), no,
            "The begin of the part of the run over which the row is judged. Default with "
            "part_end_s: 0. With neither: the comparison's window, of a series of the candidate "
            "alone the whole run."},
           {"part_end_s", number("s").above(Bound("part_begin_s")).at_most(case_duration), no,
            "The end of that part. Default with part_begin_s: duration_s."},
           {"kind", one_of({"validation", "regression"}), no,
            "Where the limit comes from: theory, experiment, requirement; or earlier measurements. "
            "Default: validation."},
           {"reason", text(), where("yes, or each of limits has its own"), "Why the row is there."},
           {"source", text(), where("yes, but for kind = \"regression\""),
            "Where its limit comes from. Default of a regression: the measurement that the reason "
            "names."}})};
  return all;
}

const std::vector<KeyTable>& campaign_key_tables() {
  using namespace key;
  using namespace needed;
  static const std::vector<KeyTable> all{
      key_table("campaign", "Top level of a campaign file", "yes",
                "A campaign names what is run, gated and reported together: at least one case or "
                "problem.",
                {{"schema_version", constant("1"), yes, "The version of this format."},
                 {"name", name(), yes, "The name of the campaign."},
                 {"title", text(), yes, "The title in reports."},
                 {"source", text(), yes, "Where the campaign comes from."},
                 {"paper", one_of({"li2010", "zhao2021"}), no,
                  "The paper whose figures and claims the report shows beside its own."},
                 {"cases", list("list of texts"), where("where no problem is named"),
                  "Names of shipped cases, or paths relative to the campaign file: a path has a / "
                  "or ends in .toml."},
                 {"problem", table("[[problem]]"), no},
                 {"sweep", table("[[sweep]]"), no},
                 {"timing", table("[timing]"), no}}),
      key_table("problem", "[[problem]]", "no",
                "A problem with an exact solution, solved at several resolutions: see "
                "[Verification problems](campaigns.md#verification-problems).",
                {{"name", text("problem name"), yes, "Each problem may appear once."},
                 {"gate", tables("[[problem.gate]]"), yes, "One row or more, below."}}),
      key_table(
          "problem.gate", "[[problem.gate]]", "one or more",
          "One requirement on one measure of the problem, or with measures and limits several, as "
          "in [[gate]]: each metric of a measure once.",
          {{"measure", text(), where("where measures is absent"), "One of the problem's measures."},
           {"measures", list("list of measures or patterns"), no,
            "In place of measure: measures, or patterns such as slope_*, each of which must match "
            "one."},
           {"metric", text(), where("where limits is absent"),
            "order_at_least, order_within, error_at_finest or largest_error."},
           {"limits", KeyValue{KeyKind::limits, "table of metrics"}, no,
            "In place of metric and its bound, as in [[gate]]: limits.order_at_least = 1.9."},
           {"unit", text(), no,
            "1 of an order, else the measure's unit. Default: the unit that it must be."},
           {"limit", number().above(0), where("yes, but refused with order_within"),
            "The bound. On an error it is below 1 where the error has no unit, and below 1e9 "
            "elsewhere."},
           {"lower", number(), beside("order_within")},
           {"upper", number().above(Bound("lower")).below(Bound("lower + 2")),
            beside("order_within")},
           {"kind", one_of({"validation", "regression"}), no, "The same as for a row of a case."},
           {"reason", text(), where("yes, or each of limits has its own"), "Why the row is there."},
           {"source", text(), where("yes, but for kind = \"regression\""),
            "The same as for a row of a case."}}),
      key_table(
          "sweep", "[[sweep]]", "no",
          "Adds runs to the campaign's cases, one for every combination of the lists, with the "
          "keys of [[run]]. A key that holds a list there is swept, but for command and the others "
          "whose value is a list by itself.",
          {{"cases", list("list of texts"), yes, "Names or globs of the campaign's cases."},
           {"name", text(), yes,
            "A pattern of the table's keys, as in {scheme}_{particle_spacing_m}: see [[run]]."},
           {"gate", tables("[[sweep.gate]]"), no,
            "Rows as [[gate]], for each run, which is their candidate."}}),
      timing_table};
  return all;
}

}  // namespace slosh
