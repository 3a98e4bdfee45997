#include "verification/input/case_file_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace slosh {

CaseFileErrors::CaseFileErrors(std::vector<std::string> all)
    : CaseFileError(fmt::format("{}", fmt::join(all, "\n"))), messages(std::move(all)) {}

void Complaints::keep(const std::string& message) {
  if (messages_.size() < most &&
      std::find(messages_.begin(), messages_.end(), message) == messages_.end())
    messages_.push_back(message);
}

bool Complaints::allow(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const CaseFileErrors& errors) {
    for (const std::string& message : errors.messages) keep(message);
  } catch (const CaseFileError& error) {
    keep(error.what());
  }
  if (messages_.size() >= most) {
    messages_.push_back(fmt::format("these are the first {}; there may be more", most));
    tell();
  }
  return false;
}

void Complaints::tell() const {
  if (!messages_.empty()) throw CaseFileErrors(messages_);
}

}  // namespace slosh
