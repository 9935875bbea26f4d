// Radix sort by Z-order keys, in parts whose number the result does not depend on.
#include "neighbours/morton.h"

#include <bit>
#include <functional>
#include <utility>

namespace sturnus {
namespace {

// Few boids are not worth many counts or many threads.
int digit_bits(std::size_t count) {
  return count < 4096 ? 8 : 11;
}
std::size_t parts_of(std::size_t count, const Workers& workers) {
  return std::min(static_cast<std::size_t>(workers.count()), 1 + count / 8192);
}

std::uint64_t varying_bits(const std::vector<Keyed>& keyed) {
  std::uint64_t varying = 0;
  for (const Keyed& one : keyed) varying |= one.key ^ keyed.front().key;
  return varying;
}

}  // namespace

void KeySort::sort(std::vector<Keyed>& keyed, const Workers& workers) {
  const std::uint64_t varying = varying_bits(keyed);
  const int bits = digit_bits(keyed.size());
  spare_.resize(keyed.size());
  for (int shift = 0; shift < 64 && varying >> shift != 0; shift += bits) {
    shift += std::countr_zero(varying >> shift);  // what all have in common needs no pass
    pass(keyed, spare_, {shift, bits}, workers);
    keyed.swap(spare_);
  }
}

void KeySort::pass(const std::vector<Keyed>& from, std::vector<Keyed>& to, Digit digit,
                   const Workers& workers) {
  const std::size_t parts = parts_of(from.size(), workers);
  const std::size_t digits = std::size_t{1} << digit.bits;
  counts_.assign(parts * digits, 0);
  const auto for_part = [&](const auto& body) {
    const auto run = [&](std::size_t first, std::size_t last, int) {
      for (std::size_t part = first; part < last; ++part)
        body(from.size() * part / parts, from.size() * (part + 1) / parts, &counts_[part * digits]);
    };
    workers.for_ranges(parts, std::ref(run));
  };
  for_part([&](std::size_t begin, std::size_t end, std::uint32_t* counts) {
    for (std::size_t i = begin; i < end; ++i) ++counts[digit.of(from[i].key)];
  });
  std::uint32_t before = 0;
  for (std::size_t value = 0; value < digits; ++value) {
    for (std::size_t part = 0; part < parts; ++part)
      before += std::exchange(counts_[part * digits + value], before);
  }
  for_part([&](std::size_t begin, std::size_t end, std::uint32_t* next) {
    for (std::size_t i = begin; i < end; ++i) to[next[digit.of(from[i].key)]++] = from[i];
  });
}

}  // namespace sturnus
