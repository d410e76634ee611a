#include "shapetonHaustralFolds.h"

#include "shapetonFlatCoordinateMap.h"
#include "shapetonFoldMask.h"
#include "shapetonFoldReliability.h"
#include "shapetonFoldSplitting.h"
#include "shapetonExceptions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace shapeton
{
namespace
{
constexpr double widthOfTaenia = 4.0; ///< mm

void
RequireValid(const HaustralFoldOptions & options)
{
  CheckOptions(options);
  RequireParameter(options.publishedLow < options.publishedHigh,
                   "the parameter \"publishedLow\" must be less than the parameter \"publishedHigh\"");
}

bool
IsFold(const HaustralFold & fold, const HaustralFoldOptions & options)
{
  return fold.length >= options.minimumLength && fold.area >= options.minimumArea &&
         fold.elongation >= options.minimumElongation && std::abs(fold.angle) >= options.minimumAngle;
}

/** Implementation of FindHaustralFolds(). */
class FoldFinder
{
public:
  FoldFinder(const FlatColon & flat, const HaustralFoldSettings & options)
    : m_Grid(flat.Grid()), m_Options(options), m_Picture(MakeFoldPicture(flat, options))
  {
    if (options.taeniae)
    {
      m_Rule.isTaenia = MaskOfTaeniae(m_Grid, *options.taeniae, 0.5 * widthOfTaenia);
    }
  }

  HaustralFolds
  Find()
  {
    std::vector<FoldPixels> parts = this->Parts();
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      m_Options.progress(0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(parts.size()));
      MeasuredFold measured = MeasureFold(m_Grid, m_Picture, std::move(parts[i]), m_Options.scheme);
      if (IsFold(measured.fold, m_Options))
      {
        RateFold(m_Picture, m_Mixture, m_Options, measured);
        m_Found.push_back(std::move(measured));
      }
    }
    std::stable_sort(m_Found.begin(), m_Found.end(), [](const MeasuredFold & a, const MeasuredFold & b) {
      return a.fold.centerUv.x() < b.fold.centerUv.x();
    });
    RateEnds(m_Grid, m_Options.taeniae, m_Found);
    return this->Collect();
  }

private:
  bool
  IsPublished() const
  {
    return m_Options.scheme == HaustralFoldScheme::Published;
  }

  std::vector<char>
  Mask()
  {
    if (this->IsPublished())
    {
      return ThresholdFolds(m_Picture, m_Options);
    }
    m_Mixture = FitCurvatureMixture(m_Picture);
    m_Options.progress(0.6);
    return m_Mixture.hasFolds ? CutFolds(m_Picture, m_Mixture, m_Options) : std::vector<char>(m_Picture.Size(), 0);
  }

  /** Finds connected components and splits merged folds. Marks large folds in the picture, so that the crests of other
   * folds end there. */
  std::vector<FoldPixels>
  Parts()
  {
    std::vector<FoldPixels> parts;
    for (FoldPixels & whole : ConnectedFolds(m_Picture, this->Mask()))
    {
      m_Options.progress(0.7);
      std::vector<FoldPixels> some =
        this->IsPublished() ? std::vector<FoldPixels>{ std::move(whole) } : SplitFold(m_Picture, whole, m_Rule);
      std::move(some.begin(), some.end(), std::back_inserter(parts));
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      double area = 0.0;
      for (const FlatPixel & pixel : parts[i])
      {
        area += m_Picture.AreaOf(m_Picture.Index(pixel.column, pixel.row));
      }
      for (const FlatPixel & pixel : parts[i])
      {
        m_Picture.part[m_Picture.Index(pixel.column, pixel.row)] =
          area >= m_Rule.leastArea ? static_cast<int>(i) + 1 : 0;
      }
    }
    return parts;
  }

  HaustralFolds
  Collect() const
  {
    HaustralFolds folds;
    folds.labels = itk::Image<unsigned short, 2>::New();
    SetFlatSpace(m_Grid, folds.labels);
    folds.labels->Allocate(true);
    if (m_Found.size() > std::numeric_limits<unsigned short>::max())
    {
      throw InputError("more than 65535 folds were found; the surface may be too noisy");
    }
    for (const MeasuredFold & measured : m_Found)
    {
      folds.folds.push_back(measured.fold);
      folds.folds.back().label = static_cast<int>(folds.folds.size());
      this->Paint(measured.pixels, folds.folds.back().label, folds.labels);
    }
    if (!this->IsPublished())
    {
      this->LengthenLabels(folds);
    }
    if (m_Found.empty())
    {
      folds.warnings.push_back("no haustral folds were found: the wall is smooth, or its bulges are too small");
    }
    return folds;
  }

  /** Labels unlabeled pixels and returns their area, mm^2. */
  double
  Paint(const FoldPixels & pixels, int label, itk::Image<unsigned short, 2> * labels) const
  {
    double area = 0.0;
    for (const FlatPixel & pixel : pixels)
    {
      const std::size_t index = m_Picture.Index(pixel.column, pixel.row);
      unsigned short &  value = labels->GetBufferPointer()[index];
      area += value == 0 ? m_Picture.AreaOf(index) : 0.0;
      value = value == 0 ? static_cast<unsigned short>(label) : value;
    }
    return area;
  }

  /** Extends labels along the crests, which are longer than the parts found by the graph cut. */
  void
  LengthenLabels(HaustralFolds & folds) const
  {
    for (std::size_t i = 0; i < folds.folds.size(); ++i)
    {
      HaustralFold & fold = folds.folds[i];
      fold.area += this->Paint(PixelsAlongCrest(m_Picture, m_Found[i].crest), fold.label, folds.labels);
    }
  }

  const FlatColonGrid &        m_Grid;
  const HaustralFoldSettings & m_Options;
  FoldPicture                  m_Picture;
  FoldSplittingRule            m_Rule;
  CurvatureMixture             m_Mixture{};
  std::vector<MeasuredFold>    m_Found;
};

/** Sets the hindrances of the folds from the array notAssessable, if present. */
void
NoteHindrances(const FlatColon & flat, std::vector<HaustralFold> & folds)
{
  const SurfaceArray * const hindrances = FindSurfaceArray(flat.Surface().cellArrays, "notAssessable");
  for (HaustralFold & fold : folds)
  {
    const FlatPixel pixel = flat.Grid().PixelOfUv(fold.centerUv);
    const int       face = flat.Grid().FaceOfPixel(pixel.column, pixel.row);
    if (hindrances != nullptr && face >= 0)
    {
      fold.hindrance = HindranceOfValue(hindrances->values(face, 0));
    }
  }
}
} // namespace

HaustralFolds
FindHaustralFolds(const FlatColon & flat, const HaustralFoldSettings & options)
{
  RequireValid(options);
  options.progress(0.0);
  HaustralFolds folds = FoldFinder(flat, options).Find();
  NoteHindrances(flat, folds.folds);
  options.progress(1.0);
  return folds;
}
} // namespace shapeton
