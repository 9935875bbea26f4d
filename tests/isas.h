// The instruction sets by name, and a promise to leave the best one in use.
#pragma once

#include <sturnus/isa.h>

#include <vector>

namespace sturnus::test {

struct NamedIsa {
  Isa isa;
  const char* name;
};

/// All but the plain loop, to which they are compared.
inline constexpr NamedIsa wide_isas[] = {{Isa::best, "best"},
                                         {Isa::sse4, "sse4"},
                                         {Isa::avx2, "avx2"},
                                         {Isa::avx512, "avx512"},
                                         {Isa::neon, "neon"}};

/// Goes back to the best instruction set however a test ends.
struct IsaGuard {
  IsaGuard() = default;
  IsaGuard(const IsaGuard&) = delete;
  IsaGuard& operator=(const IsaGuard&) = delete;
  ~IsaGuard() { use_isa(Isa::best); }
};

}  // namespace sturnus::test
