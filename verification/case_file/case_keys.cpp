#include <fmt/format.h>

#include "verification/case_file/case_sections.hpp"

namespace slosh {

using namespace key;
using namespace needed;

const FieldTable<CaseDefinition> case_table{
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

const std::vector<KeyTable>& case_key_tables() {
  static const std::vector<KeyTable> motions = motion_tables();
  static const std::vector<KeyTable> all{
      case_table,
      tank_table,
      liquid_table,
      gas_table,
      obstacle_table,
      initial_wave_table,
      motion_table,
      motions[0],
      motions[1],
      motions[2],
      motions[3],
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
      record_table,
      experiment_table,
      external_table,
      stored_table,
      series_table,
      pysph_table,
      refinement_table,
      input_table,
      gate_table};
  return all;
}

const std::vector<KeyTable>& campaign_key_tables() {
  static const std::vector<KeyTable> all{
      campaign_table,
      key_table("problem", "[[problem]]", "no",
                "A problem with an exact solution, solved at several resolutions: see "
                "[Verification problems](campaigns.md#verification-problems).",
                {{"name", text("problem name"), yes, "Each problem may appear once."},
                 {"gate", tables("[[problem.gate]]"), yes, "One row or more, below."}}),
      problem_gate_table,
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
