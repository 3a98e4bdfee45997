// Series in HDF5 files: data sets of one dimension, named by their paths, the unit in an attribute
// "unit" or "units" or told; or a group that holds data sets "time" and "value", as a result file
// of this project has them. Private to verification/import/.
#pragma once

#include <string>
#include <vector>

#include "verification/case/case_definition.hpp"

namespace slosh {

// As they stand in the file, with their units; empty where the file does not say it.
struct RawSeries {
  std::vector<double> time, value;
  std::string time_unit, unit;
};

// Throws CaseFileError where the file has no such data set.
RawSeries read_hdf5_series(const SeriesSource& source);

}  // namespace slosh
