#include "shapetonColonExamination.h"

#include "shapetonSha256.h"

#include <filesystem>

namespace shapeton
{
ColonExamination::ColonExamination(const std::string & folder, const std::string & second, const std::string & reader)
{
  m_Positions.emplace_back(folder, reader);
  const std::string own = folder + '/' + secondPositionFolder;
  if (!second.empty())
  {
    m_Positions.emplace_back(second, reader);
  }
  else if (std::filesystem::exists(own + '/' + examination::flat.Path()))
  {
    m_Positions.emplace_back(own, reader);
  }
}

std::string
ColonExamination::Digest() const
{
  std::string digests;
  for (const ExaminationFolder & position : m_Positions)
  {
    for (const ExaminationFile & file : { examination::flat, examination::candidates })
    {
      digests += position.Has(file) ? Sha256OfFile(position.PathOf(file)) : "missing";
    }
  }
  return Sha256OfBytes(digests);
}

std::vector<std::vector<PolypCandidate>>
ColonExamination::ReadCandidates() const
{
  std::vector<std::vector<PolypCandidate>> candidates;
  for (const ExaminationFolder & position : m_Positions)
  {
    candidates.push_back(position.ReadCandidates());
  }
  return candidates;
}

std::string
NameOfCandidate(std::size_t position, int number)
{
  return (position == 0 ? "" : std::string(secondPositionFolder) + '/') + std::to_string(number);
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
