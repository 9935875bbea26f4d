// The instruction set that the neighbour sums run on.
#pragma once

#include <cstdint>
#include <string>

namespace sturnus {

/// The best that the machine has, the plain loop, or one instruction set.
enum class Isa : std::uint8_t { best, plain, sse4, avx2, avx512, neon };

/// Chooses for the whole process; false where the machine lacks it, and nothing changes then. No result
/// depends on the choice. For tests and benchmarks, between steps only.
bool use_isa(Isa isa);

/// The name of what is in use, such as "avx512"; "plain" for the plain loop.
std::string isa_in_use();

}  // namespace sturnus
