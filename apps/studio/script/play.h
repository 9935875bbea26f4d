// A scripted visit from its beginning to its end, filmed where that is wanted.
#pragma once

#include <string>

#include "script/script.h"
#include "studio.h"

namespace studio {

struct PlayOptions {
  std::string video;           ///< .mp4 or .gif; empty: no film
  int frames_per_second = 30;  ///< of the film
};

/// Plays it in a studio that goes in lockstep, and waits until the film is written. Problems have the
/// script's file and line, or the film's name.
sturnus::Status play(Studio& studio, const Script& script, const PlayOptions& options);

}  // namespace studio
