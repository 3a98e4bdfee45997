// Reads files that others wrote by a library that such a file may crash, hold up for ever or make
// ask for all memory.
#pragma once

#include <cstdint>
#include <functional>

namespace slosh {

// Lets a child process read first, and reads here only what it came to the end of: the child is a
// copy of this process, so that the same bytes have the same effect. The child may take
//   processor time: 10 s, and 1 s for each 1,000,000 bytes of the file (HDF5 reads over a hundred
//   times as much in a second);
//   memory: 1 GiB, and 32 bytes for each byte of the file (a stored byte may become a number of
//   8 bytes, which conversions and copies hold up to four times).
// Throws std::runtime_error with the text of the exception that `read` threw in the child, or with
// what ended the child. `read` must leave nothing behind but what it writes to memory, and starts
// no thread.
void read_guarded(std::uintmax_t file_size, const std::function<void()>& read);

}  // namespace slosh
