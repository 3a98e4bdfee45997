#include "verification/input/rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace slosh {

std::string in(std::string_view unit) {
  return unit == "1" ? "without unit" : fmt::format("in {}", unit);
}

Rule<double> any_number(std::string_view unit) {
  return {"a number, " + in(unit), [](double) { return true; }, 0};
}

Rule<double> positive(std::string_view unit) {
  return {"a number > 0, " + in(unit), [](double value) { return value > 0; }, 1};
}

Rule<double> not_negative(std::string_view unit) {
  return {"a number >= 0, " + in(unit), [](double value) { return value >= 0; }, 0};
}

Rule<double> not_zero(std::string_view unit) {
  return {"a number other than 0, " + in(unit), [](double value) { return value != 0; }, 1};
}

Rule<int> at_least(int least) {
  return {fmt::format("an integer >= {}", least), [least](int value) { return value >= least; },
          least};
}

Rule<int> integer_between(int least, int most) {
  return {fmt::format("an integer from {} to {}", least, most),
          [=](int value) { return value >= least && value <= most; }, least};
}

Rule<int> integer_up_to(std::string_view most_key, int most) {
  return {fmt::format("an integer from 1 to {} ({})", most_key, most),
          [most](int value) { return value >= 1 && value <= most; }};
}

Rule<int> exactly(int only) {
  return {fmt::format("{}", only), [only](int value) { return value == only; }, only};
}

Rule<std::string> any_text() {
  return {"a text that is not empty", [](const std::string& text) { return !text.empty(); },
          "stand_in"};
}

Rule<std::string> path_below_experiments(std::string_view kind) {
  return path_below(kind, "the directory of the experiments");
}

Rule<std::string> path_below(std::string_view kind, std::string_view directory) {
  return {fmt::format("{} path below {}", kind, directory),
          [](const std::string& text) {
            const std::filesystem::path path = std::filesystem::path(text).lexically_normal();
            return !text.empty() && path.is_relative() && *path.begin() != "..";
          },
          "stand_in"};
}

Rule<std::string> file_safe_name() {
  constexpr std::size_t longest = 100;  // a file system takes 255 with all endings
  return {fmt::format("a name of letters, digits, _ and -, no - first, of at most {}", longest),
          [](const std::string& name) {
            const auto allowed = [](char c) {
              return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                     c == '_' || c == '-';
            };
            // With a - first it would be taken for an option on a command line.
            return !name.empty() && name.size() <= longest && name[0] != '-' &&
                   std::all_of(name.begin(), name.end(), allowed);
          },
          "stand_in"};
}

}  // namespace slosh
