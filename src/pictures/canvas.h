#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace repose {

struct Colour {
  double red = 0.0;  ///< 0 to 255, as are the others
  double green = 0.0;
  double blue = 0.0;
};

struct Pixel {
  double x = 0.0;  ///< to the right; whole numbers are the centres of pixels
  double y = 0.0;  ///< downwards
};

/// A white picture to draw on, edges smoothed. What lies outside is not drawn.
class Canvas {
 public:
  Canvas(std::size_t width, std::size_t height);

  void disc(Pixel centre, double radius, Colour colour);
  /// The line of a circle.
  void circle(Pixel centre, double radius, double thickness, Colour colour);
  void rectangle(Pixel low, Pixel high, Colour colour);
  void line(Pixel from, Pixel to, double thickness, Colour colour);
  void dashed_line(Pixel from, Pixel to, double thickness, double dash, Colour colour);
  /// Text with its top left corner at `at`, in the letters of bitmap_font.h, `scale` pixels per dot.
  void text(Pixel at, std::string_view text, int scale, Colour colour);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  /// The bytes of a PNG file. FileError when it cannot be encoded.
  std::string png() const;

 private:
  /// Covers, of every pixel near the box, the share that `distance` (px, negative inside the shape) tells.
  template <class Distance>
  void fill(Pixel low, Pixel high, Colour colour, Distance distance);
  void blend(std::size_t x, std::size_t y, double share, Colour colour);

  std::size_t width_;
  std::size_t height_;
  std::vector<std::uint8_t> rgb_;
};

}  // namespace repose
