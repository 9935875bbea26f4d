// The only place that starts threads: splits a range among workers, in parts that no result may depend on.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

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
  void for_ranges(std::size_t n, const std::function<void(std::size_t, std::size_t, int)>& body) const;

 private:
  struct Team;
  std::unique_ptr<Team> team_;
};

}  // namespace sturnus
