// Fits the weights of score and probability in Filtering/HeatObjects and prints them; takes ten minutes. usage:
// FitHeatObjects, with SHAPETON_TEST_DATA_DIR. Uses the tuning half of ObjectVolumes() with 99 random scenes.
//
// Score: conditional logit of the candidates around 12 random points of each visible part; right are those with a Dice
// of 0.8, or the best one. All volumes have the same importance, scans three times that. Probability: logistic
// regression of the candidates with a greater score than all that contain them; right are whole objects. Volumes
// without visible parts, such as the ankles, whose reference joins bones, are left out.
#include "ConditionalLogit.h"
#include "LogisticRegression.h"
#include "ObjectMeasures.h"
#include "ObjectVolumes.h"
#include "Tables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <map>

using namespace shapeton;

namespace
{
using Index = PartitionTree::Index;

constexpr Eigen::Index scoreTerms = 6; ///< the first ones of HeatObject::terms
constexpr int          none = -1;

struct FitCandidate
{
  Index      region{ 0 };
  HeatObject object;
  int        parent{ none };  ///< the smallest candidate that contains it
  double     dice{ 0.0 };     ///< with the part it fits best
  bool       isKnown{ true }; ///< the reference labels decide whether it is an object
};

/** What is used of a volume. */
struct FitVolume
{
  std::string               kind;
  std::vector<FitCandidate> candidates;
  std::vector<ChoiceSet>    sets;       ///< one per point, if a candidate is near to the part
  std::vector<ChoiceSet>    strictSets; ///< the same; right are whole objects only
  int                       points{ 0 };

  double
  Importance() const
  {
    return kind == "scan" ? 3.0 : 1.0;
  }
};

Eigen::VectorXd
TermsOf(const HeatObject & object, Eigen::Index number)
{
  return Eigen::Map<const Eigen::VectorXd>(object.terms.data(), number);
}

/** Whether most of a region belongs to one part, or the region has most of a part. Scans have objects without label. */
bool
IsKnown(const ReferenceParts & parts, const double * counts, double size)
{
  return std::any_of(parts.GetLabels().begin(), parts.GetLabels().end(), [&](int part) {
    return counts[part] >= 0.5 * size || counts[part] >= 0.5 * parts.GetTotals()[part];
  });
}

class VolumeReader
{
public:
  explicit VolumeReader(const ObjectVolumeSource & source)
    : m_Volume(source.make())
    , m_Parts(m_Volume.labels)
    , m_Tree(AutomaticHeat(m_Volume.image))
    , m_Counts(CountsOfRegions(m_Tree.GetTree(), m_Parts))
    , m_CandidateOf(m_Tree.GetTree().GetRegions().size(), none)
  {
    m_Result.kind = source.kind;
  }

  FitVolume
  Read()
  {
    this->AddCandidates();
    for (const int part : m_Parts.GetLabels())
    {
      this->AddSets(part);
    }
    return m_Result;
  }

private:
  double
  DiceOf(int part, Index region) const
  {
    return m_Parts.Dice(part, this->CountsOf(region), this->SizeOf(region));
  }

  const double *
  CountsOf(Index region) const
  {
    return &m_Counts[region * m_Parts.GetTotals().size()];
  }

  double
  SizeOf(Index region) const
  {
    return m_Tree.GetTree().GetRegions()[region].NumberOfVoxels();
  }

  void
  AddCandidates()
  {
    for (const HeatObjectCandidate & candidate : m_Tree.GetCandidates())
    {
      const Index          region = candidate.region;
      const double * const counts = this->CountsOf(region);
      const double         size = this->SizeOf(region);
      m_CandidateOf[region] = static_cast<int>(m_Result.candidates.size());
      m_Result.candidates.push_back({ region,
                                      candidate.object,
                                      none,
                                      m_Parts.BestDice(counts, size),
                                      m_Result.kind != "scan" || IsKnown(m_Parts, counts, size) });
    }
    const auto & regions = m_Tree.GetTree().GetRegions();
    for (auto region = static_cast<Index>(regions.size()); region-- > 0;)
    {
      int &     candidate = m_CandidateOf[region];
      const int around = m_CandidateOf[regions[region].parent];
      if (candidate == none)
      {
        candidate = around;
      }
      else
      {
        m_Result.candidates[candidate].parent = around;
      }
    }
  }

  void
  AddSets(int part)
  {
    constexpr int points = 12;
    double        best = 0.0;
    for (Index region = 0; region < m_CandidateOf.size(); ++region)
    {
      best = std::max(best, this->DiceOf(part, region));
    }
    if (best >= wholeObject)
    {
      m_Result.points += points;
      for (const std::size_t voxel : PointsIn(part, m_Parts.DepthsOf(part), points))
      {
        this->AddSet(part, m_CandidateOf[m_Tree.GetTree().GetBasinOfVoxel()[voxel]]);
      }
    }
  }

  void
  AddSet(int part, int candidate)
  {
    constexpr double    right = 0.8; // Dice
    constexpr double    least = 0.5; // Dice of the best one
    ChoiceSet           set;
    std::vector<double> dice;
    for (; candidate != none; candidate = m_Result.candidates[candidate].parent)
    {
      set.terms.push_back(TermsOf(m_Result.candidates[candidate].object, scoreTerms));
      dice.push_back(this->DiceOf(part, m_Result.candidates[candidate].region));
    }
    const double best = dice.empty() ? 0.0 : *std::max_element(dice.begin(), dice.end());
    const auto   withRight = [&](double limit) {
      set.isRight.clear();
      std::transform(dice.begin(), dice.end(), std::back_inserter(set.isRight), [&](double d) { return d >= limit; });
      return set;
    };
    if (best >= least)
    {
      m_Result.sets.push_back(withRight(std::min(right, best)));
      m_Result.strictSets.push_back(withRight(wholeObject));
    }
  }

  ObjectVolume        m_Volume;
  ReferenceParts      m_Parts;
  HeatObjectTree      m_Tree;
  std::vector<double> m_Counts;      ///< by label, of each region
  std::vector<int>    m_CandidateOf; ///< the smallest candidate that contains each region
  FitVolume           m_Result;
};

/** Score weights from all volumes but every `folds`-th one, starting at `fold`; from all if that is `folds`. */
Eigen::VectorXd
FitScore(const std::vector<FitVolume> & volumes, std::size_t fold, std::size_t folds)
{
  constexpr double       penalty = 1e-4;
  std::vector<ChoiceSet> sets;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    for (ChoiceSet set : volumes[i].sets)
    {
      if (i % folds != fold)
      {
        set.importance = volumes[i].Importance() / static_cast<double>(volumes[i].sets.size());
        sets.push_back(set);
      }
    }
  }
  return FitConditionalLogit(sets, penalty);
}

/** Fraction of the points of a volume for which the candidate with the greatest score is whole. */
double
FirstClick(const FitVolume & volume, const Eigen::VectorXd & weights)
{
  const auto right = std::count_if(volume.strictSets.begin(), volume.strictSets.end(), [&](const ChoiceSet & set) {
    return set.isRight[set.Best(weights)] != 0;
  });
  return ShareOf(static_cast<int>(right), volume.points);
}

/** Prints the mean first click of each kind of volume, by weights fitted on other volumes. */
void
PrintCrossValidation(const std::vector<FitVolume> & volumes)
{
  constexpr std::size_t                      folds = 4;
  std::map<std::string, std::vector<double>> clicks;
  for (std::size_t fold = 0; fold < folds; ++fold)
  {
    const Eigen::VectorXd weights = FitScore(volumes, fold, folds);
    for (std::size_t i = fold; i < volumes.size(); i += folds)
    {
      if (volumes[i].points > 0)
      {
        clicks[volumes[i].kind].push_back(FirstClick(volumes[i], weights));
      }
    }
  }
  for (const auto & [kind, values] : clicks)
  {
    std::cout << "first click, " << kind << ": " << Rounded(MeanOf(values)) << " (" << values.size() << " volumes)\n";
  }
}

/** The known candidates with a greater score than all that contain them. */
std::vector<FitCandidate>
Meant(const FitVolume & volume, const Eigen::VectorXd & weights)
{
  std::vector<double>       best(volume.candidates.size()); // score of a candidate and those that contain it
  std::vector<FitCandidate> meant;
  for (std::size_t i = 0; i < volume.candidates.size(); ++i)
  {
    const FitCandidate & candidate = volume.candidates[i];
    const double around = candidate.parent == none ? -std::numeric_limits<double>::infinity() : best[candidate.parent];
    const double score = weights.dot(TermsOf(candidate.object, scoreTerms));
    best[i] = std::max(score, around);
    if (score > around && candidate.isKnown)
    {
      meant.push_back(candidate);
    }
  }
  return meant;
}

/** Weights of all terms and the constant. */
Eigen::VectorXd
FitProbability(const std::vector<FitVolume> & volumes, const Eigen::VectorXd & scoreWeights)
{
  constexpr double       penalty = 0.01; // of each weight; the samples are thousands
  constexpr Eigen::Index terms = HeatObjectTerms;
  LogisticSamples        samples;
  for (const FitVolume & volume : volumes)
  {
    for (const FitCandidate & candidate : volume.points > 0 ? Meant(volume, scoreWeights) : std::vector<FitCandidate>())
    {
      Eigen::VectorXd withConstant(terms + 1);
      withConstant << TermsOf(candidate.object, terms), 1.0;
      samples.Add(withConstant, candidate.dice >= wholeObject);
    }
  }
  Eigen::VectorXd penalties = Eigen::VectorXd::Constant(terms + 1, penalty);
  penalties[terms] = 0.0; // the constant
  return FitLogistic(samples, penalties);
}
} // namespace

int
main()
{
  constexpr unsigned int scenes = 99;
  const char * const     dataFolder = std::getenv("SHAPETON_TEST_DATA_DIR");
  if (!dataFolder)
  {
    std::cerr << "FitHeatObjects: SHAPETON_TEST_DATA_DIR is not set" << std::endl;
    return 2;
  }
  std::vector<FitVolume> volumes;
  for (const ObjectVolumeSource & source : ObjectVolumes(scenes, dataFolder))
  {
    if (!source.isHeldBack)
    {
      std::cerr << source.name << std::endl;
      volumes.push_back(VolumeReader(source).Read());
    }
  }
  const Eigen::IOFormat list(4, Eigen::DontAlignCols, ", ", ", ");
  const Eigen::VectorXd scoreWeights = FitScore(volumes, 1, 1);
  PrintCrossValidation(volumes);
  std::cout << "score: " << scoreWeights.transpose().format(list) << '\n'
            << "probability, and constant: " << FitProbability(volumes, scoreWeights).transpose().format(list)
            << std::endl;
}
