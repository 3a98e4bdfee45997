// A time series out of a file that another program wrote. The formats, a closed list:
// - csv: a first line of names, then rows; parted by ';', ',', tabs or blanks
// - dualsphysics_gauge: GaugesSWL_*.csv, GaugesVel_*.csv, GaugesForce_*.csv, GaugesMaxZ_*.csv
// - dualsphysics_points: MeasureTool's CSV files of points (pressures, elevations, velocities)
// - openfoam_probes: probes and patchProbes of a field, columns "probe_0", "probe_1", ...
// - openfoam_interface_height: height.dat and position.dat, "hB_0", "hL_0", "p_0.z", ...
// - openfoam_forces: force.dat and moment.dat of v1912 and later, "total_x", ...
// - openfoam_field_value: volFieldValue.dat, surfaceFieldValue.dat, "volAverage(alpha.liquid)"
// - sphinxsys: the .dat files of observed and reduced quantities, "Position[0][1]"
// - hdf5: data sets by their paths; a result file of this project by a series' group alone
//   ("/series/elevation@right")
// Of a vector the component is part of the column's name: "probe_0.x", "weightedVolIntegrate(U).x".
// A name may come with its unit as in the file ("swlz [m]") or without ("swlz").
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"
#include "verification/series/time_series.hpp"

namespace slosh {

// All of the list above.
std::vector<std::string> import_formats();

// Throws CaseFileError without a place where the format or a unit is none that is known, or where
// the format asks for a time column that is not named or fixes one that is.
void require_known_form(const SeriesSource& source);

// The series in its quantity's unit over times in s. Throws CaseFileError (file:line: what is
// wrong, what was expected) where the file is not of the format or has no such column, and where a
// unit is missing or contradicts the file's (but for a force in N that is told to be one per metre
// of width, "N/m"); ResultError (the same) where its numbers cannot be used: one that is not finite
// or stands for "none" (beyond 1e30), a row of another length or without its line's end, times that
// do not increase (as after a restart), fewer than four rows.
TimeSeries import_series(const SeriesSource& source);

}  // namespace slosh
