// The command line for ffmpeg, and the care for a file that is not finished.
#include "files/video.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "files/atomic_file.h"
#include "files/process.h"

namespace sturnus {
namespace {

enum class Format { mp4, gif, other };

Format format_of(const std::string& path) {
  const std::string name = path.substr(folder_of(path).size());
  if (name.size() <= 4) return Format::other;
  std::string ending = name.substr(name.size() - 4);
  for (char& letter : ending) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return ending == ".mp4" ? Format::mp4 : ending == ".gif" ? Format::gif : Format::other;
}

Problem problem_with(const std::string& path, std::string text) {
  Problem problem;
  problem.file = path;
  problem.text = std::move(text);
  return problem;
}

std::vector<std::string> command(Format format, const std::string& output, Size size,
                                 double frames_per_second) {
  char rate[32];
  std::snprintf(rate, sizeof rate, "%.6g", frames_per_second);
  std::vector<std::string> words{"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y",
                                 // what comes in
                                 "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size",
                                 std::to_string(size.width) + "x" + std::to_string(size.height), "-framerate",
                                 rate, "-i", "pipe:0", "-an", "-map_metadata", "-1", "-fflags", "+bitexact"};
  const auto add = [&](std::initializer_list<const char*> more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  if (format == Format::mp4) {
    // 4:2:0 needs even sides. The matrix is named, or players guess it from the height and shift the colours.
    add({"-vf",
         "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
         "-c:v",
         "libx264",
         "-preset",
         "veryfast",
         "-crf",
         "18",
         "-flags:v",
         "+bitexact",
         "-colorspace",
         "bt709",
         "-color_primaries",
         "bt709",
         "-color_trc",
         "bt709",
         "-movflags",
         "+faststart",
         "-f",
         "mp4"});
  } else {
    // A palette for each frame: one for the whole clip would keep every frame in memory.
    add({"-vf", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none", "-loop",
         "0", "-f", "gif"});
  }
  // The prefix keeps ffmpeg from taking a name with a colon for a protocol, or one with a dash for an option.
  words.push_back("file:" + output);
  return words;
}

}  // namespace

bool ffmpeg_available() {
  const char* path = std::getenv("PATH");
  std::string_view folders = path != nullptr ? path : "";
  while (!folders.empty()) {
    const std::size_t end = folders.find(':');
    const std::string program = std::string(folders.substr(0, end)) + "/ffmpeg";
    struct stat info {};
    if (::stat(program.c_str(), &info) == 0 && S_ISREG(info.st_mode) &&
        ::access(program.c_str(), X_OK) == 0) {
      return true;
    }
    folders.remove_prefix(end == std::string_view::npos ? folders.size() : end + 1);
  }
  return false;
}

bool is_video_name(const std::string& path) {
  return format_of(path) != Format::other;
}

Status check_video(const std::string& path) {
  if (!is_video_name(path)) return problem_with(path, "a video's name has to end in .mp4 or .gif");
  if (is_stream(path)) return problem_with(path, "a video cannot be written to a device or a pipe");
  const Status possible = check_writable(path);
  if (!possible) return possible;
  if (ffmpeg_available()) return {};
  return problem_with(path,
                      "videos are made by the program ffmpeg, which is not on the PATH; without it, "
                      "-o frames/%05d.png writes the frames as pictures");
}

struct VideoWriter::Job {
  std::string path;        // the name it will have
  std::string unfinished;  // the name it has now; empty once published or removed
  Size size;
  std::size_t frames = 0;
  Process ffmpeg;
  bool has_ended = false;
  int ended_with = 0;

  ~Job() { remove(); }

  void remove() {
    ffmpeg.kill();
    if (!unfinished.empty()) ::unlink(unfinished.c_str());
    unfinished.clear();
  }

  // Waits for ffmpeg, the first time it is asked.
  int exit_status() {
    if (!has_ended) ended_with = ffmpeg.wait();
    has_ended = true;
    return ended_with;
  }

  // To be called once ffmpeg has stopped or has to: says why, and leaves nothing.
  Problem failed() {
    const int status = exit_status();
    std::string complaint = ffmpeg.last_complaint();
    // The person asked for a file with another name.
    const std::string hidden = "file:" + unfinished;
    const std::size_t at = complaint.find(hidden);
    if (at != std::string::npos) complaint.replace(at, hidden.size(), path);
    remove();
    return problem_with(
        path, "ffmpeg failed" +
                  (complaint.empty() ? " with exit status " + std::to_string(status) : ": " + complaint));
  }
};

VideoWriter::VideoWriter(std::unique_ptr<Job> job) : job_(std::move(job)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::open(const std::string& path, Size size, double frames_per_second) {
  const Status possible = check_video(path);
  if (!possible) return possible.problems();
  if (size.width < 2 || size.height < 2)
    return problem_with(path, "a video's frames have at least 2 x 2 pixels");
  if (!(frames_per_second >= 1 && frames_per_second <= 1000)) {
    return problem_with(path, "a video shows 1 to 1000 frames per second");
  }
  auto job = std::make_unique<Job>();
  job->path = path;
  job->unfinished = unfinished_name(path);
  job->size = size;
  const int error = job->ffmpeg.start(command(format_of(path), job->unfinished, size, frames_per_second));
  if (error != 0) return problem_with(path, std::string("ffmpeg cannot be started: ") + std::strerror(error));
  return VideoWriter(std::move(job));
}

Status VideoWriter::add(const Image& frame) {
  if (!job_ || job_->unfinished.empty()) return problem_with({}, "the video takes no more frames");
  if (frame.size() != job_->size) return problem_with(job_->path, "a frame has another size than the video");
  if (job_->ffmpeg.write(frame.rgb) != 0) return job_->failed();
  ++job_->frames;
  return {};
}

Status VideoWriter::finish() {
  if (!job_ || job_->unfinished.empty()) return problem_with({}, "the video is already closed");
  if (job_->frames == 0) {
    job_->remove();
    return problem_with(job_->path, "a video needs at least one frame");
  }
  if (job_->exit_status() != 0) return job_->failed();
  return publish(std::exchange(job_->unfinished, {}), job_->path);
}

}  // namespace sturnus
