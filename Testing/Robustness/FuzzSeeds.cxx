#include "FuzzSeeds.h"

#include "itkDicomFixture.h"
#include "itkVolumeWriter.h"

#include "itk_zlib.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace
{
std::string
BytesOf(const std::string & path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

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
  const std::string       path = folder + "/seed.dcm";
  const itk::DicomFixture fixture;
  const auto              add = [&] { seeds.push_back({ ".dcm", BytesOf(path) }); };
  const auto              slice = [&] { return fixture.MakeSlice(fixture.SlicePosition(4.0), 3); };
  const auto              frames = [&] { return fixture.MakeEnhanced({ 6, 0, 4, 2 }); };
  const E_TransferSyntax  native[] = { EXS_LittleEndianExplicit,
                                       EXS_LittleEndianImplicit,
                                       EXS_BigEndianExplicit,
                                       EXS_DeflatedLittleEndianExplicit,
                                       EXS_RLELossless };
  for (const auto syntax : native)
  {
    itk::SaveDicom(*slice(), path, syntax);
    add();
    itk::SaveDicom(*frames(), path, syntax);
    add();
  }
  // JPEG lossless, JPEG-LS, JPEG 2000
  for (const char * syntax : { "1.2.840.10008.1.2.4.70", "1.2.840.10008.1.2.4.80", "1.2.840.10008.1.2.4.90" })
  {
    itk::SaveDicom(*slice(), path);
    itk::CompressDicom(path, syntax);
    add();
    itk::SaveDicom(*frames(), path);
    itk::CompressDicom(path, syntax);
    add();
  }
  slice()->getDataset()->saveFile(path.c_str(), EXS_LittleEndianImplicit); // without a meta header
  add();
}

void
AddImageSeeds(const std::string & folder, std::vector<FuzzSeed> & seeds)
{
  const auto                image = MakeImage();
  const itk::VolumeMetadata metadata = { { "key", "value" } };
  for (const std::string extension : { ".nrrd", ".nii", ".mha" })
  {
    const std::string path = folder + "/seed" + extension;
    itk::WriteVolume<short>(image.GetPointer(), path, metadata);
    seeds.push_back({ extension, BytesOf(path) });
  }
  const auto floats = itk::Image<float, 3>::New();
  floats->SetRegions(image->GetLargestPossibleRegion());
  floats->Allocate(true);
  for (const std::string extension : { ".nrrd", ".mha" }) // raw
  {
    const std::string path = folder + "/seed" + extension;
    itk::WriteVolume<float>(floats.GetPointer(), path, metadata);
    seeds.push_back({ extension, BytesOf(path) });
  }
  seeds.push_back({ ".nii.gz", BytesOf(folder + "/seed.nii"), true });
  seeds.push_back(
    { ".nrrd",
      "NRRD0005\ntype: int\ndimension: 3\nsizes: 2 2 2\nspacings: 1 2 3\nencoding: ascii\n\n1 2 3 4 5 6 7 8\n" });
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
  AddImageSeeds(folder, seeds);
  return seeds;
}
