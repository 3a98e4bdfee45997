// Keeps a file of HDF5 from being a way into other files.
#pragma once

#include <hdf5.h>

namespace slosh::hdf5 {

// Throws Hdf5Error (hdf5_handles.hpp) unless all that the opened file holds lies in it: for a link
// to another file or of a kind that a program defines, for a data set whose values lie in other
// files (external storage, virtual data sets) or go through a filter that is not part of HDF5, and
// for groups more than 64 deep in one another. Reads no value. HDF5 loads no plugin from then on.
void require_self_contained(hid_t file);

}  // namespace slosh::hdf5
