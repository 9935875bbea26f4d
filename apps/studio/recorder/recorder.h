// Films of the window: frames go to a thread that writes them, and the window is never kept waiting.
#pragma once

#include <sturnus/files.h>

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace studio {

struct FilmOptions {
  int frames_per_second = 30;
  bool is_gif = false;
  bool with_panels = true;
  /// For films that are not made by hand: waits for the writer rather than leave frames out.
  bool waits = false;
};

/// What became of a film.
struct Film {
  std::string path;
  std::uint64_t frames = 0;   ///< in the film
  std::uint64_t missing = 0;  ///< of those, shown again because the writer was busy
  sturnus::Status status;
};

class Recorder {
 public:
  Recorder() = default;
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Begins a film of this size, rounded down to even numbers, or says why there can't be one.
  sturnus::Status start(const std::string& path, sturnus::Size size, const FilmOptions& options);
  bool is_recording() const { return is_recording_; }
  double seconds() const { return seconds_; }
  const FilmOptions& options() const { return options_; }

  /// Lets time go by; true when a frame is due and `add` shall be called with it.
  bool is_due(double seconds);
  /// Takes a frame; one of another size is cropped or padded.
  void add(sturnus::Image frame);
  /// No more frames. The writer goes on until all are written.
  void stop();
  /// The film that was finished since the last call.
  std::optional<Film> take_finished();
  /// Waits for the film's end.
  Film finish();

 private:
  struct Waiting {
    sturnus::Image frame;
    std::uint64_t times = 1;  ///< how often it stands in the film
  };
  void write(sturnus::Movie movie);
  void write_all(sturnus::Movie& movie);

  FilmOptions options_;
  sturnus::Size size_;
  bool is_recording_ = false;
  double seconds_ = 0;
  std::uint64_t taken_ = 0;  ///< frames of the film that were asked for
  std::uint64_t due_ = 0;    ///< how often the next frame stands in the film
  std::thread writer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Waiting> queue_;
  bool is_ended_ = false, is_written_ = false;
  Film film_;
};

/// The upper left part of a picture, with black where it has nothing.
sturnus::Image fitted(const sturnus::Image& picture, sturnus::Size size);

}  // namespace studio
