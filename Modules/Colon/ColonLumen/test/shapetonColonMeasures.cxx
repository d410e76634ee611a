#include "shapetonColonMeasures.h"

#include "itkConnectedComponentImageFilter.h"
#include "shapetonCurveSet.h"
#include "shapetonSurfaceLocator.h"
#include "shapetonSurfaceReader.h"
#include "shapetonExceptions.h"
#include "shapetonVolumeReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <ostream>

namespace shapeton
{
namespace
{
itk::Image<float, 3>::Pointer
ReadNumPy(const std::string & path)
{
  std::ifstream           in(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const auto header = std::string(bytes.begin() + 10, bytes.begin() + 10 + static_cast<unsigned char>(bytes.at(8)));
  const auto shape = header.find("'shape': (") + 10;
  std::array<int, 3> n{};
  if (std::sscanf(header.c_str() + shape, "%d, %d, %d", &n[0], &n[1], &n[2]) != 3 ||
      header.find("<i2") == std::string::npos)
  {
    throw InputError(path + ": not a three-dimensional array of 16-bit integers");
  }
  auto image = itk::Image<float, 3>::New();
  image->SetRegions(itk::Size<3>{ { static_cast<itk::SizeValueType>(n[2]),
                                    static_cast<itk::SizeValueType>(n[1]),
                                    static_cast<itk::SizeValueType>(n[0]) } });
  image->Allocate();
  const auto * values = reinterpret_cast<const short *>(bytes.data() + 10 + header.size());
  std::copy_n(values, static_cast<std::size_t>(n[0]) * n[1] * n[2], image->GetBufferPointer());
  return image;
}

double
Percentile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * (values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

void
PrintDistances(const std::string & what, const std::vector<double> & d, std::ostream & out)
{
  out << what << ": n " << d.size() << " median " << Percentile(d, 0.5) << " 95% " << Percentile(d, 0.95) << " 99% "
      << Percentile(d, 0.99) << " max " << Percentile(d, 1.0) << " mm\n";
}

void
PrintOverlap(const ColonLumen & lumen, const itk::Image<float, 3> * truth, std::ostream & out)
{
  const auto *          a = lumen.labels->GetBufferPointer();
  const float *         b = truth->GetBufferPointer();
  const std::size_t     n = lumen.labels->GetBufferedRegion().GetNumberOfPixels();
  std::map<int, double> missed;
  double                both = 0.0, found = 0.0, real = 0.0;
  for (std::size_t p = 0; p < n; ++p)
  {
    both += a[p] != 0 && b[p] != 0.0F;
    found += a[p] != 0;
    real += b[p] != 0.0F;
    missed[static_cast<int>(b[p])] += a[p] == 0 && b[p] != 0.0F;
  }
  const auto   s = truth->GetSpacing();
  const double ml = s[0] * s[1] * s[2] * 1e-3;
  out << "Dice " << 2.0 * both / (found + real) << " found " << found * ml << " true " << real * ml << " extra "
      << (found - both) * ml << " missed " << (real - both) * ml << " ml (";
  for (const auto & m : missed)
  {
    out << ' ' << m.first << ": " << m.second * ml;
  }
  out << " )\n";
}

/** Volume of found voxels without true lumen within 3 mm along any axis: other organs rather than an inexact border. */
void
PrintLeak(const ColonLumen & lumen, const itk::Image<float, 3> * truth, std::ostream & out)
{
  const auto  spacing = truth->GetSpacing();
  std::size_t leaked = 0;
  for (std::size_t p = 0; p < truth->GetBufferedRegion().GetNumberOfPixels(); ++p)
  {
    if (lumen.labels->GetBufferPointer()[p] == 0 || truth->GetBufferPointer()[p] != 0.0F)
    {
      continue;
    }
    const auto    middle = truth->ComputeIndex(static_cast<itk::OffsetValueType>(p));
    itk::Index<3> low, high;
    for (int a = 0; a < 3; ++a)
    {
      const int reach = static_cast<int>(std::lround(3.0 / spacing[a]));
      low[a] = std::max<itk::IndexValueType>(0, middle[a] - reach);
      high[a] = std::min<itk::IndexValueType>(truth->GetBufferedRegion().GetSize(a) - 1, middle[a] + reach);
    }
    bool isNear = false;
    for (auto i = low; i[2] <= high[2] && !isNear; ++i[2])
    {
      for (i[1] = low[1]; i[1] <= high[1] && !isNear; ++i[1])
      {
        for (i[0] = low[0]; i[0] <= high[0] && !isNear; ++i[0])
        {
          isNear = truth->GetPixel(i) != 0.0F;
        }
      }
    }
    leaked += !isNear;
  }
  out << "leak beyond 3 mm " << leaked * spacing[0] * spacing[1] * spacing[2] * 1e-3 << " ml\n";
}

/** Prints the largest connected errors: missed or extra voxels. */
void
PrintBlobs(const ColonLumen &           lumen,
           const itk::Image<float, 3> * truth,
           const itk::Image<float, 3> * ct,
           std::ostream &               out)
{
  using Mask = itk::Image<unsigned char, 3>;
  for (const bool missed : { true, false })
  {
    auto mask = Mask::New();
    mask->CopyInformation(truth);
    mask->SetRegions(lumen.labels->GetBufferedRegion());
    mask->Allocate();
    const std::size_t n = lumen.labels->GetBufferedRegion().GetNumberOfPixels();
    for (std::size_t p = 0; p < n; ++p)
    {
      const bool found = lumen.labels->GetBufferPointer()[p] != 0;
      const bool real = truth->GetBufferPointer()[p] != 0.0F;
      mask->GetBufferPointer()[p] = missed ? real && !found : found && !real;
    }
    using Components = itk::ConnectedComponentImageFilter<Mask, itk::Image<unsigned int, 3>>;
    auto components = Components::New();
    components->SetInput(mask);
    components->Update();
    struct Blob
    {
      double                 n{ 0.0 }, hu{ 0.0 };
      itk::Vector<double, 3> place{ 0.0 };
    };
    std::map<unsigned int, Blob> blobs;
    for (std::size_t p = 0; p < n; ++p)
    {
      const auto c = components->GetOutput()->GetBufferPointer()[p];
      if (c != 0)
      {
        auto &                blob = blobs[c];
        itk::Point<double, 3> x;
        truth->TransformIndexToPhysicalPoint(truth->ComputeIndex(static_cast<itk::OffsetValueType>(p)), x);
        blob.n += 1.0;
        blob.hu += ct->GetBufferPointer()[p];
        blob.place += x.GetVectorFromOrigin();
      }
    }
    std::vector<Blob> order;
    for (const auto & b : blobs)
    {
      order.push_back(b.second);
    }
    std::sort(order.begin(), order.end(), [](const Blob & a, const Blob & b) { return a.n > b.n; });
    const auto s = truth->GetSpacing();
    for (std::size_t i = 0; i < std::min<std::size_t>(8, order.size()); ++i)
    {
      out << (missed ? "  missed " : "  extra ") << order[i].n * s[0] * s[1] * s[2] * 1e-3 << " ml, "
          << order[i].hu / order[i].n << " HU, at " << order[i].place / order[i].n << '\n';
    }
  }
}

/** Found and true volume of tissue around points, and fluid fraction of the surrounding lumen. */
struct Relief
{
  double          found{ 0.0 };
  double          real{ 0.0 };
  double          lumen{ 0.0 };
  double          fluid{ 0.0 };
  Eigen::Vector3d place{ 0.0, 0.0, 0.0 };
};

Relief
MeasureRelief(const std::vector<Eigen::Vector3d> & points,
              double                               reach,
              const itk::Image<float, 3> *         truth,
              const itk::Image<float, 3> *         occupancy)
{
  std::set<std::size_t> voxels;
  const auto            spacing = truth->GetSpacing();
  for (const auto & point : points)
  {
    itk::Point<double, 3> x;
    std::copy_n(point.data(), 3, x.begin());
    const auto    middle = truth->TransformPhysicalPointToIndex(x);
    itk::Index<3> low, high;
    for (int a = 0; a < 3; ++a)
    {
      low[a] = middle[a] - static_cast<int>(std::ceil(reach / spacing[a]));
      high[a] = middle[a] + static_cast<int>(std::ceil(reach / spacing[a]));
    }
    for (auto i = low; i[2] <= high[2]; ++i[2])
    {
      for (i[1] = low[1]; i[1] <= high[1]; ++i[1])
      {
        for (i[0] = low[0]; i[0] <= high[0]; ++i[0])
        {
          itk::Point<double, 3> y;
          truth->TransformIndexToPhysicalPoint(i, y);
          if (truth->GetBufferedRegion().IsInside(i) && (y - x).GetNorm() <= reach)
          {
            voxels.insert(truth->ComputeOffset(i));
          }
        }
      }
    }
  }
  Relief relief;
  relief.place = points[points.size() / 2];
  for (const auto p : voxels)
  {
    itk::Point<double, 3> x;
    truth->TransformIndexToPhysicalPoint(truth->ComputeIndex(static_cast<itk::OffsetValueType>(p)), x);
    itk::Index<3> i;
    const bool    isIn = occupancy->TransformPhysicalPointToIndex(x, i);
    const float   label = truth->GetBufferPointer()[p];
    relief.found += 1.0 - (isIn ? occupancy->GetPixel(i) : 0.0F);
    relief.real += label == 0.0F;
    relief.lumen += label != 0.0F;
    relief.fluid += label == 2.0F;
  }
  return relief;
}

void
PrintReliefs(const std::string & what, const std::vector<Relief> & reliefs, std::ostream & out)
{
  for (const bool submerged : { true, false })
  {
    std::vector<double> kept;
    for (const auto & r : reliefs)
    {
      if (r.real > 0.0 && r.lumen > 0.0 && (r.fluid > 0.9 * r.lumen) == submerged)
      {
        kept.push_back(r.found / r.real);
        if (kept.back() < 0.9)
        {
          out << "  keeps " << kept.back() << " at " << r.place.transpose() << '\n';
        }
      }
    }
    const auto good = std::count_if(kept.begin(), kept.end(), [](double k) { return k >= 0.9; });
    out << what << (submerged ? " in fluid: " : " elsewhere: ") << good << " of " << kept.size() << " keep 90 %; least "
        << Percentile(kept, 0.0) << " 5% " << Percentile(kept, 0.05) << " median " << Percentile(kept, 0.5) << " most "
        << Percentile(kept, 1.0) << '\n';
  }
}

void
CompareReliefs(const itk::Image<float, 3> * truth,
               const itk::Image<float, 3> * occupancy,
               const std::string &          folder,
               std::ostream &               out)
{
  const CurveSet      folds = ReadCurves(folder + "/folds.vtp");
  const auto          height = PointValues(folds, "crestHeight", "folds");
  const auto *        thickness = FindSurfaceArray(folds.cellArrays, "thickness");
  std::vector<Relief> reliefs;
  for (std::size_t c = 0; c < folds.curves.size(); ++c)
  {
    std::vector<Eigen::Vector3d> crest;
    for (const int v : folds.curves[c])
    {
      if (height[v] >= 2.0)
      {
        crest.push_back(folds.V.row(v));
      }
    }
    if (!crest.empty() && thickness->values(static_cast<Eigen::Index>(c), 0) >= 2.5)
    {
      reliefs.push_back(MeasureRelief(crest, 4.0, truth, occupancy));
    }
  }
  PrintReliefs("folds from 2.5 mm", reliefs, out);
  std::ifstream in(folder + "/polyps.csv");
  std::string   line;
  std::getline(in, line);
  reliefs.clear();
  while (std::getline(in, line))
  {
    std::vector<std::string> cells;
    std::istringstream       row(line);
    for (std::string cell; std::getline(row, cell, ',');)
    {
      cells.push_back(cell);
    }
    const double diameter = std::stod(cells.at(2));
    if (diameter >= 6.0)
    {
      reliefs.push_back(MeasureRelief(
        { { std::stod(cells[4]), std::stod(cells[5]), std::stod(cells[6]) } }, 0.5 * diameter + 1.0, truth, occupancy));
    }
  }
  PrintReliefs("polyps from 6 mm", reliefs, out);
}
} // namespace

itk::Image<float, 3>::Pointer
ReadColonTestVolume(const std::string & path, std::string & patientPosition)
{
  if (path.size() > 4 && path.substr(path.size() - 4) == ".npy")
  {
    return ReadNumPy(path);
  }
  const Volume volume = ReadVolume(path);
  patientPosition = volume.patientPosition;
  return volume.image;
}

std::vector<itk::Point<double, 3>>
HalfLevelPoints(const itk::Image<float, 3> * occupancy)
{
  std::vector<itk::Point<double, 3>> points;
  const auto                         size = occupancy->GetBufferedRegion().GetSize();
  const float *                      v = occupancy->GetBufferPointer();
  const auto *                       offsets = occupancy->GetOffsetTable();
  for (itk::SizeValueType k = 0; k + 1 < size[2]; ++k)
  {
    for (itk::SizeValueType j = 0; j + 1 < size[1]; ++j)
    {
      for (itk::SizeValueType i = 0; i + 1 < size[0]; ++i)
      {
        const std::size_t p = i + j * offsets[1] + k * offsets[2];
        for (int a = 0; a < 3; ++a)
        {
          const float x = v[p];
          const float y = v[p + offsets[a]];
          if ((x < 0.5F) != (y < 0.5F))
          {
            itk::ContinuousIndex<double, 3> index;
            index[0] = static_cast<double>(i);
            index[1] = static_cast<double>(j);
            index[2] = static_cast<double>(k);
            index[a] += (0.5 - x) / (y - x);
            itk::Point<double, 3> point;
            occupancy->TransformContinuousIndexToPhysicalPoint(index, point);
            points.push_back(point);
          }
        }
      }
    }
  }
  return points;
}

void
CompareWithTruth(const itk::Image<float, 3> * ct,
                 const ColonLumen &           lumen,
                 const CleansedColon &        cleansed,
                 const std::string &          folder,
                 std::ostream &               out)
{
  std::string unused;
  const auto  truth = ReadColonTestVolume(folder + "/lumen.nrrd", unused);
  PrintOverlap(lumen, truth, out);
  PrintLeak(lumen, truth, out);
  PrintBlobs(lumen, truth, ct, out);
  SurfaceReadOptions allComponents;
  allComponents.component = -1;
  const Surface                wall = ReadSurface(folder + "/wall.vtp", allComponents);
  const SurfaceLocator         toWall(wall.mesh.V, wall.mesh.F);
  std::vector<double>          all, nearLevel;
  const auto                   points = HalfLevelPoints(cleansed.occupancy);
  const std::size_t            stride = std::max<std::size_t>(1, points.size() / 200000);
  const itk::Vector<double, 3> g = lumen.gravity;
  for (std::size_t p = 0; p < points.size(); p += stride)
  {
    const Eigen::Vector3d x(points[p][0], points[p][1], points[p][2]);
    all.push_back(toWall.FindClosest(x).distance);
    for (const auto & level : lumen.levels)
    {
      if (level.isColon && std::abs((points[p] - level.center) * g) < 3.0 &&
          (points[p] - level.center).GetNorm() < 25.0)
      {
        nearLevel.push_back(all.back());
        break;
      }
    }
  }
  PrintDistances("found to true wall", all, out);
  CompareReliefs(truth, cleansed.occupancy, folder, out);
  PrintDistances("within 3 mm of a level", nearLevel, out);
}
} // namespace shapeton
