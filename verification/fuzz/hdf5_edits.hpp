// Edits of an HDF5 image, each through HDF5 itself, so that the image stays a sound one: links
// removed and led elsewhere, data sets and attributes of other types and shapes put in their
// places.
#pragma once

#include <string>

#include "verification/fuzz/byte_choices.hpp"

namespace slosh {

std::string edited(const std::string& image, ByteChoices& choices);

}  // namespace slosh
