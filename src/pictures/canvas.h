#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <cairo.h>

namespace repose {

struct Colour {
  double red = 0.0;  ///< 0 to 255, as are the others
  double green = 0.0;
  double blue = 0.0;
};

struct Pixel {
  double x = 0.0;  ///< to the right
  double y = 0.0;  ///< downwards
};

/// Where a text stands about its place.
enum class Align { left, centre, right };

/// Pixels that the formats of a picture share; empty until they are drawn.
using SharedImage = std::shared_ptr<cairo_surface_t>;

/// What can be drawn on a picture, in any of its formats. What lies outside is not drawn.
class Canvas {
 public:
  Canvas(cairo_t* context, double width, double height, SharedImage& discs)
      : context_(context), width_(width), height_(height), discs_(discs) {}

  void disc(Pixel centre, double radius, Colour colour);
  /// The line of a circle.
  void circle(Pixel centre, double radius, double thickness, Colour colour);
  void rectangle(Pixel low, Pixel high, Colour colour);
  void line(Pixel from, Pixel to, double thickness, Colour colour);
  /// Lines from point to point.
  void polyline(const std::vector<Pixel>& points, double thickness, Colour colour);
  void dashed_line(Pixel from, Pixel to, double thickness, double dash, Colour colour);
  /// A grey picture between two corners; `grey` has 0 (black) to 255 for each of its pixels, row by row from the top.
  /// FileError when there is no memory for it.
  void photograph(Pixel low, Pixel high, const std::vector<unsigned char>& grey, std::size_t columns);
  /// Text in UTF-8 in a font of this size, with its base line at y. Where there is no font Cairo has letters of its
  /// own, and degrees and plus-minus are written in them.
  void text(Pixel at, const std::string& text, double size, Colour colour, Align align = Align::left);

  /// Draws so many discs, once in a picture. From some thousands on they are pixels in PDF and SVG too, twice as fine
  /// as the PNG: as circles they would make files that no viewer likes. FileError when there is no memory for them.
  void many_discs(std::size_t count, const std::function<void(Canvas&)>& draw);

  double width() const { return width_; }
  double height() const { return height_; }

 private:
  void set(Colour colour);
  void choose_font(double size);

  cairo_t* context_;
  double width_;
  double height_;
  SharedImage& discs_;
};

/// The same picture in three formats: the bytes of the files.
struct Picture {
  std::string png;
  std::string pdf;
  std::string svg;
};

/// A white picture of this size in pixels, which are points (1/72 inch) in PDF and SVG. Equal drawings give equal bytes
/// of PNG and PDF; Cairo numbers the parts of SVG on through a process. FileError when it cannot be encoded.
Picture make_picture(double width, double height, const std::function<void(Canvas&)>& draw);

/// The files of a picture with this name.
std::vector<std::string> picture_files(const std::string& name);

/// Writes `path`.png, .pdf and .svg, each whole or not at all. FileError.
void write_picture(const std::string& path, const Picture& picture);

}  // namespace repose
