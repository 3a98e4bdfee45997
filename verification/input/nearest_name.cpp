#include "verification/input/nearest_name.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace slosh {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::vector<std::string> nearest_names(std::string_view wrong, std::vector<std::string> known,
                                       std::size_t count) {
  std::stable_sort(known.begin(), known.end(),
                   [wrong](const std::string& left, const std::string& right) {
                     return edit_distance(wrong, left) < edit_distance(wrong, right);
                   });
  known.resize(std::min(count, known.size()));
  return known;
}

std::string one_of_text(std::string_view expected, const std::vector<std::string>& known) {
  if (known.empty()) return fmt::format("{}, of which there is none", expected);
  return fmt::format("{}, {} {}", expected, known.size() == 1 ? "which is" : "one of",
                     fmt::join(known, ", "));
}

std::string nearest_text(std::string_view wrong, const std::vector<std::string>& known) {
  return known.empty() ? "" : "; nearest: " + nearest_names(wrong, known, 1).front();
}

}  // namespace slosh
