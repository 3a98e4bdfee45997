// Shows a file in the user's browser.
#pragma once

#include <filesystem>
#include <string>

namespace slosh {

// The program that the variable BROWSER names (the first of a list), or else xdg-open, without a
// shell; it is waited for, as a browser in the terminal needs it. Returns why none showed the file;
// empty where one did.
std::string open_browser(const std::filesystem::path& file);

}  // namespace slosh
