// What a PNG file must begin and end with.
#pragma once

#include <string>

namespace slosh::reports {

// Whether the bytes have the first bytes and the last chunk of every PNG file (its specification,
// 5.2 and 11.2.5).
bool is_whole_png(const std::string& bytes);

}  // namespace slosh::reports
