#include "reports/model/report_files.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "reports/model/report_model.hpp"

namespace slosh::reports {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw ReportError("cannot read " + path.string() + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();  // a full disk fails here at the latest
  if (!file) throw ReportError("cannot write " + path.string() + ": " + std::strerror(errno));
}

TemporaryDirectory::TemporaryDirectory(const std::string& name_start) {
  std::string name = name_start + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw ReportError("cannot create a directory " + name + ": " + std::strerror(errno));
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;  // nothing can be done here about what is left
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace slosh::reports
