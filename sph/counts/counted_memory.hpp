// The program's own memory, counted at operator new and delete, which this file's source replaces.
#pragma once

#include <cstddef>

namespace slosh::sph {

struct MemoryCount {
  std::size_t now, peak;  // [byte]; `peak` since the last restart
};
MemoryCount counted_memory();
void restart_peak();

}  // namespace slosh::sph
