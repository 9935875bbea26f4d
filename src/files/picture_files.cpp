// PNG through libpng, PPM by hand.
#include "files/picture_files.h"

#include <png.h>

#include <cctype>
#include <csetjmp>
#include <cstddef>
#include <span>
#include <string_view>

#include "files/atomic_file.h"

namespace sturnus {
namespace {

constexpr int compression_level = 2;  // zlib; twice as fast as its default, files a tenth larger

// What libpng's callbacks need. It lives outside the function that calls setjmp, so that a jump cannot leave
// it half changed, and owns everything, so that a jump over destructors leaks nothing.
struct PngJob {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::vector<unsigned char> bytes;
  std::string error;

  PngJob() = default;
  PngJob(const PngJob&) = delete;
  PngJob& operator=(const PngJob&) = delete;
  ~PngJob() { png_destroy_write_struct(&png, &info); }
};

void take_bytes(png_structp png, png_bytep data, png_size_t length) {
  auto* job = static_cast<PngJob*>(png_get_io_ptr(png));
  job->bytes.insert(job->bytes.end(), data, data + length);
}

void take_nothing(png_structp) {}

[[noreturn]] void take_error(png_structp png, png_const_charp message) {
  static_cast<PngJob*>(png_get_error_ptr(png))->error = message;
  std::longjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)), 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// The only function that libpng may jump back into: it has no local object to destroy.
bool encode(PngJob& job, const Image& image) {
  job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, take_error, ignore_warning);
  if (job.png == nullptr) return false;
  job.info = png_create_info_struct(job.png);
  if (job.info == nullptr) return false;
  if (setjmp(png_jmpbuf(job.png)) != 0) return false;
  png_set_write_fn(job.png, &job, take_bytes, take_nothing);
  png_set_compression_level(job.png, compression_level);
  png_set_filter(job.png, 0, PNG_FILTER_NONE);
  png_set_IHDR(job.png, job.info, static_cast<png_uint_32>(image.width),
               static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(job.png, job.info);
  for (int y = 0; y < image.height; ++y) png_write_row(job.png, image.rgb.data() + image.offset(0, y));
  png_write_end(job.png, nullptr);
  return true;
}

bool ends_with(std::string_view name, std::string_view ending) {
  if (name.size() <= ending.size()) return false;
  name.remove_prefix(name.size() - ending.size());
  for (std::size_t i = 0; i < ending.size(); ++i) {
    if (std::tolower(static_cast<unsigned char>(name[i])) != ending[i]) return false;
  }
  return true;
}

}  // namespace

Result<std::vector<unsigned char>> encode_png(const Image& image) {
  PngJob job;
  job.bytes.reserve(image.rgb.size() / 4 + 1024);
  if (encode(job, image)) return std::move(job.bytes);
  Problem problem;
  problem.text =
      "the PNG could not be encoded: " + (job.error.empty() ? "libpng could not start" : job.error);
  return problem;
}

std::vector<unsigned char> encode_ppm(const Image& image) {
  const std::string header =
      "P6\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
  std::vector<unsigned char> bytes(header.begin(), header.end());
  bytes.insert(bytes.end(), image.rgb.begin(), image.rgb.end());
  return bytes;
}

Status check_picture_name(const std::string& path) {
  if (ends_with(path, ".png") || ends_with(path, ".ppm")) return {};
  Problem problem;
  problem.file = path;
  problem.text = "a picture's name has to end in .png or .ppm";
  return problem;
}

Status write_picture(const std::string& path, const Image& image) {
  const Status known = check_picture_name(path);
  if (!known) return known;
  if (ends_with(path, ".ppm")) return write_file(path, encode_ppm(image));
  Result<std::vector<unsigned char>> bytes = encode_png(image);
  if (bytes) return write_file(path, std::span<const unsigned char>(*bytes));
  Problems problems = bytes.problems();
  for (Problem& problem : problems) problem.file = path;
  return problems;
}

}  // namespace sturnus
