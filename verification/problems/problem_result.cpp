#include "verification/problems/problem_result.hpp"

#include <nlohmann/json.hpp>

#include "verification/files/content_hash.hpp"
#include "verification/files/foreign/json_text.hpp"
#include "verification/files/sealed_json.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {
namespace {

using nlohmann::json;  // its objects are sorted: one text per value

constexpr const char* format = "slosh problem";
constexpr int format_version = 2;

double number(const json& value) { return value.is_null() ? not_a_number : value.get<double>(); }

std::vector<double> numbers(const json& values) {
  std::vector<double> all;
  for (const json& value : values) all.push_back(number(value));
  return all;
}

json entry(const MeasuredErrors& measure) {
  json errors = json::array();
  for (const ErrorAtStep& one : measure.errors)
    errors.push_back({{"step", one.step}, {"error", one.error}});
  return {{"name", measure.name}, {"errors", errors}};
}

MeasuredErrors measure_from(const json& entry) {
  MeasuredErrors measure{entry.at("name"), {}};
  for (const json& one : entry.at("errors"))
    measure.errors.push_back({number(one.at("step")), number(one.at("error"))});
  return measure;
}

json entry(const reports::Figure& figure) {
  json curves = json::array();
  for (const reports::Curve& curve : figure.curves)
    curves.push_back({{"label", curve.label},
                      {"x", curve.x},
                      {"y", curve.y},
                      {"style", static_cast<int>(curve.style)}});
  return {{"id", figure.id},           {"title", figure.title},     {"caption", figure.caption},
          {"x_label", figure.x_label}, {"y_label", figure.y_label}, {"log_x", figure.log_x},
          {"log_y", figure.log_y},     {"curves", curves}};
}

reports::Figure figure_from(const json& entry) {
  reports::Figure figure;
  figure.id = entry.at("id");
  figure.title = entry.at("title");
  figure.caption = entry.at("caption");
  figure.x_label = entry.at("x_label");
  figure.y_label = entry.at("y_label");
  figure.log_x = entry.at("log_x");
  figure.log_y = entry.at("log_y");
  for (const json& one : entry.at("curves"))
    figure.curves.push_back({one.at("label"),
                             numbers(one.at("x")),
                             numbers(one.at("y")),
                             {},
                             static_cast<reports::Curve::Style>(one.at("style").get<int>())});
  return figure;
}

json entry(const reports::Table& table) {
  return {{"id", table.id},
          {"title", table.title},
          {"caption", table.caption},
          {"header", table.header},
          {"rows", table.rows}};
}

reports::Table table_from(const json& entry) {
  return {entry.at("id"), entry.at("title"), entry.at("caption"),
          entry.at("header").get<std::vector<std::string>>(),
          entry.at("rows").get<std::vector<std::vector<std::string>>>()};
}

json body_of(const ProblemResult& result) {
  json measures = json::array(), figures = json::array(), tables = json::array();
  for (const MeasuredErrors& one : result.outcome.measures) measures.push_back(entry(one));
  for (const reports::Figure& one : result.outcome.figures) figures.push_back(entry(one));
  for (const reports::Table& one : result.outcome.tables) tables.push_back(entry(one));
  return {{"format", format},
          {"format_version", format_version},
          {"problem", result.problem},
          {"quick", result.quick},
          {"key", result.key},
          {"provenance", result.provenance},
          {"cost",
           {{"wall_time_s", result.cost.wall_time},
            {"user_time_s", result.cost.user_time},
            {"system_time_s", result.cost.system_time},
            {"peak_memory_byte", result.cost.peak_memory}}},
          {"measures", measures},
          {"figures", figures},
          {"tables", tables}};
}

ProblemResult result_from(const json& body) {
  ProblemResult result;
  result.problem = body.at("problem");
  result.quick = body.at("quick");
  result.key = body.at("key");
  result.provenance = body.at("provenance").get<std::map<std::string, std::string>>();
  const json& cost = body.at("cost");
  result.cost.wall_time = cost.at("wall_time_s");
  result.cost.user_time = cost.at("user_time_s");
  result.cost.system_time = cost.at("system_time_s");
  result.cost.peak_memory = cost.at("peak_memory_byte");
  for (const json& one : body.at("measures")) result.outcome.measures.push_back(measure_from(one));
  for (const json& one : body.at("figures")) result.outcome.figures.push_back(figure_from(one));
  for (const json& one : body.at("tables")) result.outcome.tables.push_back(table_from(one));
  return result;
}

}  // namespace

std::string problem_key(const Problem& problem, bool quick, const std::filesystem::path& builds) {
  ContentHash answer;
  answer.add_file(builds / (problem.is_of_metrics ? "metric_problems" : "problems"));
  return content_hash(json{{"problem", problem.name}, {"quick", quick}}.dump()) + "-" +
         answer.digits();
}

void write_problem_result(const ProblemResult& result, const std::filesystem::path& file) {
  write_sealed_json(body_of(result), file);
}

ProblemResult read_problem_result(const std::filesystem::path& file) try {
  const json body = read_sealed_json(format, file);
  if (body.at("format_version") != format_version)
    throw ResultError(file.string() + " is no problem's result of this version");
  return result_from(body);
} catch (const json::exception& error) {
  throw ResultError(file.string() + " is no problem's result: " + words_of(error));
}

}  // namespace slosh
