// The fuzz targets read in their own process, so that they see what a child process would keep from
// them.
#include "verification/files/foreign/guarded_reading.hpp"

namespace slosh {

void read_guarded(std::uintmax_t, const std::function<void()>& read) { read(); }

}  // namespace slosh
