#ifndef shapetonTaeniaMarkers_h
#define shapetonTaeniaMarkers_h

#include "shapetonColonTaeniae.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonTaeniaEvidence.h"

namespace shapeton
{
/** A marker's place, and the track that passes it. */
struct TaeniaPass
{
  TaeniaMark      mark;
  FlatPlace       place;
  int             track{ 0 };
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
};

/** Adds a mark to the evidence for each marker. Throws InputError for one that lies far from the wall. */
std::vector<TaeniaPass>
LocateMarkers(const std::vector<Eigen::Vector3d> & markers,
              const FlatColonGrid &                grid,
              const FlatColonLocator &             locator,
              TaeniaEvidence &                     evidence,
              std::vector<UsedMarker> &            used);

/** Gives each marker the nearest track and moves the tracks so that they pass through theirs. */
void
PassThroughMarkers(const TaeniaEvidence & evidence, std::vector<TaeniaPass> & passes, TaeniaTracks & tracks);

/** Puts the markers' own places into the taeniae, and says what was used. */
void
InsertMarkers(const std::vector<TaeniaPass> & passes, ColonTaeniae & taeniae);
} // namespace shapeton

#endif
