// Measures a page as headless Chromium shows it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace slosh::reports {

struct BrowserRun {
  nlohmann::json phone, desk;  // what the page measures at either width (headless_browser.cpp)
  std::string log;             // holds "CONSOLE" where a script or a resource failed
};

// What a page of a test's own measured.
struct MeasuredPage {
  nlohmann::json measures;
  std::string log;  // as above
};

bool browser_is_installed();

// Opens an HTML document that writes JSON into its <pre id="measures">, in at most five seconds of
// its own clock; files beside it are relative to the directory. The browser's own files stay there.
// Throws std::runtime_error if the browser does not answer within a minute.
MeasuredPage measure_in_browser(const std::filesystem::path& directory, const std::string& document,
                                bool dark);

// Opens the page, whose path is relative to the directory, as measure_in_browser() does.
BrowserRun open_in_browser(const std::filesystem::path& directory, const std::string& page,
                           bool dark);

}  // namespace slosh::reports
