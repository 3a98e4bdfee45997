#include "reports/drawing/relative_places.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <vector>

namespace slosh::reports {
namespace {

constexpr std::size_t fewest = 32;  // places of a line that is worth it

struct Place {
  char command;  // M, L, or 0 in a polygon
  long x, z;     // [0.1 px]
};

// Reads "M1.20,3.40", "L1.20,3.40" or, of a polygon, "1.20,3.40".
std::optional<Place> place_of(const std::string& text) {
  const bool has_command = text.front() == 'M' || text.front() == 'L';
  const char *begin = text.data() + has_command, *end = text.data() + text.size();
  double x = 0, z = 0;
  const auto first = std::from_chars(begin, end, x);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, z);
  if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
  return Place{has_command ? text.front() : '\0', std::lround(10 * x), std::lround(10 * z)};
}

std::string pixels(long tenths) {
  const long whole = std::abs(tenths) / 10, rest = std::abs(tenths) % 10;
  std::string text = tenths < 0 ? "-" : "";
  if (whole != 0 || rest == 0) text += fmt::format("{}", whole);
  return rest == 0 ? text : text + fmt::format(".{}", rest);
}

// A minus separates two numbers as a blank does.
std::string pair(long x, long z) { return pixels(x) + (z < 0 ? "" : " ") + pixels(z); }

// Returns "" where the places are few or not all of M and L.
std::string relative(const std::string& places) {
  std::vector<std::string> texts;
  const std::string trimmed = boost::trim_copy(places);
  boost::split(texts, trimmed, boost::is_space(), boost::token_compress_on);
  if (texts.size() < fewest) return "";
  std::string path;
  Place last{};
  bool at_beginning = true;
  for (const std::string& text : texts) {
    const auto place = place_of(text);
    if (!place) return "";
    if (path.empty() || place->command == 'M') {
      path += "M" + pair(place->x, place->z);
      at_beginning = true;
    } else {
      const long x = place->x - last.x;
      path += (at_beginning ? "l" : x < 0 ? "" : " ") + pair(x, place->z - last.z);
      at_beginning = false;
    }
    last = *place;
  }
  return path;
}

}  // namespace

std::string with_relative_places(const std::string& tag) {
  const bool is_polygon = boost::starts_with(tag, "<polygon ");
  if (!is_polygon && !boost::starts_with(tag, "<path ")) return tag;
  const std::string key = is_polygon ? " points = '" : " d='";
  if (!boost::contains(tag, key)) return tag;
  const auto start = tag.find(key) + key.size(), end = tag.find('\'', start);
  const std::string path = relative(tag.substr(start, end - start));
  if (path.empty()) return tag;
  if (!is_polygon) return tag.substr(0, start) + path + tag.substr(end);
  const auto name_end = std::string("<polygon").size();
  return "<path" + tag.substr(name_end, start - key.size() - name_end) + " d='" + path + "z" +
         tag.substr(end);
}

}  // namespace slosh::reports
