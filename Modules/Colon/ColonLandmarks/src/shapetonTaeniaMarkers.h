#ifndef shapetonTaeniaMarkers_h
#define shapetonTaeniaMarkers_h

#include "shapetonColonTaeniae.h"
#include "shapetonFlatColonLocator.h"
#include "shapetonTaeniaEvidence.h"

namespace shapeton
{
/** Position of a marker, and its track. */
struct TaeniaPass
{
  TaeniaMark      mark;
  FlatPlace       place;
  int             track{ 0 };
  Eigen::Vector3d point{ Eigen::Vector3d::Zero() };
};

/** Adds a mark to the evidence for each marker. Throws InputError for a marker far from the wall. */
std::vector<TaeniaPass>
LocateMarkers(const std::vector<Eigen::Vector3d> & markers,
              const FlatColonGrid &                grid,
              const FlatColonLocator &             locator,
              TaeniaEvidence &                     evidence,
              std::vector<UsedMarker> &            used);

/** Assigns each marker to the nearest track and moves the tracks through their markers. */
void
PassThroughMarkers(const TaeniaEvidence & evidence, std::vector<TaeniaPass> & passes, TaeniaTracks & tracks);

/** Inserts the exact marker positions into the taeniae, and records the markers used. */
void
InsertMarkers(const std::vector<TaeniaPass> & passes, ColonTaeniae & taeniae);
} // namespace shapeton

#endif
