#include "photo/photo_file.h"

#include <cmath>
#include <memory>

#include <fcntl.h>
#include <fmt/core.h>
#include <leptonica/allheaders.h>
#include <libexif/exif-data.h>
#include <unistd.h>

#include "base/error.h"

namespace repose::photo {
namespace {

struct DestroyPix {
  void operator()(Pix* pix) const { pixDestroy(&pix); }
};
using PixPointer = std::unique_ptr<Pix, DestroyPix>;

/// While it lives, nothing is written to the standard error output: libjpeg and libpng say there what they think of a
/// file, and the user gets one line of ours. What cannot be redirected stays as it is.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) close(nowhere);
  }
  ~Silence() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int kept_;
};

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw FileError(fmt::format("{}: {}; a whole JPEG, PNG or TIFF file is needed", name, what));
}

const unsigned char* begin_of(const std::string& bytes) { return reinterpret_cast<const unsigned char*>(bytes.data()); }

/// 1 to 8 as in EXIF; 1, which is upright, where the file says nothing.
int orientation_of_jpeg(const std::string& bytes) {
  const std::unique_ptr<ExifData, decltype(&exif_data_unref)> data(
      exif_data_new_from_data(begin_of(bytes), static_cast<unsigned>(bytes.size())), exif_data_unref);
  if (!data) return 1;
  const ExifEntry* entry = exif_data_get_entry(data.get(), EXIF_TAG_ORIENTATION);
  if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < 2) return 1;
  const int value = exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
  return value >= 1 && value <= 8 ? value : 1;
}

/// Turned by quarters and mirrored, so that the first row and column of `orientation` come to the top and left.
PixPointer upright(PixPointer pix, int orientation) {
  constexpr int quarters[9] = {0, 0, 0, 2, 2, 1, 1, 3, 3};  // clockwise
  constexpr bool mirrored[9] = {false, false, true, false, true, true, false, true, false};
  if (quarters[orientation] != 0) pix.reset(pixRotateOrth(pix.get(), quarters[orientation]));
  if (pix && mirrored[orientation]) pixFlipLR(pix.get(), pix.get());
  return pix;
}

PixPointer decode(const std::string& bytes, const std::string& name) {
  const Silence silence;
  int format = IFF_UNKNOWN, width = 0, height = 0, bits = 0, samples = 0, has_map = 0;
  const bool is_known =
      pixReadHeaderMem(begin_of(bytes), bytes.size(), &format, &width, &height, &bits, &samples, &has_map) == 0;
  const bool is_jpeg = format == IFF_JFIF_JPEG;
  if (!is_known || !(is_jpeg || L_FORMAT_IS_TIFF(format) || format == IFF_PNG))
    refuse(name, "is no picture that can be read");
  if (static_cast<double>(width) * height > most_pixels) {
    refuse(name, fmt::format("has {} x {} pixels, more than {:.0f} million", width, height, 1e-6 * most_pixels));
  }
  PixPointer pix(is_jpeg ? pixReadMemJpeg(begin_of(bytes), bytes.size(), 0, 1, nullptr, 0)
                         : pixReadMem(begin_of(bytes), bytes.size()));
  if (pix && is_jpeg) pix = upright(std::move(pix), orientation_of_jpeg(bytes));
  if (!pix) refuse(name, "is damaged or cut off");
  return pix;
}

/// Red, green and blue of 8 bits in one word, or grey of 8 or 16 bits.
PixPointer plain(PixPointer pix, const std::string& name) {
  if (pixGetColormap(pix.get()) != nullptr) pix.reset(pixRemoveColormap(pix.get(), REMOVE_CMAP_BASED_ON_SRC));
  if (pix && pixGetDepth(pix.get()) < 8) pix.reset(pixConvertTo8(pix.get(), 0));
  const int depth = pix ? pixGetDepth(pix.get()) : 0;
  if (depth != 8 && depth != 16 && depth != 32) refuse(name, "has colours that cannot be read");
  return pix;
}

/// The weights of red, green and blue in a grey value; for grey those of the eye (ITU-R BT.601).
std::array<float, 3> weights(Channel channel) {
  switch (channel) {
    case Channel::red:
      return {1.0F, 0.0F, 0.0F};
    case Channel::green:
      return {0.0F, 1.0F, 0.0F};
    case Channel::blue:
      return {0.0F, 0.0F, 1.0F};
    case Channel::grey:
      break;
  }
  return {0.299F, 0.587F, 0.114F};
}

}  // namespace

Image read_photo(const std::string& bytes, const std::string& name, Channel channel) {
  setMsgSeverity(L_SEVERITY_NONE);  // what is wrong with a file is said here
  const PixPointer pix = plain(decode(bytes, name), name);
  Image image(static_cast<std::size_t>(pixGetWidth(pix.get())), static_cast<std::size_t>(pixGetHeight(pix.get())));
  const int depth = pixGetDepth(pix.get());
  const std::array<float, 3> weight = weights(channel);
  const auto words = static_cast<std::size_t>(pixGetWpl(pix.get()));
  for (std::size_t y = 0; y < image.height; ++y) {
    const l_uint32* line = pixGetData(pix.get()) + y * words;
    for (std::size_t x = 0; x < image.width; ++x) {
      const auto column = static_cast<int>(x);
      if (depth == 32) {
        int red = 0, green = 0, blue = 0;
        extractRGBValues(line[x], &red, &green, &blue);
        image.at(x, y) = (weight[0] * static_cast<float>(red) + weight[1] * static_cast<float>(green) +
                          weight[2] * static_cast<float>(blue)) /
                         255.0F;
      } else if (depth == 16) {
        image.at(x, y) = static_cast<float>(l_getDataTwoBytes(line, column)) / 65535.0F;
      } else {
        image.at(x, y) = static_cast<float>(l_getDataByte(line, column)) / 255.0F;
      }
    }
  }
  return image;
}

std::string png_of(const Image& image) {
  const PixPointer pix(pixCreate(static_cast<int>(image.width), static_cast<int>(image.height), 8));
  l_uint8* data = nullptr;
  std::size_t size = 0;
  if (pix) {
    for (std::size_t y = 0; y < image.height; ++y) {
      for (std::size_t x = 0; x < image.width; ++x) {
        const float value = std::min(1.0F, std::max(0.0F, image.at(x, y)));
        pixSetPixel(pix.get(), static_cast<int>(x), static_cast<int>(y),
                    static_cast<l_uint32>(std::lround(255.0F * value)));
      }
    }
  }
  if (!pix || pixWriteMem(&data, &size, pix.get(), IFF_PNG) != 0) {
    throw FileError(fmt::format("a picture of {} x {} pixels cannot be encoded", image.width, image.height));
  }
  const std::unique_ptr<l_uint8, decltype(&lept_free)> owner(data, lept_free);
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace repose::photo
