// What a run holds in memory for its particles, array by array and what for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "sph/simulation.hpp"

namespace slosh::sph {

class HeldArrays {
 public:
  // Enters what an array has taken, together with others of that purpose and name; nothing where it
  // has taken nothing.
  template <class Array>
  void add(const std::string& purpose, const std::string& name, const Array& array) {
    const std::size_t bytes = array.capacity() * sizeof(array[0]);
    if (bytes == 0) return;
    const auto same = std::find_if(held_.begin(), held_.end(), [&](const HeldArray& held) {
      return held.purpose == purpose && held.name == name;
    });
    if (same == held_.end())
      held_.push_back({purpose, name, bytes});
    else
      same->bytes += bytes;
  }

  // All that the owner's for_each_named_field tells.
  template <class Owner>
  void add_all(const std::string& purpose, Owner& owner) {
    owner.for_each_named_field(
        [&](const char* name, const auto& array) { add(purpose, name, array); });
  }

  const std::vector<HeldArray>& held() const { return held_; }

 private:
  std::vector<HeldArray> held_;
};

}  // namespace slosh::sph
