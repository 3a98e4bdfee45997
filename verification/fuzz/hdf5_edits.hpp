// Edits of an HDF5 image, each through HDF5 itself, so that the image stays a sound one: links
// removed and led elsewhere, data sets and attributes of other types and shapes put in their
// places.
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <string>

namespace slosh {

std::string edited(const std::string& image, FuzzedDataProvider& choices);

}  // namespace slosh
