// Mixing of bits: for the state hash, and for the cheap choice of sampled neighbours.
#pragma once

#include <cstdint>
#include <cstring>

namespace sturnus {

/// A bijection of 64 bits in which every input bit moves every output bit (the finaliser of splitmix64).
constexpr std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Folds one value into a hash; the order of folding matters.
constexpr std::uint64_t fold(std::uint64_t hash, std::uint64_t value) {
  return mix(hash + 0x9e3779b97f4a7c15ull + value);
}

inline std::uint64_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline std::uint64_t bits_of(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace sturnus
