// What the tests of prog06 share: its words, its surroundings and its pictures.
#pragma once

#include <sturnus/picture.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "screen.h"

namespace program_test {

inline Words prog06_words(const Words& arguments) {
  Words words = {PROG06_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

/// A picture from the bytes of a PPM file; empty when they are not one.
inline sturnus::Image ppm_picture(const std::string& bytes) {
  sturnus::Image image;
  int skipped = 0;
  if (std::sscanf(bytes.c_str(), "P6\n%d %d\n255%n", &image.width, &image.height, &skipped) != 2) return {};
  const std::size_t size = 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  const std::size_t begin = static_cast<std::size_t>(skipped) + 1;
  if (bytes.size() != begin + size) return {};
  image.rgb.assign(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
  return image;
}

}  // namespace program_test
