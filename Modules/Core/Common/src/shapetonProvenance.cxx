#include "shapetonProvenance.h"

namespace shapeton
{
Provenance
ProvenanceMetadata(const Provenance & provenance)
{
  Provenance metadata;
  for (const auto & [name, value] : provenance)
  {
    metadata.emplace_back("Shapeton." + name, value);
  }
  return metadata;
}

std::string
ProvenanceComment(const Provenance & provenance)
{
  std::string comment;
  for (const auto & [name, value] : provenance)
  {
    comment += (comment.empty() ? "" : "; ") + name + '=' + value;
  }
  return comment;
}
} // namespace shapeton
