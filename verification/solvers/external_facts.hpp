// What an external program tells of its run in a JSON file beside its series: the sizes and costs
// that only it knows. external_facts.schema.json is the published form of this file. The file of a
// stored result has entries beyond this form: it also says which code it was, and when, where and
// at what cost it ran.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/import/import_series.hpp"
#include "verification/results/result_file.hpp"

namespace slosh {

// One entry of the file, beside "schema_version", which is 1. Each is optional, and null says that
// the program does not know it.
struct ExternalFact {
  std::string name;  // with its unit
  bool is_count;     // an integer
  bool may_be_zero;
  std::string meaning;
};

// In the order of the document.
const std::vector<ExternalFact>& external_facts();

// Adds what the file says to the result: the particles of the liquid and the steps to its cost, and
// the rest to its diagnostics, under the file's names. The times of compiling are also added to the
// times of the cost, which are those that count as no run's. What the file does not say stays
// unknown. Throws CaseFileError with the file, the key, the value and what was expected where the
// file is missing, no JSON object of this form, or has another key, and where compiling took longer
// than the whole program with the cost `taken`.
void add_external_facts(const std::filesystem::path& file, const RunCost& taken, RunResult& result);

// Adds what the file of a stored result says. It has the same entries, without those of compiling,
// and must have `software`, `date` and `machine` (texts, which become the provenance
// stored_software, ...), `simulated_time_s` and `processor_time_s`, and may have `wall_time_s` and
// `remark`. A run that went on beyond the case's duration [s] counts by its share: its steps and
// times are multiplied by the duration over the simulated time. Throws CaseFileError as above, and
// where the run simulated less than the duration.
void add_stored_facts(const std::filesystem::path& file, double duration, RunResult& result);

// Adds the series, and its seams to the provenance, as "seams_of_elevation@right".
inline const std::string seams_of = "seams_of_";
void add_imported(ImportedSeries imported, RunResult& result);

}  // namespace slosh
