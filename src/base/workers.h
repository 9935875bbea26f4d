// The only place that starts threads: splits a range among workers, in parts that no result may depend on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

namespace sturnus {

/// A fixed team of threads. Each part runs with the floating-point settings of the determinism contract
/// (round to nearest, denormals kept) and gets the caller's settings back afterwards.
class Workers {
 public:
  /// `count` threads; 0 means one for each core of the machine.
  explicit Workers(int count = 0);
  ~Workers();
  Workers(Workers&&) noexcept;
  Workers& operator=(Workers&&) noexcept;

  int count() const;

  /// body(begin, end, part) for contiguous parts of [0, n), at most count() of them, part = 0, 1, ...
  /// The same parts for the same n.
  template <class Body>
  void for_ranges(std::size_t n, Body&& body) const {
    run(n, {}, {const_cast<void*>(static_cast<const void*>(&body)), call<std::remove_reference_t<Body>>});
  }

  /// The same with parts that are about equally heavy: `weights` holds for each of the n things the sum of
  /// all weights up to and including its own.
  template <class Body>
  void for_weighted(std::span<const std::uint64_t> weights, Body&& body) const {
    run(weights.size(), weights,
        {const_cast<void*>(static_cast<const void*>(&body)), call<std::remove_reference_t<Body>>});
  }

 private:
  // A body without its type, and without memory of its own.
  struct Erased {
    void* body;
    void (*call)(void* body, std::size_t begin, std::size_t end, int part);
  };
  template <class Body>
  static void call(void* body, std::size_t begin, std::size_t end, int part) {
    (*static_cast<Body*>(body))(begin, end, part);
  }
  void run(std::size_t n, std::span<const std::uint64_t> weights, Erased body) const;

  struct Team;
  std::unique_ptr<Team> team_;
};

}  // namespace sturnus
