#include "verification/input/toml_letters.hpp"

#include <gtest/gtest.h>

#include "verification/input/case_file_error.hpp"
#include "verification/input/toml_reader.hpp"
#include "verification/tests/messages.hpp"

namespace slosh::toml_letters_test {
namespace {

TEST(TomlLetters, AreFoundWithTheirPlaceWhereTheyStandOutsideStrings) {
  const auto place = letter_outside_strings("a = 1\nb = 2 \xC2\xA1");
  ASSERT_TRUE(place);
  EXPECT_EQ(place->line, 2);
  EXPECT_EQ(place->column, 7);
}

TEST(TomlLetters, AreAllowedInStringsOfEveryKindAndInComments) {
  for (const char* text :
       {"a = \"\xC3\xA4\" # \xC3\xA4", "a = '\xC3\xA4\\'", "a = \"\\\"\xC3\xA4\"",
        "a = \"\"\"\n\"\xC3\xA4\"\n\"\"\"", "a = '''\n'\xC3\xA4'\n'''",
        "\xEF\xBB\xBF"
        "a = 1"})
    EXPECT_FALSE(letter_outside_strings(text)) << text;
}

TEST(TomlLetters, BehindAClosedStringAreFound) {
  EXPECT_TRUE(letter_outside_strings("a = \"b\"\xC3\xA4"));
  EXPECT_TRUE(letter_outside_strings("a = '\\'\xC3\xA4"));
}

TEST(TomlLetters, AreRefusedByTheReaderWithTheirPlace) {
  EXPECT_EQ(
      message_of<CaseFileError>(
          [] { TomlTable("name = \xE2\x80\x9Ctank\xE2\x80\x9D\n", "trial.toml"); }),
      "trial.toml:1:8: not TOML: a letter beyond ASCII; expected such letters only in strings "
      "and comments");
}

TEST(TomlLetters, AreTooManyDotsInAKeyAlone) {
  const auto dotted = [](int dots) {
    std::string key = "a";
    for (int i = 0; i < dots; ++i) key += i % 3 == 0 ? " . 'b.c'" : ".a";
    return key;
  };
  for (const std::string& text : {dotted(100) + " = 1", "[" + dotted(100) + "]\n" + dotted(100)})
    EXPECT_FALSE(end_of_deep_key(text));
  for (const std::string& text :
       {dotted(101) + " = 1", "[" + dotted(101) + "]", "a = {b = 1, " + dotted(101) + " = 2}"})
    EXPECT_TRUE(end_of_deep_key(text));
  std::string numbers = "a = [", words = "a = \"", comment = "# ";
  for (int i = 0; i < 1000; ++i) {
    numbers += "0.5, ";
    words += "a.";
    comment += ".";
  }
  for (const std::string& text : {numbers + "]", words + "\"", comment + "\na = 1"})
    EXPECT_FALSE(end_of_deep_key(text));
}

}  // namespace
}  // namespace slosh::toml_letters_test
