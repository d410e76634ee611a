#include "shapetonExaminationPositions.h"

#include "shapetonPolypSearch.h"
#include "shapetonSha256.h"

#include <filesystem>

namespace shapeton
{
std::vector<std::string>
PositionFoldersOf(const std::string & exam, const std::string & second)
{
  std::vector<std::string> folders{ exam };
  if (!second.empty())
  {
    folders.push_back(second);
  }
  else if (std::filesystem::exists(exam + "/second/flattening/flat.vtp"))
  {
    folders.push_back(exam + "/second");
  }
  return folders;
}

std::string
DigestOfPositions(const std::vector<std::string> & folders)
{
  std::string digests;
  for (const auto & folder : folders)
  {
    for (const char * name : { "/flattening/flat.vtp", "/polyps/candidates.csv" })
    {
      digests += std::filesystem::exists(folder + name) ? Sha256OfFile(folder + name) : "missing";
    }
  }
  return Sha256OfBytes(digests);
}

std::vector<std::vector<PolypCandidate>>
CandidatesOfPositions(const std::vector<std::string> & folders)
{
  std::vector<std::vector<PolypCandidate>> candidates;
  for (const auto & folder : folders)
  {
    const std::string path = folder + "/polyps/candidates.csv";
    candidates.push_back(std::filesystem::exists(path) ? ReadPolypCandidates(path) : std::vector<PolypCandidate>());
  }
  return candidates;
}

std::string
NameOfCandidate(std::size_t position, int number)
{
  return (position == 0 ? "" : "second/") + std::to_string(number);
}

const PolypCandidate *
FindCandidate(const std::vector<std::vector<PolypCandidate>> & candidates, const std::string & name)
{
  for (std::size_t position = 0; position < candidates.size(); ++position)
  {
    for (const PolypCandidate & candidate : candidates[position])
    {
      if (NameOfCandidate(position, candidate.number) == name)
      {
        return &candidate;
      }
    }
  }
  return nullptr;
}
} // namespace shapeton
