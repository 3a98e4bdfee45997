#include "sph/counts/counted_memory.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace slosh::sph {
namespace {

std::atomic<std::size_t> held{0}, most{0};

void* counted(void* p) {
  if (!p) throw std::bad_alloc();
  const std::size_t now = held += malloc_usable_size(p);
  std::size_t before = most;
  while (before < now && !most.compare_exchange_weak(before, now)) {
  }
  return p;
}

void release(void* p) {
  if (p) held -= malloc_usable_size(p);
  std::free(p);
}

}  // namespace

MemoryCount counted_memory() { return {held, most}; }
void restart_peak() { most = held.load(); }

}  // namespace slosh::sph

// The array and nothrow forms of these operators call the forms replaced here.
void* operator new(std::size_t bytes) {
  return slosh::sph::counted(std::malloc(bytes ? bytes : 1));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  const std::size_t unit = static_cast<std::size_t>(alignment);
  return slosh::sph::counted(std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit));
}
void operator delete(void* p) noexcept { slosh::sph::release(p); }
void operator delete(void* p, std::size_t) noexcept { slosh::sph::release(p); }
void operator delete(void* p, std::align_val_t) noexcept { slosh::sph::release(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { slosh::sph::release(p); }
