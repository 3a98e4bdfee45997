#include "verification/import/file_formats.hpp"

namespace slosh {

// Each of these readers is defined in the file that knows its format.
using HeadReader = TableHead(TableReader&, const SeriesSource&);
using SeriesReader = RawSeries(const SeriesSource&);
HeadReader read_dualsphysics_gauge_head, read_dualsphysics_points_head, read_sphinxsys_head;
HeadReader read_openfoam_probes_head, read_openfoam_interface_height_head, read_openfoam_table_head;
HeadReader read_openfoam_forces_head;
SeriesReader read_hdf5_series;

namespace {

TableHead read_csv_head(TableReader& reader, const SeriesSource& source) {
  TableHead head = find_head(reader, {source.time_column, source.column});
  head.time = column_place(reader, head, "time_column", source.time_column);
  return head;
}

}  // namespace

const std::vector<FileFormat>& file_formats() {
  static const std::vector<FileFormat> formats{
      {.name = "csv",
       .files = "a line with names, then rows; separated by semicolons, commas, tabs or blanks",
       .columns = "any names; --time or time_column names the column of times",
       .example = "",
       .time_column = TimeColumn::must_be_named,
       .read_head = read_csv_head},
      {.name = "dualsphysics_gauge",
       .files = "GaugesSWL_*.csv, GaugesVel_*.csv, GaugesForce_*.csv, GaugesMaxZ_*.csv",
       .columns = "swlz, forcex, ...",
       .example = "swlz",
       .read_head = read_dualsphysics_gauge_head},
      {.name = "dualsphysics_points",
       .files = "CSV files of MeasureTool",
       .columns = "Elevation_0, Press_0, Vel_0.x, ...",
       .example = "Elevation_0",
       .read_head = read_dualsphysics_points_head},
      {.name = "openfoam_probes",
       .files = "probes and patchProbes of a field",
       .columns = "probe_0; for a vector probe_0.x, ...",
       .example = "probe_0",
       .read_head = read_openfoam_probes_head},
      {.name = "openfoam_interface_height",
       .files = "height.dat, position.dat",
       .columns = "hB_0, hL_0, p_0.z, ...",
       .example = "hB_0",
       .read_head = read_openfoam_interface_height_head},
      {.name = "openfoam_forces",
       .files = "force.dat, moment.dat; forces.dat of OpenFOAM.org",
       .columns = "total_x, pressure_x, ...; force_total_x, moment_pressure_y, ...",
       .example = "total_x",
       .read_head = read_openfoam_forces_head},
      {.name = "openfoam_field_value",
       .files = "volFieldValue.dat, surfaceFieldValue.dat",
       .columns = "volAverage(alpha.water), weightedVolIntegrate(U).x, ...",
       .example = "volAverage(alpha.water)",
       .read_head = read_openfoam_table_head},
      {.name = "sphinxsys",
       .files = "observed and reduced quantities (.dat)",
       .columns = "Position[0][1], ...",
       .example = "Position[0][1]",
       .read_head = read_sphinxsys_head},
      {.name = "hdf5",
       .files = "data sets of one row or column; groups with time and value",
       .columns = "paths; for a data set --time or time_column names that of the times",
       .example = "",
       .time_column = TimeColumn::may_be_named,
       .read_series = read_hdf5_series}};
  return formats;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const FileFormat& format : file_formats()) names.push_back(format.name);
  return names;
}

}  // namespace slosh
