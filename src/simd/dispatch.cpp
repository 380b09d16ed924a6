#include "simd/dispatch.hpp"

#include <cstdlib>
#include <cstring>

namespace graze {

// The features that the levels v3 and v4 of the x86-64 psABI name and that compilers make use of; clang 14 has no names
// for the levels. The result includes the operating system's part, saving the wider registers.
bool isa_available(Isa level) {
#ifdef GRAZE_ONLY_LEVEL
  return level == Isa::GRAZE_ONLY_LEVEL;
#else
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
                  __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("popcnt");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return level == Isa::baseline || (level == Isa::avx2 ? v3 : v4);
#endif
}

Isa isa_by_name(const char* name) {
  struct Named {
    Isa level;
    const char* name;
  };
  constexpr Named levels[] = {{Isa::avx512, "avx512"}, {Isa::avx2, "avx2"}, {Isa::baseline, "baseline"}};
  if (name != nullptr)
    for (const Named& known : levels)
      if (std::strcmp(name, known.name) == 0 && isa_available(known.level)) return known.level;
  for (const Named& known : levels)
    if (isa_available(known.level)) return known.level;
  return Isa::baseline;
}

Isa chosen_isa() {
  static const Isa level = isa_by_name(std::getenv("GRAZE_ISA"));
  return level;
}

}  // namespace graze
