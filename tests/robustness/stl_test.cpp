// Damaged STL files are read or refused in one line.
#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/walls/wall.h"
#include "support/meshes.h"

namespace repose::test {
namespace {

void flip_bytes(std::string& text, Draw& draw) {
  for (std::size_t k = 1 + draw.below(4); k > 0; --k)
    text[draw.below(text.size())] ^= static_cast<char>(1 + draw.below(255));
}

void insert_bytes(std::string& text, Draw& draw) {
  std::string bytes(1 + draw.below(60), '\0');
  for (char& byte : bytes) byte = static_cast<char>(draw.below(256));
  text.insert(draw.below(text.size()), bytes);
}

void repeat_part(std::string& text, Draw& draw) {
  const std::size_t from = draw.below(text.size());
  const std::string part = text.substr(from, draw.below(400));
  text.insert(draw.below(text.size()), part);
}

void drop_part(std::string& text, Draw& draw) {
  const std::size_t from = draw.below(text.size());
  text.erase(from, 1 + draw.below(200));
}

/// A number after a word "vertex" gives way to an extreme one; in a binary file a float or the count.
void set_extreme_number(bool ascii, std::string& text, Draw& draw) {
  if (ascii) {
    const char* const extremes[] = {"nan", "-inf",   "1e308",  "1e-308", "9.99e8", "-1e9", "1e-30", "0",
                                    "-0",  "1e9999", "5e-324", "+",      "-",      "1e",   "."};
    const std::size_t vertex = text.find("vertex", draw.below(text.size()));
    if (vertex == std::string::npos) return;
    text.replace(vertex + 7, text.find(' ', vertex + 7) - vertex - 7, extremes[draw.below(std::size(extremes))]);
    return;
  }
  using Limits = std::numeric_limits<float>;
  const float extremes[] = {Limits::quiet_NaN(),
                            Limits::infinity(),
                            Limits::max(),
                            Limits::denorm_min(),
                            Limits::min(),
                            1e9F,
                            -9.9e8F,
                            -0.0F};
  const std::size_t place =
      draw.below(20) == 0 ? 80 : 84 + 50 * draw.below((text.size() - 84) / 50) + 4 * draw.below(12);
  std::memcpy(&text[place], &extremes[draw.below(std::size(extremes))], sizeof(float));
}

std::string damaged(std::string text, bool ascii, Draw& draw) {
  switch (draw.below(6)) {
    case 0:
      flip_bytes(text, draw);
      break;
    case 1:
      insert_bytes(text, draw);
      break;
    case 2:
      repeat_part(text, draw);
      break;
    case 3:
      drop_part(text, draw);
      break;
    case 4:
      text.resize(draw.below(text.size()));
      break;
    default:
      for (std::size_t k = 1 + draw.below(3); k > 0; --k) set_extreme_number(ascii, text, draw);
  }
  return text;
}

/// Whether the file was read; a wall that was made must also serve.
bool is_read(const std::string& text, Draw& draw) {
  try {
    const Wall wall = make_wall(mesh_deck(), 0, [&](const std::string&) { return text; });
    for (int k = 0; k < 5; ++k) {
      const Vec3 centre = draw.vector(2.0);
      const double d = distance(wall, centre);
      TouchBuffer touches;
      find_touches(wall, 0, centre, 1.1 * d + 1e-3, touches);
      EXPECT_GE(touches.size(), 1);
      EXPECT_TRUE(is_within(wall, centre, 1.1 * d + 1e-3));
      for (const WallTouch& t : touches.touches()) EXPECT_NEAR(norm(t.normal), 1.0, 1e-12);
    }
    return true;
  } catch (const DeckError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    EXPECT_LT(std::string(error.what()).size(), 300U);
    return false;
  }
}

TEST(DamagedStl, IsReadOrRefusedInOneLine) {
  const Triangles body = box({-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0});
  const std::string ascii = ascii_stl(body);
  const std::string binary = binary_stl(body, "solid binary");
  Draw draw(2024);
  int read = 0;
  for (int i = 0; i < 10000; ++i) {
    SCOPED_TRACE(i);
    const bool is_ascii = i % 2 == 0;
    read += is_read(damaged(is_ascii ? ascii : binary, is_ascii, draw), draw) ? 1 : 0;
  }
  EXPECT_GT(read, 1000);  // the damage is often harmless
  EXPECT_LT(read, 9000);
}

// The count of a binary file must not make the reader reserve memory that the file does not justify.
TEST(DamagedStl, AGreatCountIsNoMemory) {
  std::string text = binary_stl(box({}, {1.0, 1.0, 1.0}));
  for (const std::uint32_t count : {0xFFFFFFFFU, 0x7FFFFFFFU, 100'000'001U}) {
    std::memcpy(&text[80], &count, sizeof(count));
    Draw draw(1);
    EXPECT_FALSE(is_read(text, draw));
  }
}

}  // namespace
}  // namespace repose::test
