#include "verification/results/provenance.hpp"

#include <fmt/chrono.h>

#include <ctime>
#include <fstream>

namespace slosh {
namespace {

// "model name : AMD ..." of the first processor that Linux lists; empty where it lists none.
std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

}  // namespace

std::map<std::string, std::string> provenance(const std::string& command) {
  return {{"slosh_version", SLOSH_VERSION},
          {"compiler", SLOSH_COMPILER},
          {"compiler_flags", SLOSH_COMPILER_FLAGS},
          {"processor", processor()},
          {"date_utc", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
          {"command", command}};
}

}  // namespace slosh
