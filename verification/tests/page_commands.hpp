// The command lines of a page, run in their order as a reader would type them.
#pragma once

#include <regex>
#include <string>
#include <vector>

#include "verification/tests/documents.hpp"
#include "verification/tests/small_campaign.hpp"

namespace slosh {

// A command line of a page, and how it ends.
struct TypedLine {
  std::string line;
  int status = 0;
};

class PageCommands : public SmallCampaign {
 protected:
  PageCommands() {
    std::filesystem::create_directory_symlink(std::filesystem::path(SLOSH_SOURCE_DIR) / "docs",
                                              directory() / "docs");
  }

  std::string page(const std::string& name) const { return read(directory() / "docs" / name); }

  // The lines of code that begin with one of the page's programs.
  static std::vector<std::string> command_lines(const std::string& text) {
    return documents::all_matches(text, R"(\n    ((?:\./slosh|g\+\+|sed|cp) [^\n]*))");
  }

  // Runs a line by the shell in the directory. ./slosh is the tool, and g++ the build's compiler.
  Ended shell(const std::string& line, const std::string& place = ".") const {
    const std::string typed = std::regex_replace(
        std::regex_replace(line, std::regex(R"(\./(slosh/)?slosh )"), "\"$$TOOL\" "),
        std::regex(R"(g\+\+ )"), "\"$$COMPILER\" ");
    return end_of(start("/bin/sh", {"-c", "cd \"$PLACE\" && " + typed},
                        {{"TOOL", SLOSH_TOOL}, {"COMPILER", SLOSH_COMPILER}, {"PLACE", place}}));
  }
};

}  // namespace slosh
