// Rules for the values of case files. The reader already refuses numbers that are not finite.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace slosh {

// What a value must be, in words with the unit ("a number > 0, in m") and as a test.
template <class T>
struct Rule {
  std::string expected;
  std::function<bool(const T&)> holds;
  // A value that satisfies the rule. It replaces a wrong one while the rest of the table is
  // checked. Only rules that depend on no other value of their table have one.
  std::optional<T> stand_in = {};
};

std::string in(std::string_view unit);  // "in m"; "without unit" for "1"

Rule<double> any_number(std::string_view unit);
Rule<double> positive(std::string_view unit);
Rule<double> not_negative(std::string_view unit);
Rule<double> not_zero(std::string_view unit);
Rule<int> at_least(int least);
Rule<int> integer_between(int least, int most);  // both included
// From 1 to the value of the key `most_key` of the same table.
Rule<int> integer_up_to(std::string_view most_key, int most);
Rule<int> exactly(int only);
Rule<std::string> any_text();
// A relative path that stays below the directory; `directory` names it in words.
Rule<std::string> path_below(std::string_view kind, std::string_view directory);
// A relative path of a file that the user supplies; it stays below the directory of the
// experiments.
Rule<std::string> path_below_experiments(std::string_view kind);  // "a CSV file's"
// Letters, digits, _ and -, no - first: the name becomes part of file names and an argument.
Rule<std::string> file_safe_name();

}  // namespace slosh
