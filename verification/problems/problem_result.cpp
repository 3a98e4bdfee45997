#include "verification/problems/problem_result.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/sealed_json.hpp"
#include "verification/series/time_series.hpp"

namespace slosh::reports {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Curve, label, x, y, style)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Figure, id, title, caption, x_label, y_label, log_x, log_y,
                                   curves)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Table, id, title, caption, header, rows)

}  // namespace slosh::reports

namespace slosh {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(RunCost, wall_time, user_time, system_time, peak_memory)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ErrorAtStep, step, error)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MeasuredErrors, name, errors)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProblemOutcome, measures, figures, tables)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ProblemResult, problem, quick, key, provenance, cost, outcome)

namespace {

using nlohmann::json;  // its objects are sorted: one text per value

constexpr const char* format = "slosh problem";
constexpr int format_version = 3;

// JSON has no NaN and writes null.
void read_nulls_as_nan(json& value) {
  if (value.is_null()) value = not_a_number;
  if (value.is_structured())
    for (json& part : value) read_nulls_as_nan(part);
}

}  // namespace

std::string problem_key(const Problem& problem, bool quick, const std::filesystem::path& builds) {
  ContentHash answer;
  answer.add_file(builds / "problems");
  return content_hash(json{{"problem", problem.name}, {"quick", quick}}.dump()) + "-" +
         answer.digits();
}

void write_problem_result(const ProblemResult& result, const std::filesystem::path& file) {
  json body = result;
  body.update({{"format", format}, {"format_version", format_version}});
  write_sealed_json(body, file);
}

ProblemResult read_problem_result(const std::filesystem::path& file) try {
  json body = read_sealed_json(format, file);
  if (body.at("format_version") != format_version)
    throw ResultError(file.string() + " is no problem's result of this version");
  read_nulls_as_nan(body);
  return body.get<ProblemResult>();
} catch (const json::exception& error) {
  throw ResultError(file.string() + " is no problem's result: " + words_of(error));
}

}  // namespace slosh
