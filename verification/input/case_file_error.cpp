#include "verification/input/case_file_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace slosh {

CaseFileErrors::CaseFileErrors(std::vector<std::string> all)
    : CaseFileError(fmt::format("{}", fmt::join(all, "\n"))), messages(std::move(all)) {}

bool Complaints::allow(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const CaseFileErrors& errors) {
    messages_.insert(messages_.end(), errors.messages.begin(), errors.messages.end());
  } catch (const CaseFileError& error) {
    messages_.push_back(error.what());
  }
  if (messages_.size() >= most) {
    messages_.resize(most);
    messages_.push_back(fmt::format("these are the first {}; there may be more", most));
    tell();
  }
  return false;
}

void Complaints::tell() const {
  if (!messages_.empty()) throw CaseFileErrors(messages_);
}

}  // namespace slosh
