// The output of OpenFOAM's function objects, of v1912 and later and of those versions of the
// Foundation with the same output: comment lines, the last of which names the columns, then rows
// with vectors in parentheses.
//   # Probe 1 (0.95 0.5 0.2)          # Location 0 : (0.05 0.5 0)
//   #  Probe     0        1           # Time   hB    hL
//   #   Time
#include <fmt/format.h>

#include "verification/import/table_head.hpp"

namespace slosh {
namespace {

// The words of a line; an unbalanced parenthesis of a word is removed: "(total_x", "total_z)".
std::vector<std::string> names_in(std::string_view line) {
  std::vector<std::string> names;
  constexpr std::string_view white = " \t";
  for (std::size_t begin; (begin = line.find_first_not_of(white)) != line.npos;) {
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(white), line.size());
    std::string_view name = line.substr(0, end);
    line.remove_prefix(end);
    if (name.starts_with('(')) name.remove_prefix(1);
    if (name.ends_with(')') && name.find('(') == name.npos) name.remove_suffix(1);
    names.emplace_back(name);
  }
  return names;
}

// The number of components of each value in a row: 1 for a number, 3 for a vector.
std::vector<std::size_t> value_sizes(const std::string& row) {
  std::vector<std::size_t> sizes;
  std::string_view rest = row;
  while (!rest.empty()) {
    const std::size_t open = std::min(rest.find('('), rest.size());
    sizes.insert(sizes.end(), fields_of(rest.substr(0, open), ' ').size(), 1);
    rest.remove_prefix(open);
    const std::size_t close = std::min(rest.find(')'), rest.size());
    if (const std::size_t size = fields_of(rest.substr(0, close), ' ').size(); size > 0)
      sizes.push_back(size);
    rest.remove_prefix(std::min(close + 1, rest.size()));
  }
  return sizes;
}

// The head with the values' names, extended by the components for vectors. There must be one name
// for each value of the first row, or one for each of its numbers.
TableHead head_of(TableReader& reader, const std::vector<std::string>& names) {
  TableHead head{{{"Time", "s"}}, reader.line_number() - 1, 0, ' '};
  const std::vector<std::size_t> sizes = value_sizes(reader.line());
  const bool of_values = sizes.size() == names.size() + 1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!of_values || sizes[i + 1] == 1) {
      head.columns.push_back({names[i], ""});
      continue;
    }
    if (sizes[i + 1] != 3)
      reader.refuse("row", reader.line(), "values that are numbers or vectors of three");
    for (const char* component : {".x", ".y", ".z"})
      head.columns.push_back({names[i] + component, ""});
  }
  return head;
}

// Advances to the first row and passes each comment to `look`.
template <class Look>
void read_comments(TableReader& reader, Look look) {
  while (reader.line().starts_with('#')) {
    look(trimmed(std::string_view(reader.line()).substr(1)));
    if (!reader.next()) return;
  }
}

// The names after "Time" in the last comment that begins with it; empty without such a comment.
std::vector<std::string> names_after_time(TableReader& reader) {
  std::vector<std::string> names;
  read_comments(reader, [&](std::string_view comment) {
    if (comment.starts_with("Time")) names = names_in(comment.substr(4));
  });
  return names;
}

}  // namespace

TableHead read_openfoam_probes_head(TableReader& reader, const SeriesSource&) {
  std::vector<std::string> names;
  read_comments(reader, [&](std::string_view comment) {
    if (comment.starts_with("Probe ") && comment.find('(') != comment.npos)
      names.push_back(fmt::format("probe_{}", names.size()));
  });
  if (names.empty())
    reader.refuse("head", reader.line(), "lines \"# Probe 0 (x y z)\", as OpenFOAM's probes write");
  return head_of(reader, names);
}

TableHead read_openfoam_interface_height_head(TableReader& reader, const SeriesSource&) {
  std::vector<std::string> names = names_after_time(reader);
  if (names.empty() || (names[0] != "hB" && names[0] != "p"))
    reader.refuse("head", reader.line(),
                  "a line \"# Time hB hL ...\" or \"# Time p ...\", as OpenFOAM's interfaceHeight "
                  "writes");
  const std::size_t of_each = names[0] == "hB" ? 2 : 1;  // hB and hL of each place, or p
  for (std::size_t i = 0; i < names.size(); ++i) names[i] += fmt::format("_{}", i / of_each);
  return head_of(reader, names);
}

TableHead read_openfoam_table_head(TableReader& reader, const SeriesSource&) {
  const std::vector<std::string> names = names_after_time(reader);
  if (names.empty() || names[0].starts_with("forces("))
    reader.refuse("head", reader.line(),
                  "a last comment \"# Time NAME ...\", as OpenFOAM's v1912 and later write");
  return head_of(reader, names);
}

}  // namespace slosh
