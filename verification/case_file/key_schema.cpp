#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "verification/case_file/key_table.hpp"

namespace slosh {
namespace {

using Json = nlohmann::ordered_json;  // in the order of the table

Json schema_of(const KeyTable& table);
Json value_schema(const KeyValue& value);

const KeyTable& table_under(const std::string& heading) {
  for (const std::vector<KeyTable>* tables : {&case_key_tables(), &campaign_key_tables()})
    for (const KeyTable& table : *tables)
      if (table.heading == heading) return table;
  throw std::logic_error("no table of keys has the heading " + heading);
}

// A solver's own keys and the common ones.
KeyTable keys_of_solver(const KeyTable& table) {
  KeyTable all = table_under("[[run]]");
  for (KeyEntry& key : all.keys)
    if (key.name == "solver") key.value = key::one_of(table.solvers);
  all.meaning = table.meaning;
  all.keys.insert(all.keys.end(), table.keys.begin(), table.keys.end());
  return all;
}

std::vector<KeyTable> tables_of_solvers() {
  std::vector<KeyTable> tables;
  for (const KeyTable& table : case_key_tables())
    if (!table.solvers.empty()) tables.push_back(keys_of_solver(table));
  return tables;
}

// A value of a run, or the values of the runs that one table holds.
Json one_or_list(const KeyValue& value) {
  const Json one = value_schema(value);
  return {{"anyOf", Json::array({one, {{"type", "array"}, {"items", one}}})}};
}

Json run_schema() {
  Json forms = Json::array();
  for (const KeyTable& all : tables_of_solvers()) {
    Json form = schema_of(all);
    for (const KeyEntry& key : all.keys)
      if (key.name != "name" && key.name != "solver" && key.name != "quick" &&
          !key.value.is_list() && !key.value.is_table())
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
  Json schema = schema_of(table_under("[[sweep]]"));
  std::map<std::string, std::map<std::string, KeyValue>> values;  // the forms of each key
  for (const KeyTable& all : tables_of_solvers())
    for (const KeyEntry& key : all.keys) values[key.name].emplace(key.value.words(), key.value);
  for (const auto& [name, known] : values) {
    if (schema["properties"].contains(name)) continue;
    Json forms = Json::array();
    for (const auto& [words, value] : known) forms.push_back(one_or_list(value));
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

Json bounded(const char* type, const KeyValue& value) {
  Json schema{{"type", type}};
  const auto add = [&](const std::optional<KeyValue::End>& end, const char* included,
                       const char* excluded) {
    if (!end || !end->bound.name.empty()) return;  // a schema cannot compare with other keys
    const double bound = end->bound.value;
    schema[end->included ? included : excluded] =
        bound == std::floor(bound) ? Json(std::lround(bound)) : Json(bound);
  };
  add(value.lower, "minimum", "exclusiveMinimum");
  add(value.upper, "maximum", "exclusiveMaximum");
  if (value.is_not_zero) schema["not"] = {{"const", 0}};
  return schema;
}

Json array_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json value_schema(const KeyValue& value) {
  const Json text{{"type", "string"}};
  switch (value.kind) {
    case KeyKind::constant:
      return {{"const", Json::parse(value.texts.front())}};
    case KeyKind::flag:
      return {{"type", "boolean"}};
    case KeyKind::flag_or_texts:
      return {{"anyOf", Json::array({Json{{"type", "boolean"}}, array_of(text)})}};
    case KeyKind::limits:  // a limit or a table of the row's own keys at each metric
      return {{"type", "object"},
              {"additionalProperties", {{"type", Json::array({"number", "object"})}}}};
    case KeyKind::choice:
      return {{"enum", value.texts}};
    case KeyKind::table:
      return table_schema(value.heading);
    case KeyKind::tables:
      return array_of(table_schema(value.heading));
    case KeyKind::number:
      return bounded("number", value);
    case KeyKind::integer:
      return bounded("integer", value);
    case KeyKind::numbers:
    case KeyKind::increasing_numbers:
      return array_of(bounded("number", value));
    case KeyKind::corners: {
      Json corner = array_of({{"type", "number"}});
      corner.update({{"minItems", 2}, {"maxItems", 2}});
      return {{"type", "array"}, {"items", corner}, {"minItems", 3}};
    }
    case KeyKind::list:
      return array_of(text);
    case KeyKind::name:
      return {{"type", "string"}, {"pattern", "^[A-Za-z0-9_][A-Za-z0-9_-]*$"}};
    case KeyKind::text:
      break;
  }
  return text;
}

// The condition holds where another key has the value.
Json only_where(const Needed& needed, const Json& condition) {
  if (needed.key.empty()) return condition;
  const Json other{{"not",
                    {{"properties", {{needed.key, {{"const", needed.value}}}}},
                     {"required", Json::array({needed.key})}}}};
  return {{"anyOf", Json::array({other, condition})}};
}

// What the table says about keys that are required together, or one of several.
void add_conditions(const KeyTable& table, Json& schema) {
  std::map<std::string, std::pair<Needed, Json>> groups;  // of keys, by when they are needed
  for (const KeyEntry& key : table.keys) {
    Json& names =
        groups.try_emplace(key.needed.words, key.needed, Json::array()).first->second.second;
    names.push_back(key.name);
  }
  if (groups.contains("yes")) schema["required"] = groups.at("yes").second;
  Json conditions = Json::array();
  for (const auto& [words, group] : groups) {
    const auto& [needed, keys] = group;
    Json forms = Json::array();
    for (const Json& key : keys) forms.push_back({{"required", Json::array({key})}});
    const bool has_limits =
        std::any_of(table.keys.begin(), table.keys.end(),
                    [](const KeyEntry& key) { return key.value.kind == KeyKind::limits; });
    // A group of rows has its bounds in `limits`.
    if (needed.key.empty() && has_limits) forms.push_back({{"required", {"limits"}}});
    if (needed.of == Needed::Of::at_least_one)
      conditions.push_back({{"anyOf", forms}});
    else if (needed.of == Needed::Of::one_of_several)
      conditions.push_back(only_where(needed, {{"oneOf", forms}}));
    else if (!needed.key.empty())
      conditions.push_back(only_where(needed, {{"required", keys}}));
  }
  if (!conditions.empty()) schema["allOf"] = std::move(conditions);
}

Json schema_of(const KeyTable& table) {
  Json schema{{"type", "object"}};
  if (!table.meaning.empty()) schema["description"] = table.meaning;
  Json properties = Json::object();
  for (const KeyEntry& key : table.keys) {
    Json one = value_schema(key.value);
    const std::string text =
        key.value.words() + "." + (key.meaning.empty() ? "" : " " + key.meaning);
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
