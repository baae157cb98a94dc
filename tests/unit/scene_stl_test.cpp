#include <limits>

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/walls/stl.h"
#include "scene/walls/triangle_mesh.h"
#include "support/meshes.h"

namespace repose::test {
namespace {

const Triangles two = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}}};

/// What is said of a file that must be refused.
std::string refusal(const std::string& text) {
  try {
    parse_stl(text, "part.stl");
  } catch (const DeckError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "accepted";
}

bool says(const std::string& message, const char* what) { return message.find(what) != std::string::npos; }

TEST(Stl, ReadsAsciiAndBinary) {
  EXPECT_EQ(parse_stl(ascii_stl(two), "part.stl"), two);
  EXPECT_EQ(parse_stl(binary_stl(two), "part.stl"), two);
}

TEST(Stl, TheSizeTellsBinaryFromAscii) {
  EXPECT_EQ(parse_stl(binary_stl(two, "solid made by some program\nfacet normal"), "part.stl"), two);
  std::string named_alike = ascii_stl(two);
  named_alike.replace(0, 5, "SOLID");
  EXPECT_EQ(parse_stl(named_alike, "part.stl"), two);
}

TEST(Stl, ReadsSeveralSolidsAndWhateverLinesAndNormals) {
  std::string text = ascii_stl({two[0]}) + ascii_stl({two[1]});
  EXPECT_EQ(parse_stl(text, "part.stl"), two);
  for (std::size_t at = 0; (at = text.find("normal 0 0 0", at)) != std::string::npos;)
    text.replace(at + 7, 5, "nan -nan inf");
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
  text.replace(text.find("vertex 1"), 8, "vertex\t+1.0e0");
  EXPECT_EQ(parse_stl(text, "part.stl"), two);
}

TEST(Stl, RefusesWhatIsNoStl) {
  EXPECT_TRUE(says(refusal(""), "0 bytes are no STL file"));
  EXPECT_TRUE(says(refusal("solid"), "part.stl:1: the file ends where \"facet\" or \"endsolid\""));
  EXPECT_TRUE(says(refusal("solid a\nendsolid a\n"), "without a triangle"));
  EXPECT_TRUE(says(refusal(binary_stl({})), "without a triangle"));
  EXPECT_TRUE(says(refusal(std::string(500, 'x')), "not an STL file"));
  EXPECT_TRUE(says(refusal(ascii_stl(two) + "rubbish"), "part.stl:17: \"rubbish\" where \"solid\" is expected"));
}

TEST(Stl, RefusesTruncatedFiles) {
  const std::string binary = binary_stl(two);
  EXPECT_TRUE(says(refusal(binary.substr(0, binary.size() - 1)), "has 184 bytes, not 183"));
  const std::string ascii = ascii_stl(two);
  for (std::size_t length = 6; length < ascii.find("endsolid") + 8; length += 7) {
    EXPECT_TRUE(says(refusal(ascii.substr(0, length)), "part.stl:")) << length;
  }
}

TEST(Stl, RefusesCoordinatesThatCannotBe) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -2e9F}) {
    std::string binary = binary_stl(two);
    std::memcpy(&binary[84 + 50 + 12], &bad, sizeof(bad));
    EXPECT_TRUE(says(refusal(binary), "triangle 2: corner"));
  }
  for (const char* bad : {"nan", "inf", "1e10", "1e999", "1,5", "0x10", "1.5.2", "--1"}) {
    std::string ascii = ascii_stl(two);
    ascii.replace(ascii.find("vertex 1") + 7, 1, bad);
    EXPECT_TRUE(says(refusal(ascii), "part.stl:5: \"")) << bad;
  }
}

TEST(TriangleMesh, JoinsWhatIsEqualWithinRounding) {
  Triangles square = {{{{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}}, {{{100, 1e-5, 0}, {100, 100, 0}, {-1e-5, 100, 0}}}};
  const TriangleMesh mesh = make_triangle_mesh(square);
  EXPECT_EQ(mesh.vertices.size(), 4U);
  EXPECT_EQ(mesh.edges, 5U);
  EXPECT_EQ(mesh.defects.open_edges, 4U);
  square[1][0].y = 1e-3;
  EXPECT_EQ(make_triangle_mesh(square).vertices.size(), 5U);
}

TEST(TriangleMesh, CountsDefectsAndDropsWhatCannotServe) {
  const MeshDefects closed = make_triangle_mesh(box({}, {1, 2, 3})).defects;
  EXPECT_FALSE(closed.any());
  Triangles faulty = box({}, {1, 2, 3});
  faulty.push_back({faulty[3][1], faulty[3][0], faulty[3][2]});     // a duplicate that runs the other way
  faulty.push_back({{{0, 0, 0}, {0.5, 1, 1.5}, {1, 2, 3}}});        // on a line
  faulty.push_back({{{0, 0, 0}, {0, 0, 1e-9}, {1, 2, 3}}});         // two corners are one
  faulty.push_back({faulty[0][0], faulty[0][1], {5.0, 5.0, 5.0}});  // a fin
  const TriangleMesh mesh = make_triangle_mesh(faulty);
  EXPECT_EQ(mesh.defects.duplicates, 1U);
  EXPECT_EQ(mesh.defects.zero_area, 2U);
  EXPECT_EQ(mesh.defects.open_edges, 2U);
  EXPECT_EQ(mesh.defects.crowded_edges, 1U);
  EXPECT_EQ(mesh.triangles.size(), 13U);
  EXPECT_THROW(make_triangle_mesh({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}}), std::invalid_argument);
}

}  // namespace
}  // namespace repose::test
