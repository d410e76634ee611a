#ifndef shapetonSessionObjects_h
#define shapetonSessionObjects_h

#include "shapetonHeatObjects.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonStartRegion.h"

#include <optional>

namespace shapeton
{
/** \class SessionObjects
 * \brief The objects of the exact heat of a session, and the selected one. */
class SessionObjects
{
public:
  using HeatType = itk::Image<float, 3>;

  /** Finds the objects of a heat; nothing is selected. */
  void
  Find(const HeatType * heat, const Progress & progress);

  /** Forgets the objects, because the heat has changed. */
  void
  Clear();

  bool
  AreFound() const
  {
    return m_List.has_value();
  }

  /** How many are found. */
  std::size_t
  GetNumber() const
  {
    return m_List ? m_List->objects.size() : 0;
  }

  /** Number, parent, heat, voxels, volume, center and probability of each object; empty if none are found. */
  Json
  List() const;

  /** Selects the object with this number, counted from 1. Throws ParameterError. */
  void
  Select(int object);

  /** The object that a click on a point (LPS, mm) selects. Throws ParameterError and InputError. */
  int
  ObjectAt(const itk::Point<double, 3> & point) const;

  void
  Deselect();

  /** The objects and their labels; null if none are found. */
  const HeatObjectList *
  GetList() const
  {
    return m_List ? &*m_List : nullptr;
  }

  /** Changes with the objects. */
  std::uint64_t
  GetVersion() const
  {
    return m_Version;
  }

  /** Number of the selected object; 0 for none. */
  int
  GetSelected() const
  {
    return m_Selected;
  }

  /** The voxels of the selected object; null for none. */
  StartMask::Pointer
  GetMask() const
  {
    return m_Mask;
  }

  /** The heat inside the selected object and 0 outside; null if none is selected. */
  HeatType *
  GetSelectedHeat() const
  {
    return m_SelectedHeat;
  }

private:
  HeatType::ConstPointer        m_Heat;
  std::optional<HeatObjectList> m_List;
  int                           m_Selected{ 0 };
  StartMask::Pointer            m_Mask;
  HeatType::Pointer             m_SelectedHeat;
  std::uint64_t                 m_Version{ 1 };
};
} // namespace shapeton

#endif
