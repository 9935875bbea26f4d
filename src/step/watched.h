// Tells who looks on of a stretch of a phase, for as long as this lives.
#pragma once

#include <sturnus/watch.h>

namespace sturnus {

class Watched {
 public:
  /// `watch` may be null: nobody looks on.
  Watched(StepWatch* watch, Phase phase, int part) : watch_(watch), phase_(phase), part_(part) {
    if (watch_ != nullptr) watch_->begin(phase_, part_);
  }
  ~Watched() {
    if (watch_ != nullptr) watch_->end(phase_, part_);
  }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  StepWatch* watch_;
  Phase phase_;
  int part_;
};

}  // namespace sturnus
