#include "ObjectMeasures.h"
#include "ObjectPeers.h"
#include "ObjectVolumes.h"
#include "Overlaps.h"
#include "Reliability.h"
#include "Tables.h"
#include "ValidationReport.h"

#include <algorithm>
#include <map>

using namespace shapeton;

namespace
{
const char *
HalfOf(bool isHeldBack)
{
  return isHeldBack ? "held back" : "tuning";
}

/** Measures of the parts of one volume. */
struct MeasuredVolume
{
  std::string               name;
  std::string               kind;
  bool                      isHeldBack{ false };
  std::vector<PartMeasures> parts;
  std::vector<ObjectPeer>   peers;
};

using PartValue = double PartMeasures::*;

/** Mean over volumes of the mean over their parts, or their visible parts. */
double
MeanOverVolumes(const std::vector<MeasuredVolume> & volumes, PartValue value, bool onlyVisible)
{
  std::vector<double> means;
  for (const MeasuredVolume & volume : volumes)
  {
    std::vector<double> values;
    for (const PartMeasures & part : volume.parts)
    {
      if (part.IsVisible() || !onlyVisible)
      {
        values.push_back(part.*value);
      }
    }
    if (!values.empty())
    {
      means.push_back(MeanOf(values));
    }
  }
  return MeanOf(means);
}

/** The volumes of a half and kind; those of all kinds if it is "all". */
std::vector<MeasuredVolume>
VolumesOf(const std::vector<MeasuredVolume> & all, bool isHeldBack, const std::string & kind)
{
  std::vector<MeasuredVolume> volumes;
  std::copy_if(all.begin(), all.end(), std::back_inserter(volumes), [&](const MeasuredVolume & volume) {
    return volume.isHeldBack == isHeldBack && (kind == "all" || volume.kind == kind);
  });
  return volumes;
}

const std::vector<std::string> kinds = { "scene", "phantom", "scan", "all" };

/** Means of the clicks; the goals are for the held-back half. */
void
AddClicks(const std::vector<MeasuredVolume> & all, ValidationReport & report)
{
  constexpr double leastFirst = 0.80;
  constexpr double leastSame = 0.97;
  CsvTable         table(
    Columns("half | kind | volumes | parts | visible | first click | best climb | same object | first click, all parts "
                    "| first click >= 0.80 | same object >= 0.97"));
  for (const bool isHeldBack : { false, true })
  {
    for (const std::string & kind : kinds)
    {
      const auto volumes = VolumesOf(all, isHeldBack, kind);
      int        parts = 0;
      int        visible = 0;
      for (const MeasuredVolume & volume : volumes)
      {
        parts += static_cast<int>(volume.parts.size());
        visible += static_cast<int>(
          std::count_if(volume.parts.begin(), volume.parts.end(), [](const auto & part) { return part.IsVisible(); }));
      }
      if (parts == 0)
      {
        continue;
      }
      const double first = MeanOverVolumes(volumes, &PartMeasures::firstClick, true);
      const double same = MeanOverVolumes(volumes, &PartMeasures::sameObject, true);
      table.AddRow(Cells() << HalfOf(isHeldBack) << kind << volumes.size() << parts << visible << Rounded(first)
                           << Rounded(MeanOverVolumes(volumes, &PartMeasures::bestClimb, true)) << Rounded(same)
                           << Rounded(MeanOverVolumes(volumes, &PartMeasures::firstClick, false))
                           << (isHeldBack ? report.Check(first >= leastFirst) : "")
                           << (isHeldBack ? report.Check(same >= leastSame) : ""));
    }
  }
  report.AddTable(table);
}

/** Mean Dice of the best regions of the tree and of the other methods. */
void
AddPeers(const std::vector<MeasuredVolume> & all, ValidationReport & report)
{
  std::vector<std::string> columns{ "half", "kind", "tree" };
  for (const ObjectPeer & peer : all.front().peers)
  {
    columns.push_back(peer.name);
  }
  CsvTable table(columns);
  for (const bool isHeldBack : { false, true })
  {
    for (const std::string & kind : kinds)
    {
      std::vector<std::vector<double>> dice(columns.size() - 2); // by method, of each part
      for (const MeasuredVolume & volume : VolumesOf(all, isHeldBack, kind))
      {
        for (std::size_t part = 0; part < volume.parts.size(); ++part)
        {
          dice[0].push_back(volume.parts[part].bestRegion);
          for (std::size_t peer = 0; peer < volume.peers.size(); ++peer)
          {
            dice[peer + 1].push_back(volume.peers[peer].dice[part]);
          }
        }
      }
      if (!dice[0].empty())
      {
        std::vector<std::string> row{ HalfOf(isHeldBack), kind };
        std::transform(dice.begin(), dice.end(), std::back_inserter(row), [](const auto & values) {
          return Rounded(MeanOf(values));
        });
        table.AddRow(row);
      }
    }
  }
  report.AddTable(table);
}

/** One row per part. */
void
AddParts(const std::vector<MeasuredVolume> & all, ValidationReport & report)
{
  auto columns =
    Columns("half | volume | part | tree | first click | best climb | same object | Dice of a click at the "
            "deepest voxel");
  for (const ObjectPeer & peer : all.front().peers)
  {
    columns.push_back(peer.name);
  }
  CsvTable table(columns);
  for (const MeasuredVolume & volume : all)
  {
    for (std::size_t i = 0; i < volume.parts.size(); ++i)
    {
      const PartMeasures & part = volume.parts[i];
      auto row = Cells() << HalfOf(volume.isHeldBack) << volume.name << part.part << Rounded(part.bestRegion)
                         << Rounded(part.firstClick) << Rounded(part.bestClimb) << Rounded(part.sameObject)
                         << Rounded(part.deepestClick);
      for (const ObjectPeer & peer : volume.peers)
      {
        row << Rounded(peer.dice[i]);
      }
      table.AddRow(row);
    }
  }
  report.AddRows("parts", table);
}

/** Adjusted Rand index of labels and smallest objects over the voxels of labels. */
double
RandIndex(const HeatObjectList & list, const ReferenceParts::Labels * labels)
{
  Overlaps overlaps = OverlapsOf(
    labels->GetBufferPointer(), list.labels->GetBufferPointer(), labels->GetBufferedRegion().GetNumberOfPixels());
  overlaps.erase(0);
  return AdjustedRandIndex(overlaps);
}

/** \class ObjectTables
 * \brief Measures volumes and adds the tables to the report. */
class ObjectTables
{
public:
  /** The random walker is slow, so only some of the held-back scenes are for it. */
  ObjectTables(int walkerScenes, ValidationReport & report) : m_WalkerScenes(walkerScenes), m_Report(report) {}

  void
  Measure(const ObjectVolumeSource & source)
  {
    const ObjectVolume   volume = source.make();
    const ReferenceParts parts(volume.labels);
    const auto           heat = AutomaticHeat(volume.image);
    const HeatObjectTree tree(heat);
    MeasuredVolume       measured{ source.name, source.kind, source.isHeldBack, MeasureParts(tree, parts), {} };
    measured.peers = MeasurePeers(volume.image, heat, parts);
    if (source.kind == "phantom")
    {
      this->AddPhantom(source.name, volume, tree.List(), parts);
    }
    if (source.kind == "scene" && source.isHeldBack)
    {
      this->AddScene(heat, volume, tree.List(), parts);
    }
    if (m_WalkerScenes > 0 && source.kind == "scene" && source.isHeldBack)
    {
      --m_WalkerScenes;
      Append(DiceOfRandomWalker(volume.image, parts), m_DiceOfWalker);
    }
    for (const PartMeasures & part : measured.parts)
    {
      ValidationReport::Progress(source.name + ", part " + std::to_string(part.part) + ": tree " +
                                 Rounded(part.bestRegion) + ", first click " + Rounded(part.firstClick) +
                                 ", best climb " + Rounded(part.bestClimb) + ", same " + Rounded(part.sameObject));
    }
    m_Volumes.push_back(measured);
  }

  void
  Write()
  {
    m_Report.AddText("Adjusted Rand index of the labels of phantoms:");
    m_Report.AddTable(m_Phantoms);
    m_Report.AddText("Held-back scenes: " + std::to_string(m_Whole) + " of " + std::to_string(m_Listed) +
                     " listed objects are whole. Adjusted Rand index " + MeanWithInterval(m_RandOfScenes) + '.');
    m_Reliability.Write("regions", m_Report);
    m_Report.AddText("Brier score " + Rounded(m_Reliability.BrierScore()) + ", calibration error " +
                     Rounded(m_Reliability.CalibrationError()) +
                     " (bound 0.1): " + m_Report.Check(m_Reliability.CalibrationError() <= 0.1));
    m_Report.AddText("Clicks; means over volumes of the means over visible parts:");
    AddClicks(m_Volumes, m_Report);
    m_Report.AddText("Mean Dice of the region or node that fits each part best:");
    AddPeers(m_Volumes, m_Report);
    if (!m_DiceOfWalker.empty())
    {
      m_Report.AddText("Random walker, one seed per part, " + std::to_string(m_DiceOfWalker.size()) +
                       " parts of the first held-back scenes: mean Dice " + Rounded(MeanOf(m_DiceOfWalker)) + '.');
    }
    AddParts(m_Volumes, m_Report);
    this->CheckFoot();
  }

private:
  void
  AddPhantom(const std::string &    name,
             const ObjectVolume &   volume,
             const HeatObjectList & list,
             const ReferenceParts & parts)
  {
    const double rand = RandIndex(list, volume.labels);
    const bool   isOne = parts.GetLabels().size() == 1; // no partition
    m_Phantoms.AddRow(Cells() << name << parts.GetLabels().size() << list.objects.size() << (isOne ? "" : Rounded(rand))
                              << (isOne ? "" : m_Report.Check(rand >= 0.95)));
  }

  /** Compares stated probabilities with the truth. */
  void
  AddScene(const itk::Image<float, 3> * heat,
           const ObjectVolume &         volume,
           const HeatObjectList &       list,
           const ReferenceParts &       parts)
  {
    HeatObjectOptions options;
    const double      least = options.leastProbability;
    options.leastProbability = 0.0;
    const auto all = FindHeatObjects(heat, options);
    for (std::size_t i = 0; i < all.objects.size(); ++i)
    {
      const HeatObject & object = all.objects[i];
      const bool         isWhole = parts.BestDice(CountsIn(all.ranges[i], parts).data(), object.voxels) >= wholeObject;
      m_Reliability.Add(object.probability, isWhole);
      m_Listed += object.probability >= least ? 1 : 0;
      m_Whole += object.probability >= least && isWhole ? 1 : 0;
    }
    m_RandOfScenes.push_back(RandIndex(list, volume.labels));
  }

  void
  CheckFoot()
  {
    constexpr int least = 10;
    const auto    foot = std::find_if(
      m_Volumes.begin(), m_Volumes.end(), [](const MeasuredVolume & volume) { return volume.name == "foot"; });
    if (foot != m_Volumes.end())
    {
      const auto right = std::count_if(foot->parts.begin(), foot->parts.end(), [](const PartMeasures & part) {
        return part.deepestClick >= wholeObject;
      });
      m_Report.AddText("Foot: " + std::to_string(right) + " of " + std::to_string(foot->parts.size()) +
                       " bones by one click at the deepest voxel (bound 10): " + m_Report.Check(right >= least));
    }
  }

  int                         m_WalkerScenes;
  ValidationReport &          m_Report;
  std::vector<MeasuredVolume> m_Volumes;
  CsvTable                    m_Phantoms{ Columns("phantom | objects | listed | adjusted Rand index | >= 0.95") };
  Reliability                 m_Reliability;
  std::vector<double>         m_RandOfScenes;
  std::vector<double>         m_DiceOfWalker;
  int                         m_Listed{ 0 }; ///< of held-back scenes
  int                         m_Whole{ 0 };
};
} // namespace

void
ValidateObjectsOfVolumes(const ValidationSettings & settings, ValidationReport & report)
{
  report.AddText(
    "`CumulativeHeatDiffusion`, then `HeatObjects`, both without options. A part is a reference label of 300 voxels up "
    "to a quarter of the volume; parts that enclose others count with or without them. An object is whole if its Dice "
    "with a part is at least 0.85. Visible: the tree has a whole region. Clicks: 200 random points per part, two "
    "voxels inside; on a point in no object, a click selects the offered region. FitHeatObjects uses the tuning half. "
    "The weights in use were fitted to other scenes, these phantoms, and scans among which are foot, tooth, lobster "
    "and CTs; only the scenes are new to them.");
  const bool   isQuick = settings.quick;
  ObjectTables tables(isQuick ? 0 : 2, report);
  for (const ObjectVolumeSource & source : ObjectVolumes(isQuick ? 2 : 12, isQuick ? "" : settings.dataFolder))
  {
    if (!isQuick || source.kind == "scene" || source.name == "figure2.7a")
    {
      tables.Measure(source);
    }
  }
  tables.Write();
}
