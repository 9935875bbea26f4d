// Reading of frame patterns; they are taken apart here and never reach printf.
#include "files/frame_files.h"

#include <sturnus/files.h>

#include <cstddef>
#include <utility>

#include "files/atomic_file.h"
#include "files/picture_files.h"

namespace sturnus {
namespace {

struct Pattern {
  std::string before, after;
  int digits = 0;
  int places = 0;       // how many numbers it has; one is right
  bool is_good = true;  // false after a percent sign that means nothing here
};

// Reads what follows a percent sign; returns how many characters that is.
std::size_t read_percent(const std::string& text, std::size_t at, Pattern& pattern) {
  std::string& out = pattern.places == 0 ? pattern.before : pattern.after;
  const auto is = [&](std::size_t i, char letter) { return i < text.size() && text[i] == letter; };
  if (is(at, '%')) {
    out += '%';
    return 1;
  }
  if (is(at, 'd')) {
    ++pattern.places;
    return 1;
  }
  if (is(at, '0') && at + 2 < text.size() && text[at + 1] >= '1' && text[at + 1] <= '9' && is(at + 2, 'd')) {
    pattern.digits = text[at + 1] - '0';
    ++pattern.places;
    return 3;
  }
  pattern.is_good = false;
  return 0;
}

Pattern read_pattern(const std::string& text) {
  Pattern pattern;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at++];
    if (letter == '%') {
      at += read_percent(text, at, pattern);
    } else {
      (pattern.places == 0 ? pattern.before : pattern.after) += letter;
    }
  }
  return pattern;
}

Problem pattern_problem(const std::string& path, const char* text) {
  Problem problem;
  problem.file = path;
  problem.text = text;
  return problem;
}

}  // namespace

bool is_numbered_name(const std::string& path) {
  return read_pattern(path).places > 0;
}

Result<NumberedName> NumberedName::read(const std::string& pattern) {
  Pattern found = read_pattern(pattern);
  if (!found.is_good || found.places != 1) {
    return pattern_problem(pattern, "the name of a frame has one place for its number, such as %05d");
  }
  if (found.after.find('/') != std::string::npos) {
    return pattern_problem(pattern, "the number of a frame belongs into the file's name, not the folder's");
  }
  NumberedName name;
  name.before_ = std::move(found.before);
  name.after_ = std::move(found.after);
  name.digits_ = found.digits;
  return name;
}

std::string NumberedName::operator()(std::int64_t number) const {
  std::string digits = std::to_string(number);
  const auto wanted = static_cast<std::size_t>(digits_);
  if (digits.size() < wanted) digits.insert(0, wanted - digits.size(), '0');
  return before_ + digits + after_;
}

Result<std::string> numbered_name(const std::string& pattern, std::int64_t number) {
  const auto name = NumberedName::read(pattern);
  if (!name) return name.problems();
  return (*name)(number);
}

Result<FrameWriter> FrameWriter::open(const std::string& pattern, std::int64_t first) {
  auto name = NumberedName::read(pattern);
  if (!name) return name.problems();
  if (const Status known = check_picture_name(pattern); !known) return known.problems();
  if (const Status folder = make_folders(folder_of((*name)(first))); !folder) return folder.problems();
  if (const Status possible = check_writable((*name)(first)); !possible) return possible.problems();
  return FrameWriter(std::move(*name), first);
}

Status FrameWriter::add(const Image& frame) {
  return write_picture(name(next_++), frame);
}

}  // namespace sturnus
