#include <stdexcept>

#include "verification/case_file/key_table.hpp"

namespace slosh {

const std::vector<KeyTable>& campaign_key_tables() {
  static const std::vector<KeyTable> tables{
      {"campaign",
       "Top level of a campaign file",
       "yes",
       "A campaign names what is run, gated and reported together: at least one case or problem.",
       {{"schema_version", "1", "yes", "The version of this format."},
        {"name", "name", "yes", "The name of the campaign."},
        {"title", "text", "yes", "The title in reports."},
        {"source", "text", "yes", "Where the campaign comes from."},
        {"paper", "\"li2010\" or \"zhao2021\"", "no",
         "The paper whose figures and claims the report shows beside its own."},
        {"cases", "list of texts", "where no problem is named",
         "Names of shipped cases, or paths relative to the campaign file: a path has a / or ends "
         "in .toml."},
        {"problem", "the table [[problem]]", "no", ""},
        {"sweep", "the table [[sweep]]", "no", ""},
        {"timing", "the table [timing]", "no", ""}}},
      {"problem",
       "[[problem]]",
       "no",
       "A problem with an exact solution, solved at several resolutions: see [Verification "
       "problems](problems.md).",
       {{"name", "problem name", "yes", "Each problem may appear once."},
        {"gate", "[[problem.gate]]", "yes", "One row or more, below."}}},
      {"problem.gate",
       "[[problem.gate]]",
       "one or more",
       "One requirement on one measure of the problem, or with measures and limits several, as in "
       "[[gate]]: each metric of a measure once.",
       {{"measure", "text", "where measures is absent", "One of the problem's measures."},
        {"measures", "list of measures or patterns", "no",
         "In place of measure: measures, or patterns such as slope_*, each of which must match "
         "one."},
        {"metric", "text", "where limits is absent",
         "order_at_least, order_within, error_at_finest or largest_error."},
        {"limits", "table of metrics", "no",
         "In place of metric and its bound, as in [[gate]]: limits.order_at_least = 1.9."},
        {"unit", "text", "no",
         "1 of an order, else the measure's unit. Default: the unit that it must be."},
        {"limit", "number > 0", "yes, but refused with order_within",
         "The bound. On an error it is below 1 where the error has no unit, and below 1e9 "
         "elsewhere."},
        {"lower", "number", "with order_within", ""},
        {"upper", "number above lower and below lower + 2", "with order_within", ""},
        {"kind", "\"validation\" or \"regression\"", "no", "The same as for a row of a case."},
        {"reason", "text", "yes, or each of limits has its own", "Why the row is there."},
        {"source", "text", "yes, but for kind = \"regression\"",
         "The same as for a row of a case."}}},
      {"sweep",
       "[[sweep]]",
       "no",
       "Adds runs to the campaign's cases, one for every combination of the lists, with the keys "
       "of [[run]]. A key that holds a list there is swept, but for command and the others whose "
       "value is a list by itself.",
       {{"cases", "list of texts", "yes", "Names or globs of the campaign's cases."},
        {"name", "text", "yes",
         "A pattern of the table's keys, as in {scheme}_{particle_spacing_m}: see [[run]]."},
        {"gate", "[[sweep.gate]]", "no",
         "Rows as [[gate]], for each run, which is their candidate."}}},
      {"timing",
       "[timing]",
       "no",
       "Repeats of the runs, each alone on the machine after all other runs.",
       {{"repeats", "integer >= 1", "yes", "The number of repeats of each run."},
        {"longest_run_s", "number > 0, s", "no",
         "Runs that took more processor time than this are not repeated. Default: 60."},
        {"only", "list of texts", "no",
         "Patterns CASE or CASE/RUN of what is repeated. Default: all."}}}};
  return tables;
}

std::vector<std::string> keys_of(const std::string& id) {
  for (const std::vector<KeyTable>* tables : {&case_key_tables(), &campaign_key_tables()})
    for (const KeyTable& table : *tables) {
      if (table.id != id) continue;
      std::vector<std::string> names;
      for (const KeyEntry& key : table.keys) names.push_back(key.name);
      return names;
    }
  throw std::logic_error("no table of keys has the id " + id);
}

std::vector<std::string> list_keys_of_runs() {
  std::vector<std::string> names;
  for (const KeyTable& table : case_key_tables())
    for (const KeyEntry& key : table.keys)
      if (table.id.starts_with("run") && key.value.starts_with("list of"))
        names.push_back(key.name);
  return names;
}

}  // namespace slosh
