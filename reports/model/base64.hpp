// Bytes as text (RFC 4648, section 4).
#pragma once

#include <string>

namespace slosh::reports {

std::string base64(const std::string& bytes);

}  // namespace slosh::reports
