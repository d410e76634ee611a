#include "shapetonSessionObjects.h"

#include "shapetonExceptions.h"
#include "shapetonExplorerInfo.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonJson.h"
#include "shapetonMappedImage.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
void
SessionObjects::Find(const HeatType * heat, const Progress & progress)
{
  this->Clear();
  m_List = FindHeatObjects(heat, {}, progress);
  m_Heat = heat;
  ++m_Version;
}

void
SessionObjects::Clear()
{
  this->Deselect();
  m_List.reset();
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
SessionObjects::Select(int object)
{
  RequireParameter(this->AreFound(), "no objects have been found yet; find them first");
  m_Mask = MaskOfObject(*m_List, object);
  m_Selected = object;
  m_SelectedHeat = NewImageOn<HeatType>(m_Heat);
  const float * const         from = m_Heat->GetBufferPointer();
  const unsigned char * const isIn = m_Mask->GetBufferPointer();
  float * const               to = m_SelectedHeat->GetBufferPointer();
  ParallelForBlocks(m_Heat->GetBufferedRegion().GetNumberOfPixels(),
                    [=](std::size_t voxel) { to[voxel] = isIn[voxel] != 0 ? from[voxel] : 0.0F; });
}

void
SessionObjects::Deselect()
{
  m_Selected = 0;
  m_Mask = nullptr;
  m_SelectedHeat = nullptr;
}
} // namespace shapeton
