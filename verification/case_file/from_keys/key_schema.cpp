#include "verification/case_file/from_keys/key_schema.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>

#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;  // in the order of the table

Json schema_of(const KeyTable& table);
Json value_schema(const std::string& value);

const KeyTable& table_under(const std::string& heading) {
  for (const std::vector<KeyTable>* tables : {&case_key_tables(), &campaign_key_tables()})
    for (const KeyTable& table : *tables)
      if (table.heading == heading) return table;
  throw std::logic_error("no table of keys has the heading " + heading);
}

// A solver's own keys and the common ones, or nothing for a table that is no solver's.
std::optional<KeyTable> keys_of_solver(const KeyTable& table) {
  if (!table.heading.starts_with("[[run]] with solver")) return {};
  KeyTable all = table_under("[[run]]");
  for (KeyEntry& key : all.keys)
    if (key.name == "solver")
      key.value = table.heading.substr(table.heading.find('"'),
                                       table.heading.rfind('"') + 1 - table.heading.find('"'));
  all.meaning = table.meaning;
  all.keys.insert(all.keys.end(), table.keys.begin(), table.keys.end());
  return all;
}

// A value of a run, or the values of the runs that one table holds.
Json one_or_list(const std::string& value) {
  const Json one = value_schema(value);
  return {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}}})}};
}

Json run_schema() {
  Json forms = Json::array();
  for (const KeyTable& table : case_key_tables()) {
    const std::optional<KeyTable> all = keys_of_solver(table);
    if (!all) continue;
    Json form = schema_of(*all);
    for (const KeyEntry& key : all->keys)
      if (key.name != "name" && key.name != "solver" && key.name != "quick" &&
          !key.value.starts_with("list of") && !key.value.starts_with("["))
        form["properties"][key.name].update(one_or_list(key.value));
    for (auto& [name, property] : form["properties"].items())
      if (property.contains("anyOf"))
        for (const char* of_one : {"type", "enum", "const", "pattern"}) property.erase(of_one);
    forms.push_back(std::move(form));
  }
  return {{"anyOf", std::move(forms)}};
}

// The rows of a sweep are those of a case without their candidate, which is each run of the sweep.
Json sweep_row_schema() {
  KeyTable row = table_under("[[gate]]");
  std::erase_if(row.keys, [](const KeyEntry& key) { return key.name.starts_with("candidate"); });
  return schema_of(row);
}

// Every key of a run may hold a list in a sweep.
Json sweep_schema() {
  const KeyTable& own = table_under("[[sweep]]");
  Json schema = schema_of(own);
  std::map<std::string, std::set<std::string>> values;  // the forms of each key
  for (const KeyTable& table : case_key_tables())
    if (const std::optional<KeyTable> all = keys_of_solver(table))
      for (const KeyEntry& key : all->keys) values[key.name].insert(key.value);
  for (const auto& [name, known] : values) {
    if (schema["properties"].contains(name)) continue;
    Json forms = Json::array();
    for (const std::string& value : known) forms.push_back(one_or_list(value));
    schema["properties"][name] = {{"anyOf", std::move(forms)}};
  }
  return schema;
}

Json table_schema(const std::string& heading) {
  if (heading == "[[run]]") return run_schema();
  if (heading == "[[sweep]]") return sweep_schema();
  if (heading == "[[sweep.gate]]") return sweep_row_schema();
  return schema_of(table_under(heading));
}

// Adds the bounds that are numbers, as in "number > 0 and below the tank's height": the others are
// values of other keys, which a schema cannot compare.
void add_bounds(const std::string& value, Json& schema) {
  static const std::map<std::string, std::string> names{
      {">", "exclusiveMinimum"},     {">=", "minimum"},   {"<=", "maximum"},
      {"above", "exclusiveMinimum"}, {"from", "minimum"}, {"to", "maximum"},
      {"below", "exclusiveMaximum"}};
  const std::regex bound(R"((>=|<=|>|above|below|from|to) ([0-9.]+)(?![\w.]))");
  for (std::sregex_iterator at(value.begin(), value.end(), bound), end; at != end; ++at)
    schema[names.at((*at)[1])] = Json::parse((*at)[2].str());
  if (value.find("other than 0") != value.npos) schema["not"] = {{"const", 0}};
}

Json bounded(const char* type, const std::string& value) {
  Json schema{{"type", type}};
  add_bounds(value, schema);
  return schema;
}

Json quoted_texts(const std::string& value) {
  Json texts = Json::array();
  const std::regex quoted("\"([^\"]*)\"");
  for (std::sregex_iterator at(value.begin(), value.end(), quoted), end; at != end; ++at)
    texts.push_back((*at)[1].str());
  return {{"enum", std::move(texts)}};
}

// Translates the words of a key's value. Throws std::logic_error for words that it does not know.
Json value_schema(const std::string& value) {
  const auto begins = [&](const char* words) { return value.starts_with(words); };
  if (value == "1" || value == "true") return {{"const", Json::parse(value)}};
  if (value == "true or false") return {{"type", "boolean"}};
  if (value == "true or false, or a list of names or patterns")
    return {{"anyOf", Json::array({value_schema("true or false"), value_schema("list of names")})}};
  if (value == "table of metrics")  // a limit or a table of the row's own keys at each metric
    return {{"type", "object"},
            {"additionalProperties", {{"type", Json::array({"number", "object"})}}}};
  if (begins("\"")) return quoted_texts(value);
  if (const std::size_t head = value.find('[');
      head != value.npos && (head == 0 || begins("the"))) {
    const std::string heading = value.substr(head);
    if (!heading.starts_with("[[")) return table_schema(heading);
    return {{"type", "array"}, {"items", table_schema(heading)}};
  }
  if (begins("list of numbers") || begins("increasing list of numbers"))
    return {{"type", "array"}, {"items", bounded("number", value)}};
  if (begins("list of corners")) {
    const Json corner{
        {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
    return {{"type", "array"}, {"items", corner}, {"minItems", 3}};
  }
  if (begins("list of")) return {{"type", "array"}, {"items", {{"type", "string"}}}};
  if (begins("integer")) return bounded("integer", value);
  if (begins("number")) return bounded("number", value);
  if (value == "name") return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]*$"}};
  for (const char* words : {"name of", "name, or a pattern", "text", "path", "compared quantity",
                            "quantity", "run name", "problem name", "unit of"})
    if (begins(words)) return {{"type", "string"}};
  throw std::logic_error("no schema is known for a value that is \"" + value + "\"");
}

// "with type = "sine"": the condition holds where another key has this value.
Json only_where(const std::string& key, const std::string& value, const Json& condition) {
  const Json other{
      {"not", {{"properties", {{key, {{"const", value}}}}}, {"required", Json::array({key})}}}};
  return {{"anyOf", Json::array({other, condition})}};
}

// What the table says about keys that are required together, or one of several.
void add_conditions(const KeyTable& table, Json& schema) {
  std::map<std::string, Json> names;  // of keys, by when they are needed
  for (const KeyEntry& key : table.keys) names[key.needed].push_back(key.name);
  if (names.contains("yes")) schema["required"] = names.at("yes");
  const bool has_limits = std::any_of(table.keys.begin(), table.keys.end(),
                                      [](const KeyEntry& key) { return key.name == "limits"; });
  Json conditions = Json::array();
  for (const auto& [needed, keys] : names) {
    Json forms = Json::array();
    for (const Json& key : keys) forms.push_back({{"required", Json::array({key})}});
    std::smatch with;
    if (needed.starts_with("at least one")) conditions.push_back({{"anyOf", forms}});
    const bool where = std::regex_search(needed, with, std::regex("(^| )with (\\w+) = \"(\\w+)\""));
    Json condition;
    if (needed.starts_with("one of the three")) {
      // A group of rows has its bounds in `limits`.
      if (!where && has_limits) forms.push_back({{"required", {"limits"}}});
      condition = {{"oneOf", forms}};
    } else if (where) {
      condition = {{"required", keys}};
    }
    if (!condition.is_null())
      conditions.push_back(where ? only_where(with[2], with[3], condition) : condition);
  }
  if (!conditions.empty()) schema["allOf"] = std::move(conditions);
}

Json schema_of(const KeyTable& table) {
  Json schema{{"type", "object"}};
  if (!table.meaning.empty()) schema["description"] = table.meaning;
  Json properties = Json::object();
  for (const KeyEntry& key : table.keys) {
    Json one = value_schema(key.value);
    const std::string text = key.value + "." + (key.meaning.empty() ? "" : " " + key.meaning);
    if (!one.contains("description")) one["description"] = text;
    properties[key.name] = std::move(one);
  }
  schema["properties"] = std::move(properties);
  schema["additionalProperties"] = false;
  add_conditions(table, schema);
  return schema;
}

std::string document(const char* title, const KeyTable& top) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", title}};
  schema.update(schema_of(top));
  return schema.dump(1) + "\n";
}

}  // namespace

std::string case_schema() { return document("A case of Slosh", case_key_tables().front()); }

std::string campaign_schema() {
  return document("A campaign of Slosh", campaign_key_tables().front());
}

}  // namespace slosh
