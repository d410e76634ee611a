#ifndef shapetonColonAnatomyData_h
#define shapetonColonAnatomyData_h

#include "shapetonColonAnatomy.h"
#include "shapetonColonField.h"

namespace shapeton
{
/** The patient at rest, and the colon in the position. */
struct ColonAnatomy::Data
{
  explicit Data(const ColonPhantomParameters & given);

  ColonPhantomParameters parameters;
  ColonPath              rest;
  ColonPlan              plan;
  ColonField             field;
};
} // namespace shapeton

#endif
