// A campaign that takes seconds, in a directory whose name has a space and a letter beyond ASCII,
// and the tool as a user starts it there.
#pragma once

#include <gtest/gtest.h>

#include <boost/algorithm/string/erase.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/process.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "verification/tests/messages.hpp"
#include "verification/tests/small_case.hpp"
#include "verification/tests/temporary_directory.hpp"

namespace slosh {

inline bool has_interfoam() { return !boost::process::search_path("interFoam").empty(); }

// The words of a line as one types it; '' is an empty word.
inline std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word == "''" ? "" : word);
  return words;
}

struct Ended {
  int status;  // the exit status, or minus the signal
  std::string out, err;
};

class SmallCampaign : public ::testing::Test {
 protected:
  using Environment = std::map<std::string, std::string>;

  SmallCampaign() { std::filesystem::create_directories(directory()); }

  std::filesystem::path directory() const { return temporary_.path() / "a tänk"; }
  // A link into the store.
  std::filesystem::path result(const std::string& run) const {
    return directory() / "out" / "runs" / "small" / (run + ".h5");
  }
  std::filesystem::path store() const { return directory() / "out" / "store"; }
  std::vector<std::filesystem::path> files_of_store(const std::string& ending) const {
    std::vector<std::filesystem::path> found;
    if (!std::filesystem::exists(store())) return found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(store()))
      if (entry.path().filename().string().ends_with(ending)) found.push_back(entry.path());
    return found;
  }
  std::filesystem::path report() const { return directory() / "out" / "report"; }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(directory() / file, std::ios::binary) << text;
  }
  void write_campaign(const std::string& case_text) const {
    write("small.toml", case_text);
    write("surges.toml",
          "schema_version = 1\nname = \"surges\"\ntitle = \"Small surges\"\n"
          "source = \"made for a test\"\ncases = [\"./small.toml\"]\n");
  }
  std::string read(const std::filesystem::path& file) const {
    std::ifstream stream(directory() / file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  // The words of all pages of the report, with one bar in place of the tags between two of them.
  std::string report_words() const {
    std::string words;
    for (const auto& page : std::filesystem::directory_iterator(report())) {
      if (page.path().extension() != ".html") continue;
      std::string text = read(page.path());
      boost::erase_all(text, "<wbr>");
      bool in_tag = false;
      for (const char c : text) {
        in_tag = c == '<' || (in_tag && c != '>');
        const bool after_bar = words.ends_with('|');
        if (c == '>' && !after_bar) words += '|';
        if (c != '>' && !in_tag && !(after_bar && (c == ' ' || c == '\n'))) words += c;
      }
    }
    for (const auto& [entity, sign] : {std::pair{"&apos;", "'"}, {"&gt;", ">"}, {"&lt;", "<"}})
      boost::replace_all(words, entity, sign);
    return words;
  }

  // Starts a program in the directory, its output in files there.
  boost::process::child start(const std::string& program, const std::vector<std::string>& arguments,
                              const Environment& more = {}) const {
    namespace bp = boost::process;
    bp::environment environment = boost::this_process::environment();
    environment["OMP_NUM_THREADS"] = "1";
    environment.erase("SLOSH_EXPERIMENTS");  // what the user has is no part of a test
    environment["SLOSH_STORE"] = store().string();
    for (const auto& [name, value] : more) environment[name] = value;
    const std::string out = (temporary_.path() / "out").string(),
                      err = (temporary_.path() / "err").string();
    for (const std::string& file : {out, err}) std::filesystem::remove(file);  // not truncated
    return bp::child(bp::exe = program, bp::args = arguments, environment,
                     bp::start_dir = directory().string(), bp::std_out > out, bp::std_err > err,
                     bp::std_in < bp::null);
  }
  boost::process::child start_tool(const std::vector<std::string>& arguments) const {
    return start(SLOSH_TOOL, arguments);
  }
  Ended end_of(boost::process::child child) const {
    child.wait();
    const int status = child.native_exit_code();
    return {WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status),
            read(temporary_.path() / "out"), read(temporary_.path() / "err")};
  }
  Ended tool(const std::vector<std::string>& arguments, const Environment& more = {}) const {
    return end_of(start(SLOSH_TOOL, arguments, more));
  }
  Ended typed(const std::string& line, const Environment& more = {}) const {
    return tool(words_of(line), more);
  }
  // `slosh run` of the case small.toml, whose result stays in the directory.
  Ended run(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "./small.toml", name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return tool(arguments);
  }
  Ended campaign() const { return typed("campaign ./surges.toml --output out"); }

 private:
  TemporaryDirectory temporary_;
};

}  // namespace slosh
