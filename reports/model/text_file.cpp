#include "reports/model/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "reports/model/report_error.hpp"

namespace slosh::reports {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReportError("cannot read " + path.string() + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();  // a full disk shows here at the latest
  if (!file) throw ReportError("cannot write " + path.string() + ": " + std::strerror(errno));
}

}  // namespace slosh::reports
