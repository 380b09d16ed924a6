// Mesh files: what is read from them, and that none is believed more than it has bytes.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "draw/cut_polygon.hpp"
#include "io/mesh_file.hpp"

namespace graze::io {
namespace {

std::string mesh_refusal(const std::string& bytes, const std::string& format) {
  try {
    read_mesh_file(bytes, format);
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "read";
}

const std::string ply_points =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n";

std::string ply(const std::string& format, const std::string& elements, const std::string& body) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\n" + elements + "end_header\n" + body;
}

/// A number's bytes in either order.
template <class V>
std::string raw(V value, bool big = false) {
  std::string bytes(sizeof(V), '\0');
  std::memcpy(bytes.data(), &value, sizeof(V));
  return big == (std::endian::native == std::endian::big) ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

TEST(PlyFile, TextAndBothBinaryOrdersAreTheSameMesh) {
  const std::string elements = ply_points + "element face 1\nproperty list uchar int vertex_indices\n";
  const TriangleSoup text =
      read_mesh_file(ply("ascii", elements, "0 0 0 9\r\n 1 0 0 9\r\n1 1 0 9\r\n\r\n0 1 0.25 9\r\n4 0 1 2 3"), "ply");
  ASSERT_EQ(text.points.size(), 4u);
  EXPECT_EQ(text.points[3], (Vec3d{0, 1, 0.25}));
  EXPECT_EQ(text.triangles.size(), 2u);
  for (const bool big : {false, true}) {
    std::string body;
    for (const Vec3d& p : text.points) {
      for (std::size_t k = 0; k < 3; ++k) body += raw(static_cast<float>(p[k]), big);
      body += '\x09';
    }
    body += '\x04';
    for (std::int32_t i = 0; i < 4; ++i) body += raw(i, big);
    const TriangleSoup soup =
        read_mesh_file(ply(big ? "binary_big_endian" : "binary_little_endian", elements, body), "ply");
    EXPECT_EQ(soup.points, text.points);
    EXPECT_EQ(soup.triangles, text.triangles);
  }
}

// The first byte of the body is a line end, and part of a number.
TEST(PlyFile, BinaryBodyThatBeginsWithALineEnd) {
  const std::string elements = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                               "element face 1\nproperty list uchar int vertex_index\n";
  const auto x = std::bit_cast<float>(0x3f80000au);
  std::string body = raw(x);
  for (const float v : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) body += raw(v);
  body += '\x03' + raw(0) + raw(1) + raw(2);
  EXPECT_EQ(read_mesh_file(ply("binary_little_endian", elements, body), "ply").points.at(0).x, static_cast<double>(x));
}

TEST(PlyFile, StripsTurnTheirTrianglesTheSameWay) {
  const std::string elements = ply_points + "element tristrips 1\nproperty list int int vertex_indices\n";
  const TriangleSoup soup =
      read_mesh_file(ply("ascii", elements, "0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n8 0 1 2 3 -1 1 3 2"), "ply");
  ASSERT_EQ(soup.triangles.size(), 3u);
  for (const auto& t : soup.triangles)
    EXPECT_GT(cross(soup.points[t[1]] - soup.points[t[0]], soup.points[t[2]] - soup.points[t[0]]).z, 0);
}

// Each of these files of some hundred bytes claims gigabytes.
TEST(PlyFile, CountsAreComparedWithTheBytesThatAreThere) {
  const std::string points = "property float x\nproperty float y\nproperty float z\n";
  EXPECT_EQ(mesh_refusal(ply("ascii", "element vertex 1000000000\n" + points, "0 0 0\n"), "ply"),
            "element vertex: expected at most the 1 that the rest of the file has room for, got 1000000000");
  EXPECT_EQ(mesh_refusal(ply("binary_little_endian", "element vertex 1000000000\n" + points, "0 0 0\n"), "ply"),
            "element vertex: expected at most the 0 that the rest of the file has room for, got 1000000000");
  const std::string list = "element face 1\nproperty list uint int vertex_indices\n";
  EXPECT_EQ(mesh_refusal(ply("binary_little_endian", "element vertex 1\n" + points + list,
                             std::string(12, '\0') + raw(0x7f7f7f7fu)),
                         "ply"),
            "face[0].vertex_indices: expected a list of at most the 0 numbers that the rest of the file has room for, "
            "got one of 2139062143");
  EXPECT_NE(
      mesh_refusal(ply("ascii", "element vertex 1\n" + points + list, "0 0 0\n900000000 0"), "ply").find("line 12: "),
      std::string::npos);
  EXPECT_NE(mesh_refusal(ply("ascii", "element nothing 1000000000000\n", ""), "ply").find("element nothing"),
            std::string::npos);
}

TEST(PlyFile, FaultsAreNamedByLineAndValue) {
  const std::string elements = ply_points + "element face 1\nproperty list uchar int vertex_indices\n";
  const std::string points = "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n";
  EXPECT_EQ(mesh_refusal(ply("ascii", elements, points + "3 0 1 4\n"), "ply"),
            "face[0][2]: expected an index below 4, got 4");
  EXPECT_EQ(mesh_refusal(ply("ascii", elements, points + "3 0 1 -4\n"), "ply"),
            "line 16: face[0].vertex_indices: expected indices >= 0, got -4");
  EXPECT_EQ(mesh_refusal(ply("ascii", elements, "0 0 zero 9\n" + points), "ply"),
            "line 12: expected a number, got \"zero\"");
  EXPECT_EQ(mesh_refusal(ply("ascii", elements, "0 0 nan 9\n" + points), "ply"),
            "line 12: vertex[0].z: expected a finite number, got nan");
  EXPECT_EQ(mesh_refusal("ply\nformat ascii 1.0\nelement vertex -3\n", "ply"),
            "line 3: expected a whole number >= 0, got \"-3\"");
  EXPECT_EQ(mesh_refusal("ply\nformat ascii 1.0\nelement vertex 1\nproperty float9 x\n", "ply"),
            "line 4: expected one of the types char, uchar, short, ushort, int, uint, float, double, got \"float9\"");
  EXPECT_EQ(mesh_refusal("ply\nformat ascii 1.0\n", "ply"),
            "expected a PLY header that ends with end_header, got the end of the file");
  EXPECT_EQ(mesh_refusal("", "ply"), "line 0: expected ply, got \"\"");
}

// A file cut short anywhere is refused and never read beyond.
TEST(PlyFile, EveryPrefixIsRefused) {
  const std::string elements = ply_points + "element face 2\nproperty list uchar ushort vertex_indices\n";
  std::string body;
  for (int i = 0; i < 4; ++i)
    body += raw(1.f * static_cast<float>(i % 2)) + raw(0.5f * static_cast<float>(i)) + raw(0.f) + "r";
  for (int i = 0; i < 2; ++i) body += '\x03' + raw<std::uint16_t>(0) + raw<std::uint16_t>(1) + raw<std::uint16_t>(2);
  const std::string whole = ply("binary_little_endian", elements, body);
  EXPECT_EQ(mesh_refusal(whole, "ply"), "read");
  for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_NE(mesh_refusal(whole.substr(0, n), "ply"), "read") << n;
}

// A comb: many corners that are not convex. The triangles cover its area once and all turn as it does.
TEST(Polygon, ConcaveOnesAreCoveredOnce) {
  for (const Vec3d& up : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{0, 1, 0}, Vec3d{-1, 0, 0}}) {
    std::vector<Vec3d> points{{20, -1, 0}, {0, -1, 0}};
    for (int i = 0; i < 20; ++i) {
      points.push_back({static_cast<double>(i), 0, 0});
      points.push_back({i + 0.25, 5, 0});
    }
    std::reverse(points.begin(), points.end());  // counter-clockwise seen from +Z
    const Vec3d u = up.y == 0 ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1}, v = cross(up, u);
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]).z / 2;
    std::vector<std::uint32_t> loop;
    for (Vec3d& p : points) {
      p = u * p.x + v * p.y + Vec3d{100, 200, 300};
      loop.push_back(static_cast<std::uint32_t>(loop.size()));
    }
    std::vector<Mesh<double>::Index> triangles;
    cut_polygon(points, loop, triangles);
    ASSERT_EQ(triangles.size(), points.size() - 2);
    double sum = 0;
    for (const auto& t : triangles) {
      const double part = dot(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]), up) / 2;
      EXPECT_GE(part, -1e-12);
      sum += part;
    }
    EXPECT_NEAR(sum, area, 1e-9);
  }
}

TEST(Polygon, WithoutAreaStillGivesItsTriangles) {
  const std::vector<Vec3d> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  std::vector<Mesh<double>::Index> triangles;
  cut_polygon(points, std::vector<std::uint32_t>{0, 1, 2, 3, 4}, triangles);
  EXPECT_EQ(triangles.size(), 3u);
}

TEST(ObjFile, FaultsAreNamedByLineAndValue) {
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(mesh_refusal(points + "f 1 2 3\n", "obj"), "read");
  EXPECT_EQ(mesh_refusal(points + "f -3 -2 \\\n -1\n", "obj"), "read");
  EXPECT_EQ(mesh_refusal(points + "f 1 2 9\n", "obj"), "line 4: expected the index of one of the 3 points (v), got 9");
  EXPECT_EQ(mesh_refusal(points + "f 1//1 2//1 3//2\nvn 0 0 1\n", "obj"),
            "line 4: expected the index of one of the 1 normals (vn), got 2");
  EXPECT_EQ(
      mesh_refusal("v 0 0\n", "obj"),
      "line 1: expected v and 3 finite numbers (or 4 with a weight, or 6 with a colour), in single precision, got "
      "\"v 0 0\"");
  for (const char* number : {"nan", "inf", "1e39", "one", ""})
    EXPECT_NE(mesh_refusal(std::string("v 0 0 ") + number + "\n" + points + "f 1 2 3\n", "obj").find("line 1: "),
              std::string::npos);
  for (const char* index : {"0", "-4", "1.5", "x", "1/2/3/4", "/1", "99999999999999999999"})
    EXPECT_NE(mesh_refusal(points + "f 1 2 " + index + "\n", "obj").find(std::string("got \"") + index + "\""),
              std::string::npos);
  EXPECT_NE(mesh_refusal(points + "f 1 2 3\nl 1 7\n", "obj").find("line 5: "), std::string::npos);
  EXPECT_NE(mesh_refusal(points + "vn 0 1\nf 1 2 3\n", "obj").find("line 4: expected vn"), std::string::npos);
  EXPECT_NE(mesh_refusal(points + "vt x\nf 1 2 3\n", "obj").find("line 4: expected vt"), std::string::npos);
  EXPECT_NE(mesh_refusal("v 0 0 0 0\n" + points + "f 1 2 3\n", "obj").find("line 1: expected a weight"),
            std::string::npos);
  EXPECT_EQ(mesh_refusal(points, "obj"),
            "expected a mesh with triangles, got a file without faces (lines that begin with f)");
}

// A quarter of a plate whose polygons have four and five corners, one of them turned in; two points are of no face.
TEST(ObjFile, IsReadInFull) {
  const std::string text = "# a comment\nmtllib none.mtl\no plate\nf 1/1 2/1 -1/1 3/1\n"  // a face before its points
                           "v 9 9 9\n";
  EXPECT_EQ(mesh_refusal(text, "obj").substr(0, 7), "line 4:");
  const TriangleSoup soup =
      read_mesh_file("v 9 9 9\nv 0 0 0 2\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nv 0.05 0.05 0\nv 8 8 8\n"
                     "vt 0 0\nvn 0 0 1\ng one\nf 2/1/1 3/1/1 \\\n 4/1/1 5/1/1\ns off\n"
                     "f 2 3 6 4 5\nf 2 3\nf 3\nl 2 3 4\np 1\n",
                     "obj");
  EXPECT_EQ(soup.points.size(), 5u);  // those that faces use
  EXPECT_EQ(soup.triangles.size(), 5u);
  EXPECT_EQ(soup.points[1].x, 0.1);  // in double
  double area = 0;
  for (const auto& t : soup.triangles)
    area += cross(soup.points[t[1]] - soup.points[t[0]], soup.points[t[2]] - soup.points[t[0]]).z / 2;
  EXPECT_NEAR(area, 0.01 + 0.0075, 1e-15);
}

/// Editors of some systems put it before the first line, which is one like any other.
TEST(MeshText, AByteOrderMarkIsNoPartOfTheText) {
  const std::string mark = "\xef\xbb\xbf";
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n";
  const std::string stl = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                          "endloop\nendfacet\nendsolid s\n";
  const std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  for (const auto& [text, ending] : {std::pair{obj, "obj"}, {stl, "stl"}, {ply, "ply"}}) {
    ASSERT_EQ(mesh_refusal(mark + text, ending), "read") << ending;
    const TriangleSoup plain = read_mesh_file(text, ending), marked = read_mesh_file(mark + text, ending);
    EXPECT_EQ(marked.points, plain.points) << ending;
    EXPECT_EQ(marked.triangles, plain.triangles) << ending;
  }
  EXPECT_EQ(read_mesh_file(mark + obj, "obj").points[0], (Vec3d{0, 0, 0}));
}

TEST(ObjFile, APolygonOfManyCornersIsRefused) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 1025; ++i) text += " " + std::to_string(1 + i % 3);
  EXPECT_EQ(mesh_refusal(text + "\n", "obj"), "line 4: expected a face of at most 1024 corners, got 1025");
}

std::string binary_stl(std::uint32_t count, std::size_t bytes, const std::string& begin = "") {
  std::string stl = begin + std::string(80 - begin.size(), ' ') + raw(count);
  for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f}) stl += raw(v);
  stl.resize(bytes, '\0');
  return stl;
}

TEST(StlFile, CountIsWhatTheSizeSays) {
  EXPECT_EQ(read_mesh_file(binary_stl(1, 134), "stl").triangles.size(), 1u);
  EXPECT_EQ(read_mesh_file(binary_stl(1, 134, "solid"), "stl").triangles.size(), 1u);  // as many programs write
  EXPECT_EQ(mesh_refusal(binary_stl(0xffffffffu, 134), "stl"),
            "byte 80: expected a count of triangles, 50 bytes each, that fits 134 bytes: 1, got 4294967295");
  EXPECT_EQ(mesh_refusal(binary_stl(0x80000001u, 134, "solid"), "stl").substr(0, 8), "expected");  // 134 modulo 2^32
  EXPECT_EQ(mesh_refusal("abc", "stl"),
            "expected a text that begins with solid, or a binary header of 84 bytes, got 3 bytes");
}

TEST(StlFile, BinaryCoordinatesAreReadAsTheyStand) {
  const TriangleSoup soup = read_mesh_file(binary_stl(1, 134), "stl");
  ASSERT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(soup.points[0], (Vec3d{0, 0, 0}));
  EXPECT_EQ(soup.points[1], (Vec3d{1, 0, 0}));
  EXPECT_EQ(soup.points[2], (Vec3d{0, 1, 0}));
  std::string bad = binary_stl(1, 134);
  bad.replace(84 + 12 + 12, 4, raw(std::numeric_limits<float>::infinity()));
  EXPECT_EQ(mesh_refusal(bad, "stl"), "triangles[0][1][0]: expected a finite number, got inf");
}

TEST(StlFile, AFacetHasThreeVertices) {
  const std::string head = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n",
                    tail = "endloop\nendfacet\nendsolid s\n";
  EXPECT_EQ(mesh_refusal(head + tail, "stl"), "line 6: expected a facet of 3 vertices, got \"endloop\"");
  EXPECT_EQ(mesh_refusal(head, "stl"), "expected facets of 3 vertices, got 2 in the last");
  EXPECT_EQ(mesh_refusal("solid s\nendsolid s\n", "stl"), "expected a mesh with triangles, got no facets");
}

/// Of a text that is cut off every beginning is refused, those that end between two facets too.
TEST(StlFile, EveryBeginningOfATextIsRefused) {
  const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                            "endfacet\n";
  const std::string solid = "solid s\n" + facet + facet + "endsolid s\n", two = solid + solid;
  EXPECT_EQ(read_mesh_file(two, "stl").triangles.size(), 4u);
  for (std::size_t length = 0; length < two.size(); ++length) {
    const bool one = length >= solid.find("endsolid") + 8 && length < solid.size() + 5;  // up to the next "solid"
    const bool all = length >= solid.size() + solid.find("endsolid") + 8;
    EXPECT_EQ(mesh_refusal(two.substr(0, length), "stl") == "read", one || all) << length;
  }
  EXPECT_EQ(mesh_refusal("solid s\n" + facet, "stl"),
            "line 8: expected endsolid behind the last facet, got the end of the file");
}

TEST(StlFile, TextIsReadAndItsFaultsAreNamedByLine) {
  const std::string text =
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
      "s\n";
  EXPECT_EQ(read_mesh_file(text, "stl").triangles.size(), 1u);
  std::string bad = text;
  bad.replace(bad.find("1 0 0"), 5, "1 nan 0");
  EXPECT_EQ(mesh_refusal(bad, "stl"),
            "line 5: expected vertex and 3 finite numbers, in single precision, got \"vertex 1 nan 0\"");
  bad = text;
  bad.replace(bad.find("0 0 1"), 5, "0 0");
  EXPECT_EQ(mesh_refusal(bad, "stl"), "line 2: expected facet normal and 3 numbers, got \"facet normal 0 0\"");
  for (const char* normal : {"nan nan nan", "-nan inf 0"}) {
    bad = text;
    EXPECT_EQ(mesh_refusal(bad.replace(bad.find("0 0 1"), 5, normal), "stl"), "read") << normal;
  }
}

}  // namespace
}  // namespace graze::io
