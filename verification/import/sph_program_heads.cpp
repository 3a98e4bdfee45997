// Tables of other SPH programs.
//
// DualSPHysics 5: the gauges that the solver itself writes (JGaugeItem.cpp, JDsGaugeItem.cpp:
// "time [s];swlx [m];swly [m];swlz [m];pos0x [m];..."), and the points of its MeasureTool, whose
// positions come in lines before the names (" ;PosX [m]:;0.05", then "Part;Time [s];Press_0 [Pa]").
// Both are separated by ';', or by ',' where the program was configured so.
//
// SPHinXsys: the files of observed and reduced quantities (io_observation.h, io_plt.cpp). Names are
// in quotes with blanks between them, the first is "run_time" in s. A program that is restarted
// writes its head again.
#include <algorithm>

#include "verification/case/case_definition.hpp"
#include "verification/input/tables/table_head.hpp"

namespace slosh {
namespace {

char semicolon_or_comma(std::string_view line) { return line.find(';') != line.npos ? ';' : ','; }

// A gauge of the surface searches along a line from pos0 to pos2. Where the surface is beyond the
// line it writes pos2 as the surface, and where it finds no liquid it writes pos0.
std::vector<MarkOfNone> marks_of_surface_gauge(const TableHead& head) {
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(head.columns.begin(), head.columns.end(),
                     [&](const TableColumn& column) { return column.name == name; }) -
        head.columns.begin());
  };
  const std::size_t surface = place("swlz"), low = place("pos0z"), high = place("pos2z");
  if (std::max({surface, low, high}) == head.columns.size()) return {};
  return {{surface, high,
           "a surface below the end of the gauge's line, which stands in pos2z: the surface is "
           "beyond it, and the line has to be longer"},
          {surface, low,
           "a surface above the beginning of the gauge's line, which stands in pos0z: the gauge "
           "found no liquid, and the line has to begin lower"}};
}

// A gauge of forces measures that on the boundary of its mkbound, which may be one wall.
void refuse_part_as_whole(const TableReader& reader, const SeriesSource& source) {
  const bool is_force = column_of(source.column).name.starts_with("force");
  if (!is_force || source.whole_tank || source.quantity.find('@') != std::string::npos) return;
  reader.refuse(
      "quantity", source.quantity,
      "the force on one wall, as " + source.quantity +
          "@right: the file holds that on the boundary of its gauge (target mkbound); "
          "whole_tank = true, or --whole-tank, says that this boundary is the whole tank");
}

}  // namespace

TableHead read_dualsphysics_gauge_head(TableReader& reader, const SeriesSource& source) {
  const char separator = semicolon_or_comma(reader.line());
  TableHead head = head_of_line(reader, separator);
  if (head.columns.size() < 2 || head.columns[0].name != "time" || head.columns[0].unit != "s")
    reader.refuse("head", reader.line(),
                  "\"time [s]\" and more, as a gauge of DualSPHysics writes");
  refuse_part_as_whole(reader, source);
  head.marks = marks_of_surface_gauge(head);
  reader.next();
  return head;
}

TableHead read_dualsphysics_points_head(TableReader& reader, const SeriesSource&) {
  const auto is_position = [](std::string_view line) {
    return trimmed(line).starts_with(';') || trimmed(line).starts_with(',') ||
           line.starts_with("Pos");
  };
  while (is_position(reader.line()) && reader.next()) {
  }
  const char separator = semicolon_or_comma(reader.line());
  TableHead head = head_of_line(reader, separator);
  head.time = 1;
  if (head.columns.size() < 3 || head.columns[0].name != "Part" || head.columns[1].name != "Time" ||
      head.columns[1].unit != "s")
    reader.refuse("head", reader.line(),
                  "\"Part;Time [s];\" and more after the points' positions, as MeasureTool writes");
  reader.next();
  return head;
}

TableHead read_sphinxsys_head(TableReader& reader, const SeriesSource&) {
  TableHead head = head_of_line(reader, ' ');
  if (head.columns.size() < 2 || head.columns[0].name != "run_time")
    reader.refuse("head", reader.line(), "\"run_time\" and more, as SPHinXsys writes");
  head.columns[0].unit = "s";
  reader.next();
  return head;
}

}  // namespace slosh
