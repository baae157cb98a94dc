#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <png.h>

#include "base/error.h"
#include "measurement/draw.h"
#include "measurement_piles.h"

namespace repose {
namespace {

namespace fs = std::filesystem;

class Draw : public testing::Test {
 protected:
  Draw() : pile_(test::cone(5e-3, 30.0)), result_(*angle_of_repose(pile_, {})) { fs::create_directories(folder_); }
  ~Draw() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::path(testing::TempDir()) / "repose_draw_test";
  std::vector<Sphere> pile_;
  AngleOfRepose result_;
};

TEST_F(Draw, WritesAWholePictureAndNothingElse) {
  const std::string path = folder_ / "silhouette.png";
  write_silhouette_png(path, result_, pile_, {});
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0);
  EXPECT_EQ(image.width, 1200u);
  image.format = PNG_FORMAT_RGB;
  std::vector<unsigned char> rgb(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
  // White sky at the corner, a grain in the middle of the foot of the pile.
  EXPECT_EQ(rgb[0], 255);
  const std::size_t foot = 3 * ((image.height - 100) * std::size_t{1200} + 600);
  EXPECT_LT(rgb[foot + 2], 240);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
}

TEST_F(Draw, NamesThePathItCannotWrite) {
  const std::string path = folder_ / "absent" / "silhouette.png";
  try {
    write_silhouette_png(path, result_, pile_, {});
    FAIL() << "wrote into a folder that does not exist";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace repose
