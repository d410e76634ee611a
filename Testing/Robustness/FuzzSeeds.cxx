#include "FuzzSeeds.h"

#include "shapetonBase64Text.h"
#include "shapetonDicomFixture.h"
#include "shapetonFileBytes.h"
#include "shapetonGltfTestFiles.h"
#include "shapetonNiftiTestFile.h"
#include "shapetonSurfaceWriter.h"
#include "shapetonTestSurfaces.h"
#include "shapetonVolumeWriter.h"

#include "itk_zlib.h"

#include <bzlib.h>

#include <stdexcept>

namespace
{
itk::Image<short, 3>::Pointer
MakeImage()
{
  const auto image = itk::Image<short, 3>::New();
  image->SetRegions(itk::Size<3>{ { 6, 5, 4 } });
  image->Allocate();
  for (short i = 0; i < 120; ++i)
  {
    image->GetBufferPointer()[i] = i;
  }
  return image;
}

void
AddDicomSeeds(const std::string & folder, std::vector<FuzzSeed> & seeds)
{
  const std::string            path = folder + "/seed.dcm";
  const shapeton::DicomFixture fixture;
  const auto                   add = [&] { seeds.push_back({ ".dcm", shapeton::ReadFileBytes(path) }); };
  const auto                   slice = [&] { return fixture.MakeSlice(fixture.SlicePosition(4.0), 3); };
  const auto                   frames = [&] { return fixture.MakeEnhanced({ 6, 0, 4, 2 }); };
  const E_TransferSyntax       native[] = { EXS_LittleEndianExplicit,
                                            EXS_LittleEndianImplicit,
                                            EXS_BigEndianExplicit,
                                            EXS_DeflatedLittleEndianExplicit,
                                            EXS_RLELossless };
  for (const auto syntax : native)
  {
    shapeton::SaveDicom(*slice(), path, syntax);
    add();
    shapeton::SaveDicom(*frames(), path, syntax);
    add();
  }
  // JPEG lossless, JPEG-LS, JPEG 2000
  for (const char * syntax : { "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.90" })
  {
    shapeton::SaveDicom(*slice(), path);
    shapeton::CompressDicom(path, syntax);
    add();
    shapeton::SaveDicom(*frames(), path);
    shapeton::CompressDicom(path, syntax);
    add();
  }
  slice()->getDataset()->saveFile(path.c_str(), EXS_LittleEndianImplicit); // without a meta header
  add();
}

/** Slices as other programs write them: VR UN, mosaics, code extensions of character sets, label maps. */
void
AddOtherDicomSeeds(const std::string & folder, std::vector<FuzzSeed> & seeds)
{
  const std::string            path = folder + "/seed.dcm";
  const shapeton::DicomFixture fixture;
  const auto                   add = [&](DcmFileFormat & file, E_TransferSyntax syntax = EXS_LittleEndianExplicit) {
    shapeton::SaveDicom(file, path, syntax);
    seeds.push_back({ ".dcm", shapeton::ReadFileBytes(path) });
  };
  for (const auto syntax : { EXS_LittleEndianExplicit, EXS_BigEndianExplicit })
  {
    const auto slice = fixture.MakeSlice(fixture.SlicePosition(4.0), 3);
    const auto frames = fixture.MakeEnhanced({ 6, 0, 4, 2 });
    for (DcmFileFormat * const file : { slice.get(), frames.get() })
    {
      shapeton::StoreAllAsUnknown(*file->getDataset());
      add(*file, syntax);
    }
  }
  auto mosaic = fixture.MakeMosaic(false);
  shapeton::AddPrivate(*mosaic->getDataset(), 0x19, "SIEMENS MR HEADER", 0x0A, std::string("\6\0", 2));
  add(*mosaic);
  auto slice = fixture.MakeSlice(fixture.SlicePosition(4.0), 3);
  shapeton::SetText(*slice, DCM_SpecificCharacterSet, "ISO 2022 IR 13\\ISO 2022 IR 87\\ISO 2022 IR 159");
  shapeton::SetText(*slice, DCM_SeriesDescription, "\xd4\xcf=\x1b$B;3ED\x1b(J\x1b$(D\x30\x21\x1b(J");
  add(*slice);
  shapeton::SetText(*slice, DCM_SpecificCharacterSet, "\\ISO 2022 IR 149");
  shapeton::SetText(*slice, DCM_SeriesDescription, "Hong=\x1b$)C\xfb\xf3");
  add(*slice);
  add(*fixture.MakeLabelMap({ fixture.origin, fixture.SlicePosition(4.0) }, std::vector<Uint16>(126, 1), 8, { 1 }));
  constexpr std::size_t groupLength = 140; // its place in a file
  seeds.push_back(FuzzSeed(seeds.back()));
  seeds.back().bytes[groupLength] = '\x10'; // wrong
}

void
AddImageSeeds(const std::string & folder, std::vector<FuzzSeed> & seeds)
{
  const auto                     image = MakeImage();
  const shapeton::VolumeMetadata metadata = { { "key", "value" } };
  for (const std::string extension : { ".nrrd", ".nii", ".mha" })
  {
    const std::string path = folder + "/seed" + extension;
    shapeton::WriteVolume<short>(image.GetPointer(), path, metadata);
    seeds.push_back({ extension, shapeton::ReadFileBytes(path) });
  }
  const auto floats = itk::Image<float, 3>::New();
  floats->SetRegions(image->GetLargestPossibleRegion());
  floats->Allocate(true);
  for (const std::string extension : { ".nrrd", ".mha" }) // raw
  {
    const std::string path = folder + "/seed" + extension;
    shapeton::WriteVolume<float>(floats.GetPointer(), path, metadata);
    seeds.push_back({ extension, shapeton::ReadFileBytes(path) });
  }
  seeds.push_back({ ".nii.gz", shapeton::ReadFileBytes(folder + "/seed.nii"), true });
  niftitest::NiftiFile swapped(1, true); // with a qform in meters and rescaled values
  swapped.SetVoxels<std::int16_t>(4);
  swapped.SetScale(2.0, -1000.0);
  swapped.SetUnits(1);
  swapped.SetCodes(1, 0);
  swapped.SetQform({ 0.5, 0.5, 0.5, 1.0, 2.0, 3.0 });
  seeds.push_back({ ".nii", swapped.Single() });
  seeds.push_back({ ".nii", niftitest::NiftiFile(2).Single() });
  seeds.push_back({ ".hdr.gz", niftitest::NiftiFile(2, true).Single(), true });
  seeds.push_back(
    { ".nrrd",
      "NRRD0005\ntype: int\ndimension: 3\nsizes: 2 2 2\nspacings: 1 2 3\nencoding: ascii\n\n1 2 3 4 5 6 7 8\n" });
  std::string  numbers(16, '\1');
  std::string  zipped(200, '\0');
  unsigned int length = 200;
  BZ2_bzBuffToBuffCompress(zipped.data(), &length, numbers.data(), 16, 1, 0, 0);
  seeds.push_back(
    { ".nrrd",
      "NRRD0004\ntype: short\nendian: big\ndimension: 4\nsizes: 1 2 2 2\nkinds: list domain domain domain\n"
      "space: left-anterior-superior\nspace directions: none (1,0,0) (0,2,0) (0,0,3)\n"
      "space origin: (4,5,6)\nspace units: \"cm\" \"cm\" \"cm\"\nencoding: bz2\nline skip: 1\n"
      "Segmentation_Extent:=10 11 20 21 30 31\n\na line\n" +
        zipped.substr(0, length) });
}

void
AddSurfaceSeeds(const std::string & folder, std::vector<FuzzSeed> & seeds)
{
  shapeton::SurfaceMesh mesh = testsurfaces::Octahedron();
  mesh.pointArrays.push_back({ "heat", Eigen::VectorXd(mesh.V.col(1)), false });
  mesh.cellArrays.push_back({ "label", Eigen::VectorXd::Constant(8, 3.0), true });
  mesh.facts = { { "tool", "test" } };
  for (const std::string extension : { ".vtp", ".stl", ".ply", ".obj" })
  {
    const std::string path = folder + "/seed" + extension;
    shapeton::WriteSurface(mesh, path);
    seeds.push_back({ extension, shapeton::ReadFileBytes(path) });
  }
  const std::string document = testsurfaces::GltfDocument("");
  seeds.push_back({ ".glb", testsurfaces::Glb(document) });
  seeds.push_back({ ".gltf",
                    testsurfaces::GltfDocument(",\"uri\":\"data:application/octet-stream;base64," +
                                               shapeton::Base64(testsurfaces::TetrahedronBuffer()) + '"') });
  seeds.push_back({ ".off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n" });
  seeds.push_back({ ".stl",
                    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                    "endfacet\nendsolid a\n" });
  seeds.push_back(
    { ".obj", // dialects, a seam, an unused vertex
      "# C:\\\r\no one two\r\nv 0 0 0 1 1 1\r\nv 10 0 \\\r\n 0 1 1 1\r\nv 0 10 0\nv nan nan 1e300\nv 10 0 0\n"
      "v 0 10 0 1.0\nv 10 10 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 \\\n3/1\ng b\nf -3 -1 -2 \\ \n" });
  seeds.push_back({ ".ply", // three faces at one edge
                    "ply\nformat ascii 1.0\nelement vertex 6\nproperty double x\nproperty double y\nproperty double z\n"
                    "element face 3\nproperty list uchar int vertex_index\nend_header\n0 0 0\n0 0 9\n5 0 0\n-5 0 0\n"
                    "0 5 0\nnan nan nan\n3 0 1 2\n3 0 1 3\n3 0 1 4\n" });
  seeds.push_back({ ".ply",
                    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                    "3 0 1 2\n3 0 2 3\n" });
  seeds.push_back(
    { ".vtp",
      "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='4' NumberOfStrips='1'><Points>"
      "<DataArray type='Float64' NumberOfComponents='3' format='ascii'>0 0 0 1 0 0 0 1 0 1 1 0</DataArray>"
      "</Points><Strips><DataArray type='Int32' Name='connectivity' format='ascii'>0 1 2 3</DataArray>"
      "<DataArray type='Int32' Name='offsets' format='ascii'>4</DataArray></Strips></Piece></PolyData>"
      "</VTKFile>" });
}
} // namespace

std::string
Gzip(const std::string & bytes)
{
  z_stream state{};
  if (deflateInit2(&state, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
  {
    throw std::bad_alloc();
  }
  std::string packed(deflateBound(&state, bytes.size()), '\0');
  state.next_in = reinterpret_cast<Bytef *>(const_cast<char *>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  state.next_out = reinterpret_cast<Bytef *>(&packed[0]);
  state.avail_out = static_cast<uInt>(packed.size());
  const bool isDone = deflate(&state, Z_FINISH) == Z_STREAM_END;
  packed.resize(state.total_out);
  deflateEnd(&state);
  if (!isDone)
  {
    throw std::runtime_error("cannot compress a seed");
  }
  return packed;
}

std::vector<FuzzSeed>
MakeFuzzSeeds(const std::string & folder)
{
  std::vector<FuzzSeed> seeds;
  AddDicomSeeds(folder, seeds);
  AddOtherDicomSeeds(folder, seeds);
  AddImageSeeds(folder, seeds);
  AddSurfaceSeeds(folder, seeds);
  return seeds;
}
