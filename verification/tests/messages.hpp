// What a text holds, and what an exception says.
#pragma once

#include <gtest/gtest.h>

#include <exception>
#include <string>

namespace slosh {

inline ::testing::AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess() << text;
  return ::testing::AssertionFailure() << "no '" << part << "' in:\n" << text;
}

inline ::testing::AssertionResult begins(const std::string& text, const std::string& start) {
  if (text.starts_with(start)) return ::testing::AssertionSuccess() << text;
  return ::testing::AssertionFailure() << "got:    " << text << "\nwanted: " << start;
}

// Returns what the error says that `act` ends with; "" where it ends without one. Another exception
// is passed on.
template <class Error = std::exception, class Act>
std::string message_of(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace slosh
