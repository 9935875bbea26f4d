// Movies: a video through ffmpeg, or a row of numbered pictures. What a file name means is decided here.
#include <sturnus/files.h>

#include <optional>

#include "files/atomic_file.h"
#include "files/frame_files.h"
#include "files/picture_files.h"
#include "files/video.h"

namespace sturnus {

struct Movie::Writers {
  std::optional<VideoWriter> video;
  std::optional<FrameWriter> frames;
};

Movie::Movie(std::unique_ptr<Writers> writers) : writers_(std::move(writers)) {}
Movie::~Movie() = default;
Movie::Movie(Movie&&) noexcept = default;
Movie& Movie::operator=(Movie&&) noexcept = default;

bool is_movie_name(const std::string& path) {
  return is_numbered_name(path) || is_video_name(path);
}

Status check_output(const std::string& path) {
  if (is_numbered_name(path)) {
    const auto frames = FrameWriter::open(path);
    return frames ? Status() : Status(frames.problems());
  }
  if (is_video_name(path)) return check_video(path);
  return check_file(path);
}

Status check_file(const std::string& path) {
  return is_stream(path) ? Status() : check_writable(path);
}

Status save_picture(const std::string& path, const Image& image) {
  return write_picture(path, image);
}

Result<Movie> Movie::open(const std::string& path, Size size, double frames_per_second) {
  auto writers = std::make_unique<Writers>();
  if (is_numbered_name(path)) {
    auto frames = FrameWriter::open(path);
    if (!frames) return frames.problems();
    writers->frames.emplace(std::move(*frames));
  } else {
    auto video = VideoWriter::open(path, size, frames_per_second);
    if (!video) return video.problems();
    writers->video.emplace(std::move(*video));
  }
  return Movie(std::move(writers));
}

Status Movie::add(const Image& frame) {
  return writers_->video ? writers_->video->add(frame) : writers_->frames->add(frame);
}

Status Movie::finish() {
  return writers_->video ? writers_->video->finish() : Status();
}

}  // namespace sturnus
