// Laws of picture files: what is read back is what was drawn.
#include "files/picture_files.h"

#include <gtest/gtest.h>
#include <png.h>

#include "temporary_folder.h"

namespace sturnus {
namespace {

Image colourful(Size size) {
  Image image(size, {});
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<std::uint8_t>(i * 37 + i / 91);
  return image;
}

// Read by libpng's simple interface, which shares nothing with the writer.
Image read_png(const std::string& path) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, path.c_str()) == 0) return {};
  header.format = PNG_FORMAT_RGB;
  Image image({static_cast<int>(header.width), static_cast<int>(header.height)}, {});
  if (png_image_finish_read(&header, nullptr, image.rgb.data(), 0, nullptr) == 0) return {};
  return image;
}

TEST(PictureFiles, APngReadBackIsTheImage) {
  const TemporaryFolder folder;
  for (const Size size : {Size{1, 1}, Size{33, 17}, Size{640, 3}}) {
    const Image image = colourful(size);
    ASSERT_TRUE(write_picture(folder / "a.PNG", image));
    EXPECT_EQ(read_png(folder / "a.PNG"), image);
  }
}

TEST(PictureFiles, APpmIsItsHeaderAndItsBytes) {
  const TemporaryFolder folder;
  const Image image = colourful({5, 3});
  ASSERT_TRUE(write_picture(folder / "a.ppm", image));
  EXPECT_EQ(read_all(folder / "a.ppm"), "P6\n5 3\n255\n" + std::string(image.rgb.begin(), image.rgb.end()));
}

TEST(PictureFiles, OtherEndingsAreRefusedWithWhatIsPossible) {
  const TemporaryFolder folder;
  for (const char* name : {"a.jpg", "a", ".png", "png", "a.png.gz"}) {
    const std::string error = write_picture(folder / name, colourful({2, 2})).error();
    if (std::string(name) == ".png") continue;  // a name with nothing before its ending still has it
    EXPECT_NE(error.find(".png or .ppm"), std::string::npos) << name;
  }
}

TEST(PictureFiles, AnImageWithoutPixelsIsAProblemAndNoFile) {
  const TemporaryFolder folder;
  const Status status = write_picture(folder / "a.png", Image());
  EXPECT_FALSE(status);
  EXPECT_NE(status.error().find("a.png"), std::string::npos);
  EXPECT_TRUE(folder.names().empty());
}

TEST(PictureFiles, FailureLeavesNoFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(write_picture(folder / "none/a.png", colourful({2, 2})).error(),
            (folder / "none/a.png") + ": cannot be written: No such file or directory\n");
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace sturnus
