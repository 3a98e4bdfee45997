// Reads JSON that others wrote. A value may be nested at most 100 deep: the library copies and
// writes nested values by recursion, so that a text of 200,000 brackets would overflow the stack.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace slosh {

struct JsonTooDeep : nlohmann::json::exception {
  JsonTooDeep() : exception(0, "nested too deep, expected at most 100 values in one another") {}
};

// `Json` is nlohmann::json or nlohmann::ordered_json; `look` sees what their parsers show a
// callback. Throws their exceptions.
template <class Json, class Look>
Json parsed_json(std::string_view text, const Look& look) {
  constexpr int deepest = 100;
  return Json::parse(text, [&](int depth, auto event, auto& parsed) {
    if (depth > deepest) throw JsonTooDeep();
    return look(depth, event, parsed);
  });
}

template <class Json>
Json parsed_json(std::string_view text) {
  return parsed_json<Json>(text, [](int, auto, const auto&) { return true; });
}

}  // namespace slosh
