#include "pictures/canvas.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <numbers>
#include <utility>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "base/error.h"
#include "files/atomic_file.h"

namespace repose {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

constexpr double fineness = 2.0;          // pixels of the discs' image in one of the picture
constexpr std::size_t most_discs = 6000;  // as circles: 0.2 MB of PDF, 1.6 MB of SVG

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw FileError(std::string("a picture cannot be encoded: ") + cairo_status_to_string(status));
}

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// One drawing for all formats.
struct Drawing {
  double width;
  double height;
  const std::function<void(Canvas&)>& draw;
  SharedImage discs;

  void on(cairo_surface_t* surface) {
    check(cairo_surface_status(surface));
    const Context context(cairo_create(surface), cairo_destroy);
    Canvas canvas(context.get(), width, height, discs);
    canvas.rectangle({0.0, 0.0}, {width, height}, {255, 255, 255});
    draw(canvas);
    check(cairo_status(context.get()));
  }
};

/// The bytes of a format that is written to a stream.
template <class Create>
std::string vector_bytes(Drawing& drawing, const Create& create) {
  std::string bytes;
  const Surface surface(create(append, &bytes, drawing.width, drawing.height), cairo_surface_destroy);
  drawing.on(surface.get());
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

cairo_surface_t* undated_pdf(cairo_write_func_t write, void* closure, double width, double height) {
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(write, closure, width, height);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
  return surface;
}

/// What the font can draw of a text. Without any font on the machine Cairo's own knows ASCII alone.
std::string drawable(cairo_t* context, std::string text) {
  if (cairo_scaled_font_get_type(cairo_get_scaled_font(context)) != CAIRO_FONT_TYPE_USER) return text;
  for (const auto& [sign, ascii] : {std::pair("°", " deg"), std::pair("±", "+-")}) {
    for (std::size_t at; (at = text.find(sign)) != std::string::npos;) text.replace(at, std::strlen(sign), ascii);
  }
  return text;
}

}  // namespace

void Canvas::set(Colour colour) {
  cairo_set_source_rgb(context_, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
}

void Canvas::disc(Pixel centre, double radius, Colour colour) {
  set(colour);
  cairo_arc(context_, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(context_);
}

void Canvas::circle(Pixel centre, double radius, double thickness, Colour colour) {
  set(colour);
  cairo_set_line_width(context_, thickness);
  cairo_arc(context_, centre.x, centre.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_stroke(context_);
}

void Canvas::rectangle(Pixel low, Pixel high, Colour colour) {
  set(colour);
  cairo_rectangle(context_, low.x, low.y, high.x - low.x, high.y - low.y);
  cairo_fill(context_);
}

void Canvas::line(Pixel from, Pixel to, double thickness, Colour colour) { polyline({from, to}, thickness, colour); }

void Canvas::polyline(const std::vector<Pixel>& points, double thickness, Colour colour) {
  set(colour);
  cairo_set_line_width(context_, thickness);
  cairo_set_line_join(context_, CAIRO_LINE_JOIN_ROUND);
  for (const Pixel& p : points) cairo_line_to(context_, p.x, p.y);
  cairo_stroke(context_);
}

void Canvas::dashed_line(Pixel from, Pixel to, double thickness, double dash, Colour colour) {
  cairo_set_dash(context_, &dash, 1, 0.0);
  line(from, to, thickness, colour);
  cairo_set_dash(context_, nullptr, 0, 0.0);
}

void Canvas::photograph(Pixel low, Pixel high, const std::vector<unsigned char>& grey, std::size_t columns) {
  const std::size_t rows = grey.size() / columns;
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(columns), static_cast<int>(rows)),
      cairo_surface_destroy);
  check(cairo_surface_status(surface.get()));
  unsigned char* data = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const std::uint32_t value = 0x010101U * grey[i];
    std::memcpy(data + i / columns * stride + i % columns * sizeof(value), &value, sizeof(value));
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_save(context_);
  cairo_translate(context_, low.x, low.y);
  cairo_scale(context_, (high.x - low.x) / static_cast<double>(columns), (high.y - low.y) / static_cast<double>(rows));
  cairo_set_source_surface(context_, surface.get(), 0.0, 0.0);
  cairo_paint(context_);
  cairo_restore(context_);
}

void Canvas::choose_font(double size) {
  cairo_select_font_face(context_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, size);
}

void Canvas::text(Pixel at, const std::string& text, double size, Colour colour, Align align) {
  choose_font(size);
  const std::string drawn = drawable(context_, text);
  cairo_text_extents_t extents;
  cairo_text_extents(context_, drawn.c_str(), &extents);
  const double share = align == Align::left ? 0.0 : align == Align::centre ? 0.5 : 1.0;
  set(colour);
  cairo_move_to(context_, at.x - share * extents.x_advance, at.y);
  cairo_show_text(context_, drawn.c_str());
  cairo_new_path(context_);  // it leaves its end behind
}

void Canvas::many_discs(std::size_t count, const std::function<void(Canvas&)>& draw) {
  if (count <= most_discs) {
    draw(*this);
    return;
  }
  if (!discs_) {
    discs_.reset(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(std::ceil(fineness * width_)),
                                            static_cast<int>(std::ceil(fineness * height_))),
                 cairo_surface_destroy);
    check(cairo_surface_status(discs_.get()));
    const Context context(cairo_create(discs_.get()), cairo_destroy);
    cairo_scale(context.get(), fineness, fineness);
    Canvas pixels(context.get(), width_, height_, discs_);
    draw(pixels);
    check(cairo_status(context.get()));
  }
  cairo_save(context_);
  cairo_scale(context_, 1.0 / fineness, 1.0 / fineness);
  cairo_set_source_surface(context_, discs_.get(), 0.0, 0.0);
  cairo_paint(context_);
  cairo_restore(context_);
}

Picture make_picture(double width, double height, const std::function<void(Canvas&)>& draw) {
  Drawing drawing{.width = width, .height = height, .draw = draw, .discs = {}};
  Picture picture;
  const Surface image(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)),
                      cairo_surface_destroy);
  drawing.on(image.get());
  check(cairo_surface_write_to_png_stream(image.get(), append, &picture.png));
  picture.pdf = vector_bytes(drawing, undated_pdf);
  picture.svg = vector_bytes(drawing, cairo_svg_surface_create_for_stream);
  return picture;
}

std::vector<std::string> picture_files(const std::string& name) {
  return {name + ".png", name + ".pdf", name + ".svg"};
}

void write_picture(const std::string& path, const Picture& picture) {
  write_text_file(path + ".png", picture.png);
  write_text_file(path + ".pdf", picture.pdf);
  write_text_file(path + ".svg", picture.svg);
}

}  // namespace repose
