// What a script says about the files beside it.
#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace slosh {

struct ScriptWords {
  std::set<std::string> files;    // which may name a file as it is
  std::set<std::string> modules;  // which are loaded by a bare name, as `mine.fast`
  std::string suffix;             // of the modules' files, ".py"; empty where there are none
};

// Returns the words of a text, without comments. The language follows from the file's suffix or
// its first line. In Python, Ruby, Lua, JavaScript and Perl what stands in strings may name a file,
// and what is imported is a module: `import mine`, `from mine import k`, `require "mine"`,
// `import_module("mine")`; a variable is neither. In a shell a variable names nothing. In Octave
// each word that is not assigned may be a function of a file. Any other text has words alone.
ScriptWords words_of_script(const std::filesystem::path& file, const std::string& text);

// Each word once; one without a letter is a number.
std::set<std::string> words_of(const std::string& text);

}  // namespace slosh
