// Files with a number in the name: what patterns of names are, and one picture file for each frame.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "sturnus/picture.h"
#include "sturnus/result.h"

namespace sturnus {

/// Names with a number: frames/00000.png, frames/00001.png and so on.
class NumberedName {
 public:
  /// A pattern has one place for the number, in the file's name: %d, or %0Nd for N digits, N from 1 to 9;
  /// %% stands for one percent sign.
  static Result<NumberedName> read(const std::string& pattern);

  /// The file name of a number.
  std::string operator()(std::int64_t number) const;

 private:
  NumberedName() = default;
  std::string before_;
  std::string after_;
  int digits_ = 0;  // at least so many, with zeros in front
};

/// Writes frames/00000.png, frames/00001.png and so on.
class FrameWriter {
 public:
  /// A pattern of names that ends in .png or .ppm. Its folder is created. The first frame gets the number
  /// `first`.
  static Result<FrameWriter> open(const std::string& pattern, std::int64_t first = 0);

  /// Writes the next frame.
  Status add(const Image& frame);

  /// The file name of a number.
  std::string name(std::int64_t number) const { return name_(number); }

 private:
  FrameWriter(NumberedName name, std::int64_t first) : name_(std::move(name)), next_(first) {}
  NumberedName name_;
  std::int64_t next_;
};

}  // namespace sturnus
