#include "reports/model/temporary_directory.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstring>

#include "reports/model/report_error.hpp"

namespace slosh::reports {

TemporaryDirectory::TemporaryDirectory(const std::string& name_start) {
  std::string name = name_start + "XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw ReportError("cannot create a directory " + name + ": " + std::strerror(errno));
  path_ = name;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;  // nothing can be done about a leftover here
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace slosh::reports
