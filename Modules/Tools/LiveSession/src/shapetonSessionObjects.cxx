#include "shapetonSessionObjects.h"

#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonJson.h"
#include "shapetonMappedImage.h"

#include <algorithm>

namespace shapeton
{
void
SessionObjects::Find(const HeatType * heat, const StartMask * barrier, const Progress & progress)
{
  this->Clear();
  StartMask::Pointer domain;
  if (barrier)
  {
    domain = NewImageOn<StartMask>(heat);
    const unsigned char * const first = barrier->GetBufferPointer();
    std::transform(first,
                   first + barrier->GetBufferedRegion().GetNumberOfPixels(),
                   domain->GetBufferPointer(),
                   [](unsigned char isBarrier) { return isBarrier != 0 ? 0 : 1; });
  }
  m_Tree.emplace(heat, HeatObjectOptions(), domain, progress);
  m_List = m_Tree->List(true);
  m_Heat = heat;
  ++m_Version;
}

void
SessionObjects::Clear()
{
  this->Deselect();
  m_List.reset();
  m_Tree.reset();
  m_Heat = nullptr;
  ++m_Version;
}

Json
SessionObjects::List() const
{
  return m_List ? JsonOf(*m_List) : Json::array();
}

int
SessionObjects::ObjectAt(const itk::Point<double, 3> & point) const
{
  RequireParameter(this->AreFound(), "no objects have been found yet; find them first");
  return ObjectOfClick(*m_List, ObjectsAt(*m_List, point).front());
}

void
SessionObjects::Select(const std::vector<int> & objects)
{
  RequireParameter(this->AreFound(), "no objects have been found yet; find them first");
  if (objects.empty())
  {
    this->Deselect();
    return;
  }
  const auto number = static_cast<int>(m_List->objects.size());
  RequireParameter(
    std::all_of(objects.begin(), objects.end(), [=](int object) { return object >= 1 && object <= number; }),
    "there are " + std::to_string(number) + " objects and offers; select one of them");
  m_Selection = objects;
  m_Mask = NewImageOn<StartMask>(m_Heat, true);
  m_SelectedHeat = NewImageOn<HeatType>(m_Heat, true);
  for (const int object : objects)
  {
    for (const VoxelRange & range : m_List->ranges[object - 1])
    {
      std::fill(m_Mask->GetBufferPointer() + range.begin, m_Mask->GetBufferPointer() + range.end, 1);
      std::copy(m_Heat->GetBufferPointer() + range.begin,
                m_Heat->GetBufferPointer() + range.end,
                m_SelectedHeat->GetBufferPointer() + range.begin);
    }
  }
}

void
SessionObjects::Deselect()
{
  m_Selection.clear();
  m_Mask = nullptr;
  m_SelectedHeat = nullptr;
}
} // namespace shapeton
