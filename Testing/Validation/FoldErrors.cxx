#include "FoldErrors.h"
#include "Tables.h"

#include "shapetonCsvTable.h"
#include "shapetonFlatColonLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

using namespace shapeton;

namespace
{
constexpr double leastHeight = 3.5;
constexpr double leastLowHeight = 2.0;
constexpr double crestAboveWall = 1.0;
constexpr double seenWithin = 3.0;
constexpr double labelWithin = 2.0;
constexpr double rightWithin = 4.0;
constexpr double leastHeightOfRight = 1.5;

double
CellValue(const CurveSet & curves, const std::string & name, std::size_t curve)
{
  return FindSurfaceArray(curves.cellArrays, name)->values(static_cast<Eigen::Index>(curve), 0);
}

/** A true fold and the labels that cover it. */
struct TrueFold
{
  int                          number{ 0 };
  double                       height{ 0.0 };
  double                       length{ 0.0 };
  double                       arcLength{ 0.0 };
  std::vector<Eigen::Vector3d> crest; ///< samples where the fold protrudes from the wall
  Eigen::Vector3d              ends[2];
  int                          seen{ 0 };
  std::map<int, int>           samplesOfLabel;
  int                          ownLabel{ 0 };

  bool
  IsHidden() const
  {
    return 2 * seen < static_cast<int>(crest.size()) || crest.empty();
  }
  int
  SamplesOf(int label) const
  {
    const auto one = samplesOfLabel.find(label);
    return one == samplesOfLabel.end() ? 0 : one->second;
  }
  bool
  IsHalfCoveredBy(int label) const
  {
    return label > 0 && 2 * this->SamplesOf(label) >= seen;
  }
  int
  BestLabel() const
  {
    int best = 0;
    for (const auto & [label, samples] : samplesOfLabel)
    {
      best = samples > this->SamplesOf(best) ? label : best;
    }
    return best;
  }
};

class Comparison
{
public:
  Comparison(const FlatColonGrid & grid, const HaustralFolds & found, const CurveSet & truth)
    : m_Grid(grid), m_Found(found), m_Locator(grid)
  {
    for (std::size_t i = 0; i < truth.curves.size(); ++i)
    {
      m_Folds.push_back(this->ReadFold(truth, i));
    }
    this->GiveLabels();
  }

  FoldErrors
  Measure(const CurveSet & wall) const
  {
    FoldErrors errors;
    this->CountFolds(errors);
    this->CountLabels(errors);
    this->CountArea(wall, errors);
    return errors;
  }

private:
  int
  LabelAt(int column, int row) const
  {
    const int wrapped = (row % m_Grid.Rows() + m_Grid.Rows()) % m_Grid.Rows();
    return m_Found.labels->GetBufferPointer()[static_cast<std::size_t>(wrapped) * m_Grid.Columns() + column];
  }

  TrueFold
  ReadFold(const CurveSet & truth, std::size_t i) const
  {
    const SurfaceArray & crestHeight = *FindSurfaceArray(truth.pointArrays, "crestHeight");
    TrueFold             fold;
    fold.number = static_cast<int>(CellValue(truth, "fold", i));
    fold.height = CellValue(truth, "height", i);
    fold.arcLength = CellValue(truth, "arcLength", i);
    const std::vector<int> & curve = truth.curves[i];
    fold.ends[0] = truth.V.row(curve.front());
    fold.ends[1] = truth.V.row(curve.back());
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      fold.length += k > 0 ? (truth.V.row(curve[k]) - truth.V.row(curve[k - 1])).norm() : 0.0;
      if (crestHeight.values(curve[k], 0) >= crestAboveWall)
      {
        fold.crest.push_back(truth.V.row(curve[k]));
        this->AddSample(fold.crest.back(), fold);
      }
    }
    return fold;
  }

  void
  AddSample(const Eigen::Vector3d & point, TrueFold & fold) const
  {
    const FlatPlace place = m_Locator.Find(point);
    if (place.distance > seenWithin || m_Grid.IsBridged(place.pixel.column, place.pixel.row))
    {
      return;
    }
    ++fold.seen;
    const FlatSample sample = m_Grid.SampleOfPixel(place.pixel.column, place.pixel.row);
    const double     scale = sample.face >= 0 && sample.scale > 0.1 ? sample.scale : 1.0;
    const double     radius = labelWithin / scale / m_Grid.PixelSize();
    const int        reach = static_cast<int>(radius);
    std::vector<int> labels;
    for (int dy = -reach; dy <= reach; ++dy)
    {
      for (int dx = -reach; dx <= reach; ++dx)
      {
        const int column = place.pixel.column + dx;
        if (dx * dx + dy * dy <= radius * radius && column >= 0 && column < m_Grid.Columns())
        {
          labels.push_back(this->LabelAt(column, place.pixel.row + dy));
        }
      }
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    for (const int label : labels)
    {
      fold.samplesOfLabel[label] += label > 0;
    }
  }

  void
  GiveLabels()
  {
    for (const HaustralFold & label : m_Found.folds)
    {
      TrueFold * best = nullptr;
      for (TrueFold & fold : m_Folds)
      {
        if (fold.height >= leastLowHeight && !fold.IsHidden() && fold.IsHalfCoveredBy(label.label) &&
            (!best || fold.SamplesOf(label.label) > best->SamplesOf(label.label)))
        {
          best = &fold;
        }
      }
      if (best && best->SamplesOf(label.label) > best->SamplesOf(best->ownLabel))
      {
        best->ownLabel = label.label;
      }
    }
  }

  void
  CountFolds(FoldErrors & errors) const
  {
    for (const TrueFold & fold : m_Folds)
    {
      if (fold.height < leastLowHeight)
      {
        continue;
      }
      const bool isHigh = fold.height >= leastHeight;
      if (fold.IsHidden())
      {
        errors.hidden += isHigh;
        continue;
      }
      const bool isFound = fold.ownLabel > 0;
      errors.present += isHigh;
      errors.found += isHigh && isFound;
      errors.covered += isHigh && fold.IsHalfCoveredBy(fold.BestLabel());
      errors.lowPresent += !isHigh;
      errors.lowFound += !isHigh && isFound;
      if (isHigh && isFound)
      {
        this->CompareShapes(fold, errors);
      }
      else if (isHigh)
      {
        errors.faults.push_back(
          "fold " + std::to_string(fold.number) + " not found, " + Rounded(fold.height) + " mm high, " +
          Rounded(fold.length) + " mm long, at " + Rounded(fold.arcLength, 4) + " mm; " +
          (fold.IsHalfCoveredBy(fold.BestLabel()) ? "merged into label " : "at most covered by label ") +
          std::to_string(fold.BestLabel()) + ", " + std::to_string(fold.SamplesOf(fold.BestLabel())) + " of " +
          std::to_string(fold.seen));
      }
    }
  }

  void
  CompareShapes(const TrueFold & fold, FoldErrors & errors) const
  {
    const HaustralFold & own = m_Found.folds[fold.ownLabel - 1];
    double               straight[2];
    double               crossed[2];
    for (int k = 0; k < 2; ++k)
    {
      straight[k] = (own.ends[k] - fold.ends[k]).norm();
      crossed[k] = (own.ends[1 - k] - fold.ends[k]).norm();
    }
    const double * const best = straight[0] + straight[1] <= crossed[0] + crossed[1] ? straight : crossed;
    errors.ends.insert(errors.ends.end(), best, best + 2);
    errors.lengthRatios.push_back(own.length / fold.length);
    if (std::isfinite(own.height))
    {
      errors.heightErrors.push_back(own.height - fold.height);
    }
  }

  /** Folds farther away than their length are skipped. */
  bool
  IsNearCrest(const Eigen::Vector3d & point) const
  {
    for (const TrueFold & fold : m_Folds)
    {
      if (fold.height < leastHeightOfRight || fold.crest.empty() ||
          (fold.crest[fold.crest.size() / 2] - point).norm() > fold.length + rightWithin)
      {
        continue;
      }
      for (std::size_t k = 0; k + 1 < fold.crest.size(); ++k)
      {
        if ((ClosestPointOfTriangle(point, fold.crest[k], fold.crest[k + 1], fold.crest[k + 1]) - point).norm() <=
            rightWithin)
        {
          return true;
        }
      }
    }
    return false;
  }

  void
  CountLabels(FoldErrors & errors) const
  {
    std::vector<int> pixels(m_Found.folds.size() + 1, 0);
    std::vector<int> near(m_Found.folds.size() + 1, 0);
    for (int row = 0; row < m_Grid.Rows(); ++row)
    {
      for (int column = 0; column < m_Grid.Columns(); ++column)
      {
        const int label = this->LabelAt(column, row);
        pixels[label] += label > 0;
        near[label] += label > 0 && this->IsNearCrest(m_Grid.PointOfPixel(column, row));
      }
    }
    for (const HaustralFold & fold : m_Found.folds)
    {
      ++errors.labels;
      const bool isRight = 2 * near[fold.label] >= pixels[fold.label];
      errors.right += isRight;
      int half = 0;
      for (const TrueFold & one : m_Folds)
      {
        half += one.height >= leastLowHeight && !one.IsHidden() && one.IsHalfCoveredBy(fold.label);
      }
      errors.merged += half > 1;
      if (!isRight)
      {
        errors.faults.push_back("label " + std::to_string(fold.label) + " is not a fold: " + Rounded(fold.length) +
                                " mm long, " + Rounded(fold.area) + " mm^2, curvature " + Rounded(fold.meanCurvature) +
                                ", elongation " + Rounded(fold.elongation) + ", at " + Rounded(fold.centerUv.x(), 4) +
                                " mm of the map");
      }
    }
  }

  void
  CountArea(const CurveSet & wall, FoldErrors & errors) const
  {
    const Eigen::VectorXd onFold = PointValues(wall, "onFold", "the truth");
    for (Eigen::Index i = 0; i < wall.V.rows(); ++i)
    {
      const FlatPlace place = m_Locator.Find(wall.V.row(i));
      if (place.distance <= seenWithin && !m_Grid.IsBridged(place.pixel.column, place.pixel.row))
      {
        const bool isLabeled = this->LabelAt(place.pixel.column, place.pixel.row) > 0;
        errors.areaOfBoth += onFold[i] != 0.0 && isLabeled;
        errors.areaOfEither += onFold[i] != 0.0 || isLabeled;
      }
    }
  }

  const FlatColonGrid & m_Grid;
  const HaustralFolds & m_Found;
  FlatColonLocator      m_Locator;
  std::vector<TrueFold> m_Folds;
};
} // namespace

void
FoldErrors::Add(const FoldErrors & other)
{
  present += other.present;
  found += other.found;
  covered += other.covered;
  lowPresent += other.lowPresent;
  lowFound += other.lowFound;
  hidden += other.hidden;
  labels += other.labels;
  right += other.right;
  merged += other.merged;
  Append(other.ends, ends);
  Append(other.lengthRatios, lengthRatios);
  Append(other.heightErrors, heightErrors);
  areaOfBoth += other.areaOfBoth;
  areaOfEither += other.areaOfEither;
  Append(other.faults, faults);
}

FoldErrors
MeasureFoldErrors(const FlatColonGrid & grid,
                  const HaustralFolds & found,
                  const CurveSet &      truth,
                  const CurveSet &      wall)
{
  return Comparison(grid, found, truth).Measure(wall);
}
