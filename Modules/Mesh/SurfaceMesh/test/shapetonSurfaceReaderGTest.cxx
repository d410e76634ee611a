#include "shapetonSurfaceReader.h"
#include "shapetonSurfaceConnectivity.h"
#include "shapetonSurfaceRepair.h"
#include "shapetonSurfaceTestFiles.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestSurfaces.h"
#include "shapetonTestErrors.h"

#include "gtest/gtest.h"

namespace
{
using namespace testsurfaces;

// ---- selection ----

std::string
FaultOfReading(const std::string & path, const shapeton::SurfaceReadOptions & options)
{
  return basetest::ErrorOf([&] { shapeton::ReadSurface(path, options); });
}

TEST(SurfaceReader, SeveralComponentsNeedAChoice)
{
  const Folder      folder;
  const std::string path = folder / "a.vtp";
  shapeton::WriteSurface(Together({ Octahedron(), Icosphere(1, 30) }), path);
  shapeton::SurfaceReadOptions options;
  const std::string            fault = FaultOfReading(path, options);
  EXPECT_NE(fault.find("it has 2 components: 1: 80 faces, "), std::string::npos) << fault;
  EXPECT_NE(fault.find("; 2: 8 faces, 2 x 2 x 2 mm; choose one with the parameter \"component\" = N"),
            std::string::npos)
    << fault;
  options.component = 2;
  EXPECT_EQ(shapeton::ReadSurface(path, options).mesh.F, Octahedron().F);
  options.component = 1;
  EXPECT_EQ(shapeton::ReadSurface(path, options).mesh.NumberOfFaces(), 80);
  options.component = -1;
  EXPECT_EQ(shapeton::ReadSurface(path, options).mesh.NumberOfFaces(), 88);
  options.component = 3;
  EXPECT_NE(FaultOfReading(path, options).find("component 3 does not exist; there are 2"), std::string::npos);
  options.component = -2;
  EXPECT_THROW(shapeton::ReadSurface(path, options), shapeton::ParameterError);
}

// A tube with a circumferential seam, and one with a longitudinal seam, in each format; STL does not index vertices.
TEST(SurfaceReader, SeamsDoNotSplitASurface)
{
  const shapeton::SurfaceMesh tube = Cylinder(12, 10, 20, 90); // two faces per cell, twelve cells per row
  const Folder                folder;
  for (const std::string name : { "a.vtp", "a.ply", "a.obj", "a.stl" })
  {
    shapeton::WriteSurface(WithSeam(tube, [](int f) { return f >= 5 * 24; }), folder / name);
    const shapeton::Surface around = shapeton::ReadSurface(folder / name);
    EXPECT_EQ(around.notes.size(), name == "a.stl" ? 0u : 1u) << name;
    shapeton::SurfaceReadOptions options;
    options.component = 1;
    EXPECT_EQ(shapeton::ReadSurface(folder / name, options).mesh.NumberOfFaces(), tube.NumberOfFaces()) << name;
    options.component = 2;
    EXPECT_NE(FaultOfReading(folder / name, options).find("component 2 does not exist; there are 1"), std::string::npos)
      << name;
    shapeton::WriteSurface(WithSeam(tube, [](int f) { return f % 24 < 12; }), folder / ("along" + name));
    for (const std::string & file : { name, "along" + name })
    {
      const shapeton::Surface repaired = shapeton::ReadRepairedSurface(folder / file);
      EXPECT_EQ(repaired.mesh.NumberOfVertices(), tube.NumberOfVertices()) << file;
      EXPECT_EQ(shapeton::SurfaceConnectivity(repaired.mesh).BoundaryLoops().size(), 2u) << file;
    }
  }
}

// Transforms of glTF nodes round differently: 0.1 + 0.2 is not 0.3.
TEST(SurfaceReader, SeamsThatDifferByRoundingAreSeams)
{
  const shapeton::SurfaceMesh tube = Cylinder(12, 10, 20, 90);
  shapeton::SurfaceMesh       split = WithSeam(tube, [](int f) { return f >= 5 * 24; });
  const Folder                folder;
  for (const double factor : { 1.0 + 4e-16, 1.0 + 1e-12, 1.0 + 1e-7 })
  {
    shapeton::SurfaceMesh moved = split;
    moved.V.bottomRows(split.NumberOfVertices() - tube.NumberOfVertices()) *= factor;
    shapeton::WriteSurface(moved, folder / "a.vtp");
    shapeton::SurfaceReadOptions options;
    options.component = 2;
    const bool isOne = FaultOfReading(folder / "a.vtp", options).find("there are 1") != std::string::npos;
    EXPECT_EQ(isOne, factor < 1.0 + 1e-8) << factor;
    if (isOne)
    {
      const shapeton::Surface repaired = shapeton::ReadRepairedSurface(folder / "a.vtp");
      EXPECT_EQ(repaired.mesh.NumberOfVertices(), tube.NumberOfVertices());
      EXPECT_EQ(shapeton::SurfaceConnectivity(repaired.mesh).BoundaryLoops().size(), 2u);
    }
  }
}

TEST(SurfaceReader, ACutAtAnEdgeOfMoreFacesIsNoted)
{
  const Folder folder;
  // Two open tetrahedra with a common edge, joined beside it by a triangle.
  shapeton::WriteSurface(
    FromLists({ { 0, 0, 0 }, { 0, 0, 20 }, { 20, 5, 10 }, { 20, -5, 10 }, { -20, 5, 10 }, { -20, -5, 10 } },
              { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 4, 1 }, { 0, 1, 5 }, { 2, 1, 3 }, { 4, 5, 1 }, { 0, 2, 4 } }),
    folder / "a.ply");
  const shapeton::Surface surface = shapeton::ReadRepairedSurface(folder / "a.ply");
  ASSERT_EQ(surface.notes.size(), 1u);
  EXPECT_EQ(surface.notes[0],
            "it is not manifold: 1 edge has more than two faces, the first from (0, 0, 0) to (0, 0, 20) mm; it was cut "
            "there, which adds boundaries");
}

TEST(SurfaceReader, ClosedSurfacesThatTouchAreTwo)
{
  shapeton::SurfaceMesh beside = CubeOfSixSquares(20);
  beside.V.col(0).array() += 20;
  const Folder folder;
  // Each cube is closed by the seams between its sides; the cubes share one side.
  shapeton::SurfaceMesh one = shapeton::RepairSurface(CubeOfSixSquares(20));
  shapeton::WriteSurface(Together({ one, shapeton::RepairSurface(beside) }), folder / "a.ply");
  shapeton::SurfaceReadOptions options;
  EXPECT_NE(FaultOfReading(folder / "a.ply", options).find("it has 2 components: 1: 12 faces"), std::string::npos);
  options.component = 1;
  EXPECT_EQ(shapeton::ReadRepairedSurface(folder / "a.ply", options).mesh.F, one.F);
}

/** Three rectangles of 9 x 5 mm that meet at one edge from (0, 0, 0) to (0, 0, 9), with a duplicate face. */
TEST(SurfaceReader, ASurfaceThatIsNotManifoldIsCutIntoComponents)
{
  const Folder folder;
  shapeton::WriteSurface(
    FromLists(
      { { 0, 0, 0 }, { 0, 0, 9 }, { 5, 0, 0 }, { 5, 0, 9 }, { -5, 0, 0 }, { -5, 0, 9 }, { 0, 5, 0 }, { 0, 5, 9 } },
      { { 0, 2, 3 }, { 0, 3, 1 }, { 0, 4, 5 }, { 0, 5, 1 }, { 0, 6, 7 }, { 0, 7, 1 }, { 7, 0, 6 } }),
    folder / "a.ply");
  const std::string where =
    "it is not manifold: 2 edges have more than two faces, the first from (0, 0, 0) to (0, 0, 9) mm; "
    "after cutting there it has 3 components: 1: 2 faces";
  // Accepted for inspection; components are counted by shared edges.
  const shapeton::Surface asItIs = shapeton::ReadSurface(folder / "a.ply");
  ASSERT_EQ(asItIs.notes.size(), 1u);
  EXPECT_EQ(asItIs.notes[0].find(where), 0u) << asItIs.notes[0];
  shapeton::SurfaceReadOptions options;
  const auto                   faultOfRepairing = [&] {
    return basetest::MessageOf([&] { shapeton::ReadRepairedSurface(folder / "a.ply", options); });
  };
  EXPECT_NE(faultOfRepairing().find(where), std::string::npos) << faultOfRepairing();
  EXPECT_NE(faultOfRepairing().find("the parameter \"component\" = -1"), std::string::npos);
  options.takesOneComponent = true;
  EXPECT_NE(faultOfRepairing().find(where), std::string::npos);
  EXPECT_EQ(faultOfRepairing().find("= -1"), std::string::npos);
  EXPECT_NE(FaultOfReading(folder / "a.ply", options).find(where), std::string::npos);
  for (options.component = 1; options.component <= 3; ++options.component) // as the message advises
  {
    const shapeton::Surface part = shapeton::ReadRepairedSurface(folder / "a.ply", options);
    EXPECT_EQ(part.mesh.NumberOfFaces(), 2);
    EXPECT_EQ(shapeton::SurfaceConnectivity(part.mesh).Components().size(), 1u);
  }
  EXPECT_NE(faultOfRepairing().find("component 4 does not exist; there are 3"), std::string::npos);
  options = {};
  options.component = -1;
  EXPECT_EQ(
    shapeton::SurfaceConnectivity(shapeton::ReadRepairedSurface(folder / "a.ply", options).mesh).Components().size(),
    3u);
}

TEST(SurfaceReader, AnImplausibleExtentNeedsAUnit)
{
  const Folder folder;
  for (const double radius : { 0.75, 750000.0 }) // a colon of 1.5 mm, and of 1500 m
  {
    const std::string path = folder / "a.ply";
    shapeton::WriteSurface(Icosphere(1, radius), path);
    shapeton::SurfaceReadOptions options;
    EXPECT_NE(FaultOfReading(path, options).find("implausible"), std::string::npos);
    options.anyExtent = true;
    const shapeton::Surface surface = shapeton::ReadSurface(path, options);
    EXPECT_NEAR(surface.mesh.V.row(0).norm(), radius, 1e-9 * radius);
    ASSERT_FALSE(surface.notes.empty());
    EXPECT_NE(surface.notes.back().find("implausible"), std::string::npos);
    options.unit = radius < 1.0 ? shapeton::SurfaceUnit::Meter : shapeton::SurfaceUnit::Micrometer;
    const double factor = radius < 1.0 ? 1000.0 : 0.001;
    EXPECT_NEAR(shapeton::ReadSurface(path, options).mesh.V.row(0).norm(), factor * radius, 1e-9 * factor * radius);
    options.unit = shapeton::SurfaceUnit::Millimeter;
    EXPECT_NEAR(shapeton::ReadSurface(path, options).mesh.V.row(0).norm(), radius, 1e-9 * radius);
  }
}

TEST(SurfaceReader, PartsByName)
{
  const Folder folder;
  shapeton::WriteFileBytes(
    folder / "a.obj",
    "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nv 9 9 9\no one\nf 1 2 3\no two\nf 2 3 4\nf 2 3 5\no one\nf 1 2 4\n");
  shapeton::SurfaceReadOptions options;
  options.component = -1;
  for (const auto & [name, faces] :
       std::vector<std::pair<std::string, int>>{ { "one", 1 }, { "two", 2 }, { "one #2", 1 } })
  {
    options.part = name;
    const shapeton::Surface surface = shapeton::ReadSurface(folder / "a.obj", options);
    EXPECT_EQ(surface.mesh.NumberOfFaces(), faces);
    EXPECT_EQ(surface.mesh.NumberOfVertices(), 2 + faces);
  }
  options.part = "three";
  EXPECT_NE(FaultOfReading(folder / "a.obj", options).find("parts: one (1 faces); two (2 faces); one #2"),
            std::string::npos);
  shapeton::WriteSurface(Icosphere(1, 30), folder / "b.ply");
  EXPECT_NE(FaultOfReading(folder / "b.ply", options).find("no named parts"), std::string::npos);
}

TEST(SurfaceReader, IdentityIsTheHashOfTheFile)
{
  const Folder folder;
  shapeton::WriteFileBytes(folder / "a.off", "OFF 3 1 0\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n");
  const shapeton::Surface surface = shapeton::ReadSurface(folder / "a.off");
  EXPECT_EQ(surface.identity.size(), 7u + 64u);
  EXPECT_EQ(surface.identity.find("sha256:"), 0u);
}

// ---- faulty files ----

struct Faulty
{
  const char * extension;
  std::string  bytes;
  const char * message; ///< part of the message
};

std::vector<Faulty>
FaultyFiles()
{
  const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string triangle = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string text = "This is a letter,\nno surface.\n";
  const std::string solidStl = "solid" + std::string(75, ' ') + std::string("\1\0\0\0", 4); // states a triangle
  return { { "off", "", "the file is empty" },
           { "txt", text, "not a surface format" },
           { "off", text, "line 1: the file does not begin with OFF" },
           { "off", "OFF 3 1 0\n" + triangle, "the file ends at face 0 of 1" },
           { "off", "OFF 3 1 0\n0 0 0\n1 0 0\n", "the file ends at vertex 2 of 3" },
           { "off", "OFF 3 1 0\n0 0 0\n1 x 0\n", "line 3: \"x\" is not a number" },
           { "off", "OFF 3 1 0\n0 0 0\n1 0\n", "line 3: the line ends where a coordinate" },
           { "off", "OFF 3 1 0\n" + triangle + "3 0 1 3\n", "refers to vertex 3 (counted from 0), but there are 3" },
           { "off", "OFF 3 1 0\n" + triangle + "3 0 1 -1\n", "face 0 refers to vertex -1" },
           { "off", "OFF 3 1 0\n" + triangle + "2 0 1\n", "face 0 has 2 corners" },
           { "off", "OFF 3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "vertex 1 has a coordinate that is not finite" },
           { "off", "OFF 3 1 0\n0 0 0\n1 1e999 0\n0 1 0\n3 0 1 2\n", "is not a number" },
           { "off", "OFF 3 0 0\n" + triangle, "there are no faces" },
           { "off", "OFF 999999999999 1 0\n", "more than the file can contain" },
           { "4off.off", "4OFF 1 1 0\n", "four or more dimensions" },
           { "obj", text, "there are no faces" },
           { "obj", "v 0 0 0\nv 1 0\n", "line 2: the line ends where a coordinate" },
           { "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "face 0 refers to vertex 3" },
           { "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "line 4: \"0\" is not a vertex index" },
           { "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", "before the first vertex" },
           { "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", "face 0 has 2 corners" },
           { "obj", "v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n", "not finite" },
           { "ply", text, "not a PLY file" },
           { "ply", ply + triangle, "the file ends where a value" },
           { "ply", ply + triangle + "3 0 1 7\n", "face 0 refers to vertex 7" },
           { "ply", ply + triangle + "3 0 1 1.5\n", "not an integer" },
           { "ply", "ply\nformat binary_little_endian 1.0\n" + ply.substr(ply.find("element")) + "abc", "truncated" },
           { "ply", "ply\nformat ascii 1.0\nelement vertex 99999999\nend_header\n", "more than the file can contain" },
           { "ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n", "not a property type" },
           { "ply", "ply\nformat morse 1.0\nend_header\n", "the format \"morse\" is unknown" },
           { "stl", text, "neither a text nor a binary STL file" },
           { "stl", std::string(84, '\xFF'), "truncated, or not an STL file: it states 4294967295 triangles" },
           { "stl", std::string(84, '\0'), "there are no faces" },
           { "stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n", "truncated" },
           { "stl", "solid a\nendsolid a\n", "there are no faces" },
           { "stl", solidStl, "truncated, or not an STL file: it states 1 triangles" },
           { "stl", "solid a\nsph\1ere\n", "line 2: \"sph ere\" found instead of \"facet\"" },
           { "stl", "solid a\nsphere\n", "line 2: \"sphere\" found instead of \"facet\"" },
           { "gltf", text, "not a valid glTF" },
           { "glb", "glTF\2", "truncated" },
           { "vtp", text, "not a VTP file" },
           { "vtp", "<VTKFile type=\"PolyData\"", "truncated: it ends within a tag" },
           { "vtp", "<html><body></body></html>", "lacks <VTKFile> or <PolyData>" },
           { "vtp", "<VTKFile><PolyData></VTKFile>", "<PolyData> is not closed" } };
}

TEST(SurfaceReader, FaultyFilesAreRefusedWithTheirFault)
{
  for (const Faulty & faulty : FaultyFiles())
  {
    const std::string fault = FaultOf(faulty.extension, faulty.bytes);
    EXPECT_NE(fault.find(faulty.message), std::string::npos)
      << faulty.extension << " [" << faulty.bytes.substr(0, 300) << "] gave [" << fault << ']';
    EXPECT_EQ(fault.find('\n'), std::string::npos);
  }
}

TEST(SurfaceReader, MissingFilesAndFolders)
{
  const Folder folder;
  EXPECT_THROW(shapeton::ReadSurfaceFile(folder / "absent.stl"), shapeton::InputError);
  EXPECT_THROW(shapeton::ReadSurfaceFile(folder / "."), shapeton::InputError);
  EXPECT_THROW(shapeton::WriteSurface(Octahedron(), folder / "absent/a.ply"), shapeton::OutputError);
  EXPECT_THROW(shapeton::WriteSurface(Octahedron(), folder / "a.off"), shapeton::ParameterError);
}

// A truncated file is rejected or, if text ends at a complete line, yields a smaller surface.
TEST(SurfaceReader, TruncatedBinaryFilesAreRefused)
{
  const Folder folder;
  for (const std::string extension : { "vtp", "stl", "ply" })
  {
    shapeton::WriteSurface(Icosphere(1, 10), folder / ("a." + extension));
    const std::string bytes = shapeton::ReadFileBytes(folder / ("a." + extension));
    for (std::size_t size = 1; size < bytes.size() - 20; size += bytes.size() / 23)
    {
      EXPECT_NE(FaultOf(extension, bytes.substr(0, size)), "") << extension << " cut to " << size;
    }
  }
}

class SurfaceReaderOfMutants : public testing::TestWithParam<std::string>
{};

// A mutated file is rejected with InputError or yields a valid surface.
TEST_P(SurfaceReaderOfMutants, AreRefusedOrSound)
{
  const Folder      folder;
  const std::string extension = GetParam();
  const std::string path = folder / ("a." + extension);
  shapeton::WriteSurface(Torus(6, 5, 30, 10), path);
  const std::string sound = shapeton::ReadFileBytes(path);
  Random            random(extension.size() + extension[0]);
  int               refused = 0;
  for (int trial = 0; trial < 300; ++trial)
  {
    std::string mutant = sound;
    for (int changes = 1 + random.Below(4); changes > 0; --changes)
    {
      const int place = random.Below(static_cast<int>(mutant.size()) / (trial % 2 ? 1 : 4) + 1);
      switch (random.Below(3))
      {
        case 0:
          mutant[place % mutant.size()] = static_cast<char>(random.Below(256));
          break;
        case 1:
          mutant.erase(place, 1 + random.Below(8));
          break;
        default:
          mutant.insert(place, std::string(1 + random.Below(4), static_cast<char>('0' + random.Below(10))));
      }
    }
    shapeton::WriteFileBytes(path, mutant);
    try
    {
      shapeton::RequireSound(shapeton::ReadSurfaceFile(path).mesh, "mutant");
    }
    catch (const shapeton::InputError &)
    {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

INSTANTIATE_TEST_SUITE_P(Formats, SurfaceReaderOfMutants, testing::Values("vtp", "stl", "ply", "obj"));
} // namespace
