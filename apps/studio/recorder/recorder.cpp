// A queue of a few frames between the window and the writer.
#include "recorder/recorder.h"

#include <algorithm>
#include <cmath>

namespace studio {
namespace {

constexpr std::size_t most_waiting = 8;  // frames
// A tiny bit earlier than due: sums of sixtieths fall just short of thirtieths.
constexpr double early = 1e-6;

}  // namespace

sturnus::Image fitted(const sturnus::Image& picture, sturnus::Size size) {
  sturnus::Image out(size, sturnus::rgb(0));
  const auto bytes = static_cast<std::ptrdiff_t>(3 * std::min(picture.width, size.width));
  for (int y = 0; y < std::min(picture.height, size.height); ++y) {
    const auto row = picture.rgb.begin() + static_cast<std::ptrdiff_t>(picture.offset(0, y));
    std::copy(row, row + bytes, out.rgb.begin() + static_cast<std::ptrdiff_t>(out.offset(0, y)));
  }
  return out;
}

Recorder::~Recorder() {
  stop();
  if (writer_.joinable()) writer_.join();
}

sturnus::Status Recorder::start(const std::string& path, sturnus::Size size, const FilmOptions& options) {
  if (writer_.joinable())
    return sturnus::Problem{path, 0, "", "the film before this one is still being written", false};
  size_ = {std::max(2, size.width / 2 * 2), std::max(2, size.height / 2 * 2)};
  if (const sturnus::Status status = sturnus::check_output(path); !status) return status;
  auto movie = sturnus::Movie::open(path, size_, options.frames_per_second);
  if (!movie) return movie.problems();
  options_ = options;
  seconds_ = 0;
  taken_ = due_ = 0;
  film_ = {path, 0, 0, {}};
  is_ended_ = is_written_ = false;
  is_recording_ = true;
  writer_ = std::thread([this, film = std::move(*movie)]() mutable { write(std::move(film)); });
  return {};
}

bool Recorder::is_due(double seconds) {
  if (!is_recording_) return false;
  const double wanted = std::floor(seconds_ * options_.frames_per_second + early) + 1;
  seconds_ += seconds;
  due_ = static_cast<std::uint64_t>(wanted) - taken_;
  return due_ > 0;
}

// A frame that comes late stands in the film for those that should have been before it.
void Recorder::add(sturnus::Image frame) {
  if (frame.size() != size_) frame = fitted(frame, size_);
  std::unique_lock lock(mutex_);
  if (options_.waits) changed_.wait(lock, [this] { return queue_.size() < most_waiting || is_written_; });
  if (is_written_ || queue_.size() >= most_waiting) return;
  film_.missing += due_ - 1;
  taken_ += due_;
  queue_.push_back({std::move(frame), due_});
  changed_.notify_all();
}

void Recorder::stop() {
  if (!is_recording_) return;
  is_recording_ = false;
  const std::lock_guard lock(mutex_);
  is_ended_ = true;
  changed_.notify_all();
}

std::optional<Film> Recorder::take_finished() {
  {
    const std::lock_guard lock(mutex_);
    if (!is_written_) return {};
  }
  return finish();
}

Film Recorder::finish() {
  stop();
  if (writer_.joinable()) writer_.join();
  is_written_ = false;
  return film_;
}

void Recorder::write(sturnus::Movie movie) {
  write_all(movie);
  sturnus::Status status = film_.status;
  if (status) status = movie.finish();
  const std::lock_guard lock(mutex_);
  film_.status = std::move(status);
  is_written_ = true;
  queue_.clear();
  changed_.notify_all();
}

// Until the end, or until a frame can't be written.
void Recorder::write_all(sturnus::Movie& movie) {
  std::unique_lock lock(mutex_);
  while (film_.status) {
    changed_.wait(lock, [this] { return !queue_.empty() || is_ended_; });
    if (queue_.empty()) return;
    const Waiting next = std::move(queue_.front());
    queue_.pop_front();
    changed_.notify_all();
    lock.unlock();
    sturnus::Status status;
    for (std::uint64_t i = 0; i < next.times && status; ++i) status = movie.add(next.frame);
    lock.lock();
    film_.frames += status ? next.times : 0;
    film_.status = std::move(status);
  }
}

}  // namespace studio
