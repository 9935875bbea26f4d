// OpenGL ES 3 without a display: an EGL context on Mesa's surfaceless platform.
#pragma once

#include <sturnus/result.h>

#include <memory>
#include <string>

namespace shadertoy {

/// A current context with float targets. All GL objects die before it.
class Headless {
 public:
  /// The context, or one sentence on what is missing and which packages have it.
  static sturnus::Result<std::unique_ptr<Headless>> open();
  ~Headless();
  Headless(const Headless&) = delete;
  Headless& operator=(const Headless&) = delete;

  /// What draws, such as "llvmpipe (LLVM 15.0.6, 256 bits)".
  std::string renderer() const;

 private:
  Headless() = default;
  sturnus::Status start();

  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace shadertoy
