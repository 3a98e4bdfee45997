// The rules that a case file's values keep. A number is always finite: the reader sees to that.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace slosh {

// What a value must be: in words with the unit ("a number > 0, in m"), and as a test.
template <class T>
struct Rule {
  std::string expected;
  std::function<bool(const T&)> holds;
  // A value that keeps the rule, of a rule that rests on no other value of its table: it takes the
  // place of a wrong one while the rest of the table is read for its mistakes.
  std::optional<T> stand_in = {};
};

std::string in(std::string_view unit);  // "in m"; "without unit" for "1"

Rule<double> any_number(std::string_view unit);
Rule<double> positive(std::string_view unit);
Rule<double> not_negative(std::string_view unit);
// The end of an interval within the run that begins at the key `begin_key`.
Rule<double> end_after(std::string_view begin_key, double begin, double duration);
Rule<double> not_zero(std::string_view unit);
Rule<int> at_least(int least);
Rule<int> exactly(int only);
Rule<std::string> any_text();
// Relative, and not out of the directory (in words) that it lies below.
Rule<std::string> path_below(std::string_view kind, std::string_view directory);
// Of a file that the user supplies: relative, and not out of the directory that it lies below.
Rule<std::string> path_below_experiments(std::string_view kind);  // "a CSV file's"
Rule<std::string> file_safe_name();  // letters, digits, _ and -, no - first: it becomes part
                                     // of file names and an argument

}  // namespace slosh
