#ifndef shapetonColonPath_h
#define shapetonColonPath_h

#include "shapetonColonPhantomParameters.h"

#include <Eigen/Core>

#include <vector>

namespace shapeton
{
/** The colon as a chain of nodes, about 10 mm apart, from the anal verge to the cecum. Material coordinates are lengths
 * along the chain at rest. */
struct ColonPath
{
  std::vector<Eigen::Vector3d> nodes;
  std::vector<double>          material; ///< mm, of each node
  std::vector<int>             segment;  ///< 1 to 6, of each node
  /** A pair of nodes whose stretches touch. */
  struct Contact
  {
    int    first;
    int    second;
    double septum; ///< mm
  };
  std::vector<Contact> contacts;

  double
  Length() const
  {
    return material.back();
  }
};

/** The chain of a patient at rest: a template of the anatomy, stretched to the segment lengths. */
ColonPath
RestPath(const ColonPhantomParameters & parameters);

/** Radius in mm of the patient's distended colon at each of `count` equal steps of the material length. */
std::vector<double>
RestRadius(const ColonPath & path, const ColonPhantomParameters & parameters, int count);

/** The chain in a position: mobile stretches are displaced, and stretches are separated according to `radius` (one per
 * node), except at contacts. */
ColonPath
PositionedPath(const ColonPath & rest, const std::vector<double> & radius, const ColonPhantomParameters & parameters);

/** 1 for supine, 2 prone, 3 leftDecubitus, 4 rightDecubitus. */
unsigned
PositionNumber(const std::string & position);
} // namespace shapeton

#endif
