#include "shapetonSessionObjects.h"

#include "shapetonExceptions.h"
#include "shapetonHeatObjectTable.h"
#include "shapetonJson.h"
#include "shapetonParallelFor.h"

namespace shapeton
{
void
SessionObjects::Find(const HeatType * heat, const Progress & progress)
{
  this->Clear();
  m_List = FindHeatObjects({ heat }, {}, progress);
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
  Json objects = Json::array();
  if (!m_List)
  {
    return objects;
  }
  for (const HeatObject & object : m_List->objects)
  {
    objects.push_back({ { "number", objects.size() + 1 },
                        { "parent", object.parent },
                        { "kind", object.isWarm ? "warm" : "cold" },
                        { "heat", RoundedJson(object.heat) },
                        { "voxels", object.voxels },
                        { "volume", RoundedJson(object.volume) },
                        { "center", { object.center[0], object.center[1], object.center[2] } },
                        { "probability", RoundedJson(object.probability, 3) } });
  }
  return objects;
}

int
SessionObjects::ObjectAt(const itk::Point<double, 3> & point) const
{
  RequireParameter(this->AreFound(), "no objects have been found yet; find them first");
  return ObjectsAt(*m_List, point).front();
}

void
SessionObjects::Select(int object)
{
  RequireParameter(this->AreFound(), "no objects have been found yet; find them first");
  m_Mask = MaskOfObject(*m_List, object);
  m_Selected = object;
  m_SelectedHeat = HeatType::New();
  m_SelectedHeat->CopyInformation(m_Heat);
  m_SelectedHeat->SetRegions(m_Heat->GetBufferedRegion());
  m_SelectedHeat->Allocate();
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
