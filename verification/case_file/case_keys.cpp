#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"

namespace slosh {

using namespace key;
using namespace needed;

const FieldTable<CaseDefinition> case_keys{
    {"case", "Top level", "yes", "The first keys of a case file, and its tables."},
    {{{"schema_version", constant("1"), yes, "The version of this format."}},
     field("name", &CaseDefinition::name, name(), yes, "The name of the case."),
     field("title", &CaseDefinition::title, text(), yes, "The title in reports."),
     field("source", &CaseDefinition::source, text(), yes,
           "Where the case comes from: paper, section, figure."),
     field("tags", &CaseDefinition::tags, list("list of texts"), no,
           "Words by which `--tag` selects the case."),
     field("gravity_m_s2", &CaseDefinition::gravity, number("m/s2").at_least(0), no,
           fmt::format("It may be 0 only where the tank moves. Default: {}.", usual_gravity)),
     {{"tank", table("[tank]"), yes}},
     {{"liquid", table("[liquid]"), yes}},
     {{"gas", table("[gas]"), no}},
     {{"obstacle", table("[[obstacle]]"), no}},
     {{"initial_wave", table("[initial_wave]"), no}},
     {{"motion", table("[motion]"), yes}},
     {{"time", table("[time]"), yes}},
     {{"animation", table("[animation]"), no}},
     {{"gauge", table("[[gauge]]"), at_least_one(" gauge of either kind")}},
     {{"pressure_gauge", table("[[pressure_gauge]]"), at_least_one(" gauge of either kind")}},
     {{"probe", table("[[probe]]"), no}},
     {{"wall_forces", list("list of \"left\", \"right\", \"bottom\", \"roof\""), no,
       "The walls on which the force is recorded: force_x@WALL and force_z@WALL. Runs are compared "
       "on the component normal to the wall. Beside outline_m or diameter_m a wall is what faces "
       "its way: \"left\" has the force x on all sides whose outward normal points to the left."},
      read_wall_forces},
     {{"impacts", table("[impacts]"), no}},
     {{"comparison", table("[comparison]"), yes}},
     {{"run", table("[[run]]"), at_least_one("")}},
     {{"refinement", table("[[refinement]]"), no}},
     {{"input", table("[[input]]"), no}},
     {{"gate", table("[[gate]]"), no}}}};

const FieldTable<GateRow> gate_keys{
    {"gate", "[[gate]]", "no",
     "One requirement, or with candidates, modes and limits several: one for each run, mode and "
     "metric that they list. Exactly one of limit, lower with upper, and improves_on is given for "
     "each metric. No two rows have the same candidate, reference, quantity, mode, metric, error, "
     "part and improves_on."},
    with_origin<GateRow>(
        {{{"candidate", text("run name"), where("where candidates is absent"),
           "The run that is judged. A record is never a candidate."}},
         {{"candidates", list("list of run names or patterns"), no,
           "In place of candidate: runs, or patterns such as recommended_*, each of which must "
           "match a run. A pattern never means the reference."}},
         {{"reference", text("run name"),
           where("yes, but refused with a metric of the candidate alone or of impacts"),
           "What the candidate is compared with; for a metric of fields an OpenFOAM run. Beside "
           "limits it is that of the metrics that take one."}},
         {{"quantity", text("quantity"), no,
           "A compared quantity, below. A metric of the candidate alone takes any series, one of "
           "impacts the pressure at their gauge, one of fields pressure_field, and a row against "
           "a record the record's quantity, of a pressure also the filtered one. Default: the "
           "case's first, which is that of its first gauge but for a dam's front."}},
         {{"mode", text(), no,
           "forced, forced_1, ..., natural_1, ..., impact_1, ..., moment_1, ..., or whole, as the "
           "metric asks. Of impacts and of several forced modes one must be named. Default: "
           "forced where the tank moves and the metric can be of it, else natural_1; whole for "
           "the other metrics."}},
         {{"modes", list("list of texts"), no, "In place of mode: a row for each."}},
         {{"metric", text(), where("where limits is absent"), "One of the metrics below."}},
         {{"limits", KeyValue{KeyKind::limits, "table of metrics"}, no,
           "In place of metric and its bound: each metric with its limit, as in limits.phase_lag "
           "= 5, or with a table of the keys that differ from those of the group, as in "
           "limits.phase_lag = { lower = 0, upper = 5, reason = \"...\" }."}},
         {{"unit", text(), no,
           "The metric's unit, which a series that is not compared must name for a metric that "
           "has the quantity's. Default: the unit that it must be."}},
         {{"limit", number().above(0), one_of_three(),
           "The largest magnitude that passes. cost_to_reach takes only a limit."}},
         {{"lower", number(), one_of_three(),
           "With upper: the range that passes, narrower than twice the widest bound. The p-values "
           "take only a range."}},
         {{"upper", number().above(Bound("lower")), beside("lower")}},
         {{"improves_on", text("run name"), one_of_three(),
           "The candidate must be nearer to zero than this third run, by more than the "
           "intervals."}},
         field("error", &GateRow::error, number().above(0).below(1).noting(": a normalised rms"),
               with("metric", "cost_to_reach", " alone"),
               "The normalised rms error whose cost is bounded."),
         {{"part_begin_s", number("s").at_least(0), no,
           "The begin of the part of the run over which the row is judged. Default with "
           "part_end_s: 0. With neither: the comparison's window, of a series of the candidate "
           "alone the whole run."}},
         {{"part_end_s", number("s").above(Bound("part_begin_s")).at_most(case_duration), no,
           "The end of that part. Default with part_begin_s: duration_s."}}}),
    finish_gate_row};

const std::vector<KeyTable>& case_key_tables() {
  static const std::vector<KeyTable> motions = motion_tables();
  static const std::vector<KeyTable> all{
      case_keys,
      tank_keys,
      liquid_keys,
      gas_keys,
      obstacle_keys,
      initial_wave_keys,
      motion_keys,
      motions[0],
      motions[1],
      motions[2],
      motions[3],
      time_keys,
      animation_keys,
      gauge_keys,
      pressure_gauge_keys,
      probe_keys,
      impacts_keys,
      comparison_keys,
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
      sph_keys,
      interfoam_keys,
      linear_keys,
      viscous_wave_keys,
      potential_keys,
      record_keys,
      experiment_keys,
      external_keys,
      stored_keys,
      series_keys,
      pysph_keys,
      refinement_keys,
      input_keys,
      gate_keys};
  return all;
}

const std::vector<KeyTable>& campaign_key_tables() {
  static const std::vector<KeyTable> all{
      campaign_keys,
      key_table("problem", "[[problem]]", "no",
                "A problem with an exact solution, solved at several resolutions: see "
                "[Verification problems](campaigns.md#verification-problems).",
                {{"name", text("problem name"), yes, "Each problem may appear once."},
                 {"gate", tables("[[problem.gate]]"), yes, "One row or more, below."}}),
      problem_gate_keys,
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
      timing_keys};
  return all;
}

}  // namespace slosh
