// Several builds of the hot functions from one source, chosen at run time: for AVX-512, for AVX2,
// and for the instructions that every processor of the architecture has. With SLOSH_PLAIN_LOOPS,
// which sanitized builds define, there is the last one alone.
#pragma once

#include "sph/neighbours/lanes.hpp"

namespace slosh::sph {

enum class InstructionSet { plain, avx2, avx512 };
inline constexpr InstructionSet instruction_sets[] = {InstructionSet::plain, InstructionSet::avx2,
                                                      InstructionSet::avx512};

inline const char* instruction_set_name(InstructionSet set) {
  switch (set) {
    case InstructionSet::plain:
      return "plain";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "";
}

#if defined(__x86_64__) && !defined(SLOSH_PLAIN_LOOPS)
inline bool has(InstructionSet set) {
  __builtin_cpu_init();
  if (set == InstructionSet::avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (set == InstructionSet::avx2)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  return true;
}

// `flatten` inlines everything that `function` calls into the build for the wider instructions.
template <auto function, class... Arguments>
[[gnu::target("arch=x86-64-v4"), gnu::flatten]] void call_avx512(Arguments... arguments) {
  function(arguments...);
}
template <auto function, class... Arguments>
[[gnu::target("arch=x86-64-v3"), gnu::flatten]] void call_avx2(Arguments... arguments) {
  function(arguments...);
}

// Calls function(arguments...) in its build for `set`, which the processor must have.
template <auto function, class... Arguments>
void call(InstructionSet set, Arguments... arguments) {
  switch (set) {
    case InstructionSet::avx512:
      return call_avx512<function>(arguments...);
    case InstructionSet::avx2:
      return call_avx2<function>(arguments...);
    case InstructionSet::plain:
      return function(arguments...);
  }
}

// Calls Loop::run<Number>(arguments...) in its build for `set`, where Number is the vector that
// fills one of the set's registers.
template <class Loop, class... Arguments>
void call_in_registers(InstructionSet set, Arguments... arguments) {
  switch (set) {
    case InstructionSet::avx512:
      return call_avx512<&Loop::template run<Lanes>>(arguments...);
    case InstructionSet::avx2:
      return call_avx2<&Loop::template run<FourLanes>>(arguments...);
    case InstructionSet::plain:
      return Loop::template run<TwoLanes>(arguments...);
  }
}
#else
inline bool has(InstructionSet set) { return set == InstructionSet::plain; }
template <auto function, class... Arguments>
void call(InstructionSet, Arguments... arguments) {
  function(arguments...);
}
template <class Loop, class... Arguments>
void call_in_registers(InstructionSet, Arguments... arguments) {
  Loop::template run<TwoLanes>(arguments...);
}
#endif

inline InstructionSet widest_instruction_set() {
  if (has(InstructionSet::avx512)) return InstructionSet::avx512;
  return has(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::plain;
}

}  // namespace slosh::sph
