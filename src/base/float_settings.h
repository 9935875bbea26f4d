// The floating-point settings of the determinism contract, wherever the state is computed.
#pragma once

#include <cfenv>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace sturnus {

/// Round to nearest and no flush-to-zero while it lives: a host program may have set either.
class FloatSettings {
 public:
  FloatSettings() : rounding_(std::fegetround()) {
    std::fesetround(FE_TONEAREST);
#if defined(__SSE2__)
    control_ = _mm_getcsr();
    _mm_setcsr(control_ & ~0x8040u);
#endif
  }
  ~FloatSettings() {
#if defined(__SSE2__)
    _mm_setcsr(control_);
#endif
    std::fesetround(rounding_);
  }
  FloatSettings(const FloatSettings&) = delete;
  FloatSettings& operator=(const FloatSettings&) = delete;

 private:
  int rounding_;
#if defined(__SSE2__)
  unsigned control_ = 0;
#endif
};

}  // namespace sturnus
