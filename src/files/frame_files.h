// One picture file for each frame, with the number in the name.
#pragma once

#include <cstdint>
#include <string>

#include "sturnus/picture.h"
#include "sturnus/result.h"

namespace sturnus {

/// Whether a name has a place for a number (%d, %05d), so that it means many files.
bool is_frame_pattern(const std::string& path);

/// Writes frames/00000.png, frames/00001.png and so on.
class FrameWriter {
 public:
  /// A pattern has one place for the number: %d, or %0Nd for N digits, N from 1 to 9; %% stands for one
  /// percent sign; it ends in .png or .ppm. Its folder is created. The first frame gets the number `first`.
  static Result<FrameWriter> open(const std::string& pattern, std::int64_t first = 0);

  /// Writes the next frame.
  Status add(const Image& frame);

  /// The file name of a number.
  std::string name(std::int64_t number) const;

 private:
  FrameWriter() = default;
  std::string before_;
  std::string after_;
  int digits_ = 0;  // at least so many, with zeros in front
  std::int64_t next_ = 0;
};

}  // namespace sturnus
