// Reads JSON that others wrote. A value may be nested at most 100 deep: the library copies and
// writes nested values by recursion, so that a text of 200,000 brackets would overflow the stack.
// A key may be in an object once: of two, JSON takes the last, and a reader the first.
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace slosh {

struct JsonRefused : nlohmann::json::exception {
  explicit JsonRefused(const std::string& why) : exception(0, why.c_str()) {}
};

// Returns what the library says, without the name of its exception.
inline std::string words_of(const nlohmann::json::exception& error) {
  const std::string all = error.what();
  const std::size_t end = all.starts_with("[json.exception") ? all.find("] ") : all.npos;
  return end == all.npos ? all : all.substr(end + 2);
}

// `Json` is nlohmann::json or nlohmann::ordered_json. Throws their exceptions.
template <class Json>
Json parsed_json(std::string_view text) try {
  constexpr int deepest = 100;
  std::vector<std::set<std::string>> keys;
  return Json::parse(text, [&](int depth, auto event, auto& parsed) {
    using Event = typename Json::parse_event_t;
    if (depth > deepest)
      throw JsonRefused("nested too deep, expected at most 100 values in one another");
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.template get<std::string>()).second)
      throw JsonRefused(parsed.template get<std::string>() + ": expected each key once");
    return true;
  });
} catch (const nlohmann::json::parse_error& error) {  // it would quote the text
  throw JsonRefused(fmt::format("expected JSON at byte {}", error.byte));
}

}  // namespace slosh
