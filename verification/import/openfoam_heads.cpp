// The output of the function objects of OpenFOAM, of v1912 and later of OpenFOAM.com and of
// OpenFOAM.org: comment lines, the last of which names the columns, then rows with vectors in
// parentheses.
//   # Probe 1 (0.95 0.5 0.2)          # Location 0 : (0.05 0.5 0)
//   #  Probe     0        1           # Time   hB    hL
//   #   Time
// The forces of OpenFOAM.org, and of OpenFOAM.com before v1606, have vectors in vectors:
//   # Time    forces(pressure viscous) moment(pressure viscous)
//   0.1       ((1 2 3) (4 5 6)) ((1 2 3) (4 5 6))
#include <fmt/format.h>

#include "verification/case/case_definition.hpp"
#include "verification/input/tables/table_head.hpp"

namespace slosh {
namespace {

// The words of a line as names; an unbalanced parenthesis of a word is removed: "(total_x",
// "total_z)".
std::vector<TableColumn> columns_in(std::string_view line) {
  std::vector<TableColumn> columns;
  constexpr std::string_view white = " \t";
  for (std::size_t begin; (begin = line.find_first_not_of(white)) != line.npos;) {
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(white), line.size());
    std::string_view name = line.substr(0, end);
    line.remove_prefix(end);
    if (name.starts_with('(')) name.remove_prefix(1);
    if (name.ends_with(')') && name.find('(') == name.npos) name.remove_suffix(1);
    columns.push_back({std::string(name), ""});
  }
  return columns;
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

// The comments at the beginning of a file.
struct Comments {
  std::vector<std::string> all = {};  // without their marks
  std::string last_line = {};
};

// Reads the comments and advances to the first row.
Comments read_comments(TableReader& reader) {
  Comments comments;
  while (reader.line().starts_with('#')) {
    comments.last_line = reader.line();
    comments.all.emplace_back(without_comment_mark(reader.line()));
    if (!reader.next()) break;
  }
  return comments;
}

TableHead head_of_times(const TableReader& reader, const Comments& comments) {
  return {.columns = {{"Time", "s"}}, .line = reader.line_number() - 1, .text = comments.last_line};
}

// The head with the values' names, extended by the components for vectors. There must be one name
// for each value of the first row, or one for each of its numbers.
TableHead head_of(const TableReader& reader, const Comments& comments,
                  const std::vector<TableColumn>& values) {
  TableHead head = head_of_times(reader, comments);
  const std::vector<std::size_t> sizes = value_sizes(reader.line());
  const bool of_values = sizes.size() == values.size() + 1;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!of_values || sizes[i + 1] == 1) {
      head.columns.push_back(values[i]);
      continue;
    }
    if (sizes[i + 1] != 3)
      reader.refuse("row", reader.line(), "values that are numbers or vectors of three");
    for (const char* component : {".x", ".y", ".z"})
      head.columns.push_back({values[i].name + component, "", values[i].at});
  }
  return head;
}

// What follows "Time" in the last comment that begins with it; empty without such a comment.
std::string after_time(const Comments& comments) {
  std::string rest;
  for (const std::string& comment : comments.all)
    if (comment.starts_with("Time")) rest = comment.substr(4);
  return rest;
}

// The places in comments that begin with the word: "(0.05 0.5 0)" in "Location 0 : (0.05 0.5 0)".
std::vector<std::string> places_of(const Comments& comments, std::string_view word) {
  std::vector<std::string> places;
  for (const std::string& comment : comments.all)
    if (const auto open = comment.find('('); comment.starts_with(word) && open != comment.npos)
      places.push_back(comment.substr(open, comment.find(')', open) - open + 1));
  return places;
}

// The words within the parentheses after a name: "pressure" and "viscous" of "forces(pressure
// viscous)". Commas count as blanks.
std::vector<std::string_view> words_within(std::string_view text, std::string_view name) {
  const std::size_t begin = text.find(name);
  if (begin == text.npos) return {};
  text.remove_prefix(begin + name.size());
  return fields_of(text.substr(0, text.find(')')), text.find(',') < text.find(')') ? ',' : ' ');
}

// "force_pressure_x", ... and the sum of the parts, "force_total_x".
void add_vectors(const std::string& name, const std::vector<std::string_view>& parts,
                 TableHead& head) {
  if (parts.empty()) return;
  const std::size_t first = head.columns.size();
  constexpr std::string_view components = "xyz";
  for (const std::string_view part : parts)
    for (const char component : components)
      head.columns.push_back({fmt::format("{}_{}_{}", name, part, component), ""});
  for (std::size_t i = 0; i < components.size(); ++i) {
    ColumnSum total{fmt::format("{}_total_{}", name, components[i]), {}};
    for (std::size_t part = 0; part < parts.size(); ++part)
      total.columns.push_back(first + components.size() * part + i);
    head.sums.push_back(std::move(total));
  }
}

}  // namespace

TableHead read_openfoam_probes_head(TableReader& reader, const SeriesSource&) {
  const Comments comments = read_comments(reader);
  std::vector<TableColumn> probes;
  for (const std::string& place : places_of(comments, "Probe "))
    probes.push_back({fmt::format("probe_{}", probes.size()), "", place});
  if (probes.empty())
    reader.refuse("head", reader.line(), "lines \"# Probe 0 (x y z)\", as OpenFOAM's probes write");
  return head_of(reader, comments, probes);
}

TableHead read_openfoam_interface_height_head(TableReader& reader, const SeriesSource&) {
  const Comments comments = read_comments(reader);
  std::vector<TableColumn> values = columns_in(after_time(comments));
  if (values.empty() || (values[0].name != "hB" && values[0].name != "p"))
    reader.refuse("head", reader.line(),
                  "a line \"# Time hB hL ...\" or \"# Time p ...\", as OpenFOAM's interfaceHeight "
                  "writes");
  const std::vector<std::string> places = places_of(comments, "Location ");
  const std::size_t of_each = values[0].name == "hB" ? 2 : 1;  // hB and hL of each place, or p
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i].name += fmt::format("_{}", i / of_each);
    if (i / of_each < places.size()) values[i].at = places[i / of_each];
  }
  return head_of(reader, comments, values);
}

TableHead read_openfoam_table_head(TableReader& reader, const SeriesSource&) {
  const Comments comments = read_comments(reader);
  const std::vector<TableColumn> names = columns_in(after_time(comments));
  if (names.empty())
    reader.refuse("head", reader.line(), "a last comment \"# Time NAME ...\", as OpenFOAM writes");
  return head_of(reader, comments, names);
}

TableHead read_openfoam_forces_head(TableReader& reader, const SeriesSource&) {
  const Comments comments = read_comments(reader);
  const std::string names = after_time(comments);
  const auto forces = words_within(names, "forces("), moments = words_within(names, "moment(");
  if (!forces.empty()) {
    TableHead head = head_of_times(reader, comments);
    add_vectors("force", forces, head);
    add_vectors("moment", moments, head);
    return head;
  }
  if (columns_in(names).empty())
    reader.refuse(
        "head", reader.line(),
        "a last comment \"# Time total_x ...\" or \"# Time forces(pressure ...) ...\", as "
        "OpenFOAM's forces write");
  return head_of(reader, comments, columns_in(names));
}

}  // namespace slosh
