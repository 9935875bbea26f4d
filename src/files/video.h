// Videos, by way of the ffmpeg program.
#pragma once

#include <memory>
#include <string>

#include "sturnus/picture.h"
#include "sturnus/result.h"

namespace sturnus {

/// Whether an executable ffmpeg is on the PATH.
bool ffmpeg_available();

/// Whether a name ends in .mp4 or .gif, in either case of letters.
bool is_video_name(const std::string& path);

/// Everything that can be known to stand in the way before the first frame is drawn: the ending, the folder,
/// and whether ffmpeg is there. To be asked before a long run begins.
Status check_video(const std::string& path);

/// Takes frames one by one and makes a video of them: H.264 in .mp4, a palette for each frame in .gif.
/// The file appears under its name when `finish` succeeds, and never otherwise.
class VideoWriter {
 public:
  /// Starts ffmpeg. All frames have to have this size; an odd last row or column is cut off in .mp4, which
  /// has none. `frames_per_second` is what the player shows, 1 to 1000; a .gif keeps at most 50.
  static Result<VideoWriter> open(const std::string& path, Size size, double frames_per_second);

  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  /// Without `finish`: stops ffmpeg and leaves nothing.
  ~VideoWriter();

  /// Hands over the next frame. After a problem no more frames are taken.
  Status add(const Image& frame);

  /// Waits for ffmpeg to complete the file, and gives the file its name.
  Status finish();

 private:
  struct Job;
  explicit VideoWriter(std::unique_ptr<Job> job);
  std::unique_ptr<Job> job_;
};

}  // namespace sturnus
