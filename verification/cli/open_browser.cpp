#include "verification/cli/open_browser.hpp"

#include <boost/process.hpp>
#include <cstdlib>
#include <system_error>

namespace slosh {
namespace {

namespace process = boost::process;

std::string browser_name() {
  const char* named = std::getenv("BROWSER");
  const std::string list = named ? named : "";
  const std::string first = list.substr(0, list.find(':'));
  return first.empty() ? "xdg-open" : first;
}

}  // namespace

std::string open_browser(const std::filesystem::path& file) {
  const std::string name = browser_name();
  const boost::filesystem::path program =
      name.find('/') == std::string::npos ? process::search_path(name) : name;
  if (program.empty()) return "there is no program " + name + " (the variable BROWSER names one)";
  std::error_code failure;
  process::child child(program, file.string(), failure);
  if (failure) return name + " did not start: " + failure.message();
  child.wait(failure);
  return child.exit_code() == 0 ? ""
                                : name + " ended with status " + std::to_string(child.exit_code());
}

}  // namespace slosh
