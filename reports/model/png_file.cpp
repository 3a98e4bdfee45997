#include "reports/model/png_file.hpp"

#include <string_view>

namespace slosh::reports {

bool is_whole_png(const std::string& bytes) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n", end = "IEND\xae\x42\x60\x82";
  return bytes.starts_with(signature) && bytes.ends_with(end);
}

}  // namespace slosh::reports
