// The program's own memory, counted in operator new and delete, which counted_memory.cpp replaces.
#pragma once

#include <cstddef>

namespace slosh::sph {

struct MemoryCount {
  std::size_t now, peak;  // [byte]; `peak` since the last restart
};
MemoryCount counted_memory();
void restart_peak();

}  // namespace slosh::sph
