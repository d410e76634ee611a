#include "shapetonBase64Text.h"
#include "shapetonExceptions.h"
#include "shapetonJson.h"
#include "shapetonSurfaceQuality.h"
#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonGltfTestFiles.h"
#include "shapetonSurfaceTestFiles.h"
#include "shapetonSurfaceScene.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestSurfaces.h"

#include "gtest/gtest.h"

#include <cmath>
#include <limits>

namespace
{
using namespace testsurfaces;

shapeton::SurfaceMesh
MeshWithArrays()
{
  shapeton::SurfaceMesh mesh = Roughened(Torus(9, 7, 50, 20), 1.0, 3); // coordinates without short decimals
  mesh.pointArrays.push_back({ "heat", mesh.V.col(0) / 3.0, false });
  mesh.pointArrays.push_back({ "direction", mesh.V, false });
  shapeton::SurfaceArray::ValueMatrix labels(mesh.F.rows(), 1);
  for (Eigen::Index f = 0; f < labels.size(); ++f)
  {
    labels(f) = static_cast<double>(f) - 5;
  }
  mesh.cellArrays.push_back({ "label", labels, true });
  mesh.fieldArrays.push_back({ "rectumLoop", labels.topRows(3), true });
  mesh.facts = { { "tool", "SurfaceTest 0.1" }, { "note", "a < b & \"c\"" } };
  return mesh;
}

void
ExpectSameArrays(const std::vector<shapeton::SurfaceArray> & a, const std::vector<shapeton::SurfaceArray> & b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].values, b[i].values);
    EXPECT_EQ(a[i].areIntegers, b[i].areIntegers);
  }
}

shapeton::SurfaceMesh
RoundTrip(const shapeton::SurfaceMesh & mesh, const std::string & extension)
{
  const Folder folder;
  shapeton::WriteSurface(mesh, folder / ("a." + extension));
  shapeton::WriteSurface(mesh, folder / ("b." + extension));
  EXPECT_EQ(shapeton::ReadFileBytes(folder / ("a." + extension)), shapeton::ReadFileBytes(folder / ("b." + extension)));
  return shapeton::ReadSurfaceFile(folder / ("a." + extension)).mesh;
}

TEST(SurfaceFormats, VtpKeepsEverything)
{
  const shapeton::SurfaceMesh mesh = MeshWithArrays();
  const shapeton::SurfaceMesh back = RoundTrip(mesh, "vtp");
  EXPECT_EQ(back.V, mesh.V);
  EXPECT_EQ(back.F, mesh.F);
  ExpectSameArrays(back.pointArrays, mesh.pointArrays);
  ExpectSameArrays(back.cellArrays, mesh.cellArrays);
  ExpectSameArrays(back.fieldArrays, mesh.fieldArrays);
  EXPECT_EQ(back.facts, mesh.facts);
}

TEST(SurfaceFormats, PlyKeepsPositionsAndScalarArrays)
{
  const shapeton::SurfaceMesh mesh = MeshWithArrays();
  const shapeton::SurfaceMesh back = RoundTrip(mesh, "ply");
  EXPECT_EQ(back.V, mesh.V);
  EXPECT_EQ(back.F, mesh.F);
  ExpectSameArrays(back.pointArrays, { mesh.pointArrays[0] });
  ExpectSameArrays(back.cellArrays, mesh.cellArrays);
}

TEST(SurfaceFormats, ObjKeepsPositions)
{
  const shapeton::SurfaceMesh mesh = MeshWithArrays();
  const shapeton::SurfaceMesh back = RoundTrip(mesh, "obj");
  EXPECT_EQ(back.V, mesh.V);
  EXPECT_EQ(back.F, mesh.F);
}

TEST(SurfaceFormats, StlKeepsTheSurfaceInSinglePrecision)
{
  const shapeton::SurfaceMesh mesh = MeshWithArrays();
  const shapeton::SurfaceMesh back = RoundTrip(mesh, "stl");
  ASSERT_EQ(back.V.rows(), mesh.V.rows()); // corners were merged
  ASSERT_EQ(back.F.rows(), mesh.F.rows());
  for (int f = 0; f < mesh.NumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(back.V.row(back.F(f, k)).cast<float>(), mesh.V.row(mesh.F(f, k)).cast<float>());
    }
  }
  EXPECT_TRUE(shapeton::InspectSurface(back).isClosed);
}

/** A little endian word. */
std::size_t
WordAt(const std::string & bytes, std::size_t offset)
{
  std::size_t word = 0;
  for (int i = 3; i >= 0; --i)
  {
    word = 256 * word + static_cast<unsigned char>(bytes[offset + i]);
  }
  return word;
}

TEST(SurfaceFormats, GlbKeepsTheSurfaceInSinglePrecision)
{
  shapeton::SurfaceMesh mesh = MeshWithArrays();
  mesh.V.conservativeResize(mesh.V.rows() + 1, Eigen::NoChange); // an unused vertex, which is dropped
  mesh.V.bottomRows(1).setConstant(std::numeric_limits<double>::quiet_NaN());
  mesh.pointArrays.clear();
  const shapeton::SurfaceMesh back = RoundTrip(mesh, "glb");
  ASSERT_EQ(back.V.rows(), mesh.V.rows() - 1);
  EXPECT_EQ(back.F, mesh.F);
  EXPECT_LT((back.V - mesh.V.topRows(back.V.rows())).cwiseAbs().maxCoeff(), 1e-5);
  EXPECT_GT(*shapeton::InspectSurface(back).volume, 0.0);
}

TEST(SurfaceFormats, ScenesHaveNamesColorsAndUprightPatients)
{
  const Folder                folder;
  const std::string           path = folder / "scene.glb";
  const shapeton::SurfaceMesh ball = Icosphere(1, 10);
  shapeton::SurfaceMesh       head = Icosphere(2, 5); // above and in front of the ball, on its left
  head.V.rowwise() += Eigen::RowVector3d(3, -20, 40);
  shapeton::WriteSurfaceScene({ { "ball", { { 1.0, 0.5, 0.0 } }, ball }, { "head", {}, head } }, path);

  const shapeton::SurfaceFile file = shapeton::ReadSurfaceFile(path);
  ASSERT_EQ(file.parts.size(), 2u);
  EXPECT_EQ(file.parts[0].name, "ball");
  EXPECT_EQ(file.parts[1].name, "head");
  EXPECT_LT((file.mesh.V.bottomRows(head.V.rows()) - head.V).cwiseAbs().maxCoeff(), 1e-5); // LPS, mm

  // Without the note of the space, a reader gets the axes of glTF in meters: left, superior, anterior.
  std::string bytes = shapeton::ReadFileBytes(path);
  bytes.replace(bytes.find("\"SPACE\":\"LPS\""), 13, "\"SPACE\":\"any\"");
  shapeton::WriteFileBytes(path, bytes);
  const auto center = shapeton::ReadSurfaceFile(path).mesh.V.bottomRows(head.V.rows()).colwise().mean().eval();
  EXPECT_LT((center - Eigen::RowVector3d(3, 40, 20)).norm(), 1e-4);

  const auto document = shapeton::Json::parse(bytes.substr(20, WordAt(bytes, 12)));
  const auto color = document["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
  EXPECT_NEAR(color[1].get<double>(), 0.214041, 1e-6); // of 0.5 in sRGB, IEC 61966-2-1
  for (const auto & view : document["bufferViews"])
  {
    EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
  }
  EXPECT_EQ(WordAt(bytes, 8), bytes.size());
  EXPECT_THROW(shapeton::WriteSurfaceScene({ { "empty", {}, {} } }, path), shapeton::InputError);
  EXPECT_THROW(shapeton::WriteSurfaceScene({}, folder / "scene.gltf"), shapeton::ParameterError);
}

TEST(SurfaceFormats, FilesStateLpsWhere3DSlicerLooks)
{
  const Folder folder;
  for (const std::string extension : { "vtp", "stl", "ply", "obj" })
  {
    const std::string path = folder / ("a." + extension);
    shapeton::WriteSurface(Octahedron(), path);
    std::string       bytes = shapeton::ReadFileBytes(path);
    const std::string key = extension == "vtp" ? "Name=\"SPACE\"" : "SPACE=LPS";
    EXPECT_NE(bytes.find(key), std::string::npos) << extension;
  }
}

TEST(SurfaceFormats, RasIsTurnedToLps)
{
  const Folder folder;
  for (const std::string extension : { "stl", "ply", "obj" })
  {
    const std::string path = folder / ("a." + extension);
    shapeton::WriteSurface(Icosphere(1, 10), path);
    const shapeton::SurfaceMesh lps = shapeton::ReadSurfaceFile(path).mesh;
    std::string                 bytes = shapeton::ReadFileBytes(path);
    bytes.replace(bytes.find("SPACE=LPS"), 9, "SPACE=RAS");
    shapeton::WriteFileBytes(path, bytes);
    const shapeton::SurfaceMesh ras = shapeton::ReadSurfaceFile(path).mesh;
    EXPECT_EQ(ras.V.col(0), -lps.V.col(0)) << extension;
    EXPECT_EQ(ras.V.col(1), -lps.V.col(1)) << extension;
    EXPECT_EQ(ras.V.col(2), lps.V.col(2)) << extension;
    EXPECT_EQ(ras.F, lps.F) << extension;
  }
}

TEST(SurfaceFormats, OffWithCommentsColorsAndPolygons)
{
  const std::string           text = "OFF # a cube and more\n"
                                     "  5 3 0\n\n# vertices\n0 0 0 255 0 0\n1 0 0\n1 1 0\n0 1 0\n+.5 5e-1 1e0\n"
                                     "4 3 2 1 0 0.5 0.5 0.5\n3 0 1 4\n3 1 2 4\n";
  const shapeton::SurfaceFile file = ReadBytes("off", text);
  EXPECT_EQ(file.mesh.NumberOfVertices(), 5);
  EXPECT_EQ(file.mesh.NumberOfFaces(), 4);
  EXPECT_EQ(file.mesh.V.row(4), Eigen::RowVector3d(0.5, 0.5, 1.0));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0], "polygons were cut into triangles: 3 faces became 4");
  EXPECT_EQ(ReadBytes("OFF", "OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2").mesh.NumberOfFaces(), 1);
}

TEST(SurfaceFormats, ConcavePolygonsAreCutWithinThem)
{
  // An arrow head: a fan from the first corner would leave the polygon.
  const std::string           text = "OFF 4 1 0\n0 0 0\n4 -3 0\n1 0 0\n4 3 0\n4 0 1 2 3\n";
  const shapeton::SurfaceMesh mesh = ReadBytes("off", text).mesh;
  EXPECT_NEAR(shapeton::SurfaceArea(mesh.V, mesh.F), 3.0, 1e-12);
  // A comb with many teeth: the triangle areas sum to the polygon area (shoelace formula).
  const int   teeth = 20;
  std::string comb;
  for (int i = 0; i < teeth; ++i)
  {
    comb += std::to_string(i) + " 0 7\n" + std::to_string(i) + ".5 5 7\n";
  }
  comb = "OFF " + std::to_string(2 * teeth + 2) + " 1 0\n" + comb + std::to_string(teeth) + " 0 7\n0 -1 7\n" +
         std::to_string(2 * teeth + 2);
  for (int i = 2 * teeth + 1; i >= 0; --i)
  {
    comb += ' ' + std::to_string(i);
  }
  const shapeton::SurfaceMesh cut = ReadBytes("off", comb + "\n").mesh;
  EXPECT_NEAR(shapeton::SurfaceArea(cut.V, cut.F), teeth * 2.5 + teeth * 0.5, 1e-9);
}

TEST(SurfaceFormats, ObjWithGroupsNegativeIndicesAndContinuedLines)
{
  const std::string           text = "# comment\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 1 1 1\nv 1 1 0\nv 0 1 0\n"
                                     "vt 0 0\nvn 0 0 1\no left part\nf 1/1/1 2//1 3/1\nl 1 2\ng right\nf -4 \\\n-2 -1\no empty\n";
  const shapeton::SurfaceFile file = ReadBytes("obj", text);
  EXPECT_EQ(file.mesh.F.row(0), Eigen::RowVector3i(0, 1, 2));
  EXPECT_EQ(file.mesh.F.row(1), Eigen::RowVector3i(0, 2, 3));
  ASSERT_EQ(file.parts.size(), 2u);
  EXPECT_EQ(file.parts[0].name, "left part");
  EXPECT_EQ(file.parts[1].name, "right");
  EXPECT_EQ(file.parts[1].firstFace, 1);
  EXPECT_EQ(file.notes, std::vector<std::string>({ "1 points, lines or curves were skipped" }));
}

/** An octahedron in every dialect of OBJ that does not change the surface. */
TEST(SurfaceFormats, ObjDialectsGiveTheSameSurface)
{
  const shapeton::SurfaceMesh plain = Octahedron();
  const std::string           faces = "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";
  const std::string           weights = "v 1 0 0 1.0\nv -1 0 0 1.0\nv 0 1 0 1\nv 0 -1 0 1\nv 0 0 1 1\nv 0 0 -1 1\n";
  std::string                 crlf = "# made in C:\\models\\\n" + weights + faces;
  for (std::size_t i = crlf.find('\n'); i != std::string::npos; i = crlf.find('\n', i + 2))
  {
    crlf.insert(i, "\r");
  }
  const std::vector<std::string> dialects = {
    weights + faces,
    crlf,
    "v 1 0 0 .8 .5 .4\nv -1 0 0 .8 .5 .4\nv 0 1 0 1 1 1\nv 0 -1 0 1 1 1\nv 0 0 1 0 0 0\nv 0 0 -1 0 0 0\n" + faces,
    // continued lines: repeated, between numbers, before CR LF, before blanks, in an ignored line
    "vn 0 \\\n0 1\nv 1 0 \\\n0\nv \\\n-1 0\\\n 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\nf 1 \\\r\n 3 \\  \n \\\n 5\n" +
      faces.substr(8),
    // negative indices, texture and normal indices, vertices after the face, a trailing comment
    weights + "f -6 -4 -2 # back\nf 3/1 2/2 5/3\nf 2//1 4//1 5//1\nf 4/1/1 1/2/1 5/3/1\n" + faces.substr(32) +
      "# end \\",
    "\tv\t1 0 0\n  v -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\n" + faces.substr(0, faces.size() - 1) + "\\"
  };
  for (const std::string & dialect : dialects)
  {
    const shapeton::SurfaceFile file = ReadBytes("obj", dialect);
    EXPECT_EQ(file.mesh.V, plain.V) << dialect;
    EXPECT_EQ(file.mesh.F, plain.F) << dialect;
    EXPECT_TRUE(file.notes.empty()) << dialect;
  }
  EXPECT_NE(FaultOf("obj", "v 1 0 \\\n0\n# \\\nv 1 \\\n2 x\n").find("line 5: \"x\" is not a number"),
            std::string::npos);
}

TEST(SurfaceFormats, VerticesThatNoFaceUsesDoNotMatter)
{
  const shapeton::SurfaceMesh sphere = Icosphere(1, 30);
  shapeton::SurfaceMesh       mesh = sphere; // with leading vertices not used by faces
  mesh.V.resize(sphere.V.rows() + 4, 3);
  mesh.V.topRows(4) << std::nan(""), 0, 0, 1e30, 0, 0, 0, HUGE_VAL, 0, -1e300, std::nan(""), std::nan("");
  mesh.V.bottomRows(sphere.V.rows()) = sphere.V;
  mesh.F.array() += 4;
  const Folder folder;
  for (const std::string extension : { "vtp", "ply", "obj" })
  {
    shapeton::WriteSurface(mesh, folder / ("a." + extension));
    const shapeton::Surface        surface = shapeton::ReadSurface(folder / ("a." + extension));
    const shapeton::SurfaceQuality quality = shapeton::InspectSurface(surface.mesh);
    EXPECT_EQ(quality.defects.unreferencedVertices.size(), 4u) << extension;
    EXPECT_TRUE(quality.defects.coincidentVertices.empty()) << extension;
    EXPECT_EQ(quality.genus, 0) << extension;
    EXPECT_EQ(quality.highestCorner, sphere.V.colwise().maxCoeff().transpose()) << extension;
    EXPECT_EQ(quality.lowestCorner, sphere.V.colwise().minCoeff().transpose()) << extension;
    const shapeton::Surface repaired = shapeton::ReadRepairedSurface(folder / ("a." + extension));
    EXPECT_EQ(repaired.mesh.V, sphere.V) << extension;
    EXPECT_EQ(repaired.mesh.F, sphere.F) << extension;
    shapeton::SurfaceRepairOptions near;
    near.mergeDistance = 1e-3;
    EXPECT_EQ(shapeton::RepairSurface(surface.mesh, near).V, sphere.V) << extension;
  }
  EXPECT_EQ(ReadBytes("off", "OFF 4 1 0\n0 0 0\n9 0 0\n0 9 0\nnan inf 1e300\n3 0 1 2\n").mesh.NumberOfFaces(), 1);
  EXPECT_NE(
    FaultOf("off", "OFF 4 1 0\n0 0 0\n9 0 0\n0 9 0\nnan inf 1e300\n3 0 1 3\n").find("vertex 3 has a coordinate"),
    std::string::npos);
}

TEST(SurfaceFormats, TextPlyAndBigEndianPly)
{
  const std::string           header = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                       "property uchar red\nelement face 1\nproperty list uchar int vertex_index\nend_header\n";
  const shapeton::SurfaceMesh text =
    ReadBytes("ply", "ply\nformat ascii 1.0\ncomment a b\n" + header + "0 0 0 7\n2 0 0 8\n0 2 0.5 9\n3 0 1 2\n").mesh;
  std::string bytes = "ply\nformat binary_big_endian 1.0\n" + header;
  const auto  append = [&](const void * value, std::size_t size) {
    const char * const raw = static_cast<const char *>(value);
    bytes.append(
      std::string(std::reverse_iterator<const char *>(raw + size), std::reverse_iterator<const char *>(raw)));
  };
  const float points[3][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 2, 0.5 } };
  for (int v = 0; v < 3; ++v)
  {
    for (const float & x : points[v])
    {
      append(&x, 4);
    }
    bytes += static_cast<char>(7 + v);
  }
  bytes += '\3';
  for (std::int32_t v = 0; v < 3; ++v)
  {
    append(&v, 4);
  }
  const shapeton::SurfaceMesh binary = ReadBytes("ply", bytes).mesh;
  EXPECT_EQ(text.V, binary.V);
  EXPECT_EQ(text.F, binary.F);
  ExpectSameArrays(text.pointArrays, binary.pointArrays);
  EXPECT_EQ(text.V(2, 2), 0.5);
  ASSERT_EQ(text.pointArrays.size(), 1u);
  EXPECT_EQ(text.pointArrays[0].values(2, 0), 9.0);
}

TEST(SurfaceFormats, TextStl)
{
  const std::string facet = "facet normal nan nan nan\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 1 0\n"
                            " endloop\nendfacet\n";
  const shapeton::SurfaceMesh mesh =
    ReadBytes("stl", "solid any name\n" + facet + "endsolid any name\nsolid b\n" + facet + "endsolid\n").mesh;
  EXPECT_EQ(mesh.NumberOfFaces(), 2);
  EXPECT_EQ(mesh.NumberOfVertices(), 3);
}

TEST(SurfaceFormats, TextStlInCapitals)
{
  const std::string facet = " FACET NORMAL 0 0 1\n OUTER LOOP\n VERTEX 0 0 0\n VERTEX 1 0 0\n VERTEX 0 1E0 0\n"
                            " ENDLOOP\n ENDFACET\n";
  EXPECT_EQ(ReadBytes("stl", "SOLID A\n" + facet + "ENDSOLID A\n").mesh.NumberOfFaces(), 1);
}

TEST(SurfaceFormats, BinaryStlWhoseHeaderSaysSolid)
{
  const Folder folder;
  shapeton::WriteSurface(Octahedron(), folder / "a.stl");
  std::string bytes = shapeton::ReadFileBytes(folder / "a.stl");
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(ReadBytes("stl", bytes).mesh.NumberOfFaces(), 8);
  EXPECT_EQ(ReadBytes("stl", bytes).mesh.NumberOfVertices(), 6);
}

// ---- glTF ----

void
ExpectTwoTetrahedra(const shapeton::SurfaceFile & file)
{
  ASSERT_EQ(file.parts.size(), 2u);
  EXPECT_EQ(file.parts[0].name, "plain");
  EXPECT_EQ(file.parts[1].name, "tetra");
  EXPECT_EQ(file.unit, shapeton::SurfaceUnit::Meter);
  EXPECT_EQ(file.mesh.NumberOfFaces(), 8);
  EXPECT_EQ(file.mesh.V.colwise().maxCoeff(), Eigen::RowVector3d(5000, 2000, 1000));
  EXPECT_EQ(file.mesh.V.colwise().minCoeff(), Eigen::RowVector3d(0, 0, -2000));
  const shapeton::SurfaceQuality quality = shapeton::InspectSurface(file.mesh);
  ASSERT_TRUE(quality.volume.has_value()); // 1/6 and 8/6 m^3, both outward although one is mirrored
  EXPECT_NEAR(*quality.volume, 1.5e9, 1.0);
}

TEST(SurfaceFormats, GltfTakesBuffersWithinAndBesideIt)
{
  const std::string uri =
    R"(,"uri":"data:application/octet-stream;base64,)" + shapeton::Base64(TetrahedronBuffer()) + "\"";
  ExpectTwoTetrahedra(ReadBytes("gltf", GltfDocument(uri)));
  ExpectTwoTetrahedra(ReadBytes("glb", Glb(GltfDocument(""))));
  const Folder folder;
  shapeton::WriteFileBytes(folder / "a file.bin", TetrahedronBuffer());
  shapeton::WriteFileBytes(folder / "a.gltf", GltfDocument(R"(,"uri":"a%20file.bin")"));
  ExpectTwoTetrahedra(shapeton::ReadSurfaceFile(folder / "a.gltf"));
}

TEST(SurfaceFormats, FaultyGltf)
{
  const auto replaced = [](std::string document, const std::string & from, const std::string & to) {
    return FaultOf("glb", Glb(document.replace(document.find(from), from.size(), to)));
  };
  const std::string document = GltfDocument("");
  EXPECT_EQ(FaultOf("glb", Glb(document)), "");
  EXPECT_NE(replaced(document, "\"2.0\"", "\"1.0\"").find("version"), std::string::npos);
  EXPECT_NE(replaced(document, "\"count\":4", "\"count\":5").find("accessor 0 extends beyond"), std::string::npos);
  EXPECT_NE(replaced(document, "\"count\":4", "\"count\":3").find("refers to vertex 3"), std::string::npos);
  EXPECT_NE(replaced(document, "\"count\":12", "\"count\":18446744073709551615").find("beyond"), std::string::npos);
  EXPECT_NE(replaced(document, "\"count\":12", "\"count\":-1").find("not a valid glTF"), std::string::npos);
  EXPECT_NE(replaced(document, "\"children\":[2]", "\"children\":[1]").find("two parents"), std::string::npos);
  EXPECT_NE(replaced(document, "\"children\":[2]", "\"children\":[9]").find("not a valid glTF"), std::string::npos);
  EXPECT_NE(replaced(document, "\"buffer\":0", "\"buffer\":7").find("not a valid glTF"), std::string::npos);
  EXPECT_NE(replaced(document, "5126", "5121").find("not floats"), std::string::npos);
  const std::string base64 = shapeton::Base64(TetrahedronBuffer());
  for (const std::string & text : { base64 + "====", '=' + base64.substr(1), '*' + base64.substr(1) })
  {
    const std::string uri = R"(,"uri":"data:application/octet-stream;base64,)" + text + '"';
    EXPECT_NE(FaultOf("gltf", GltfDocument(uri)).find("not base64"), std::string::npos) << text;
  }
  EXPECT_NE(FaultOf("gltf", GltfDocument(R"(,"uri":"../secret.bin")")).find("outside its folder"), std::string::npos);
  EXPECT_NE(FaultOf("gltf", GltfDocument(R"(,"uri":"absent.bin")")).find("No such file"), std::string::npos);
  EXPECT_NE(FaultOf("glb", Glb(document).substr(0, 400)).find("truncated"), std::string::npos);
  EXPECT_NE(FaultOf("gltf", "{}").find("not a valid glTF"), std::string::npos);
}
} // namespace
