#ifndef shapetonSessionObjects_h
#define shapetonSessionObjects_h

#include "shapetonHeatObjects.h"
#include "shapetonJsonForward.h"
#include "shapetonProgress.h"
#include "shapetonStartRegion.h"

#include <optional>
#include <vector>

namespace shapeton
{
/** \class SessionObjects
 * \brief The objects of the exact heat of a session, and the selected ones. */
class SessionObjects
{
public:
  using HeatType = itk::Image<float, 3>;

  /** Finds the objects of a heat, and offers for voxels in no object; nothing is selected. \param barrier no object
   * contains one of its voxels; null for none */
  void
  Find(const HeatType * heat, const StartMask * barrier, const Progress & progress);

  /** Forgets the objects, because the heat has changed. */
  void
  Clear();

  bool
  AreFound() const
  {
    return m_List.has_value();
  }

  /** How many are found, without offers. */
  std::size_t
  GetNumber() const
  {
    return m_List ? m_List->objects.size() - m_List->numberOfOffers : 0;
  }

  /** Number, parent, isOffer, heat, voxels, volume, center and probability of each object; empty if none are found. */
  Json
  List() const;

  /** Selects the objects with these numbers, counted from 1. Throws ParameterError. */
  void
  Select(const std::vector<int> & objects);

  /** The object that a click on a point (LPS, mm) selects. Throws ParameterError and InputError. */
  int
  ObjectAt(const itk::Point<double, 3> & point) const;

  void
  Deselect();

  /** The objects, offers and labels; null if none are found. */
  const HeatObjectList *
  GetList() const
  {
    return m_List ? &*m_List : nullptr;
  }

  /** The objects without offers. */
  HeatObjectList
  GetObjects() const
  {
    return m_Tree->List();
  }

  /** Changes with the objects. */
  std::uint64_t
  GetVersion() const
  {
    return m_Version;
  }

  /** Numbers of the selected objects. */
  const std::vector<int> &
  GetSelection() const
  {
    return m_Selection;
  }

  /** The voxels of the selected objects; null for none. */
  StartMask::Pointer
  GetMask() const
  {
    return m_Mask;
  }

  /** The heat inside the selected objects and 0 outside; null if none is selected. */
  HeatType *
  GetSelectedHeat() const
  {
    return m_SelectedHeat;
  }

private:
  HeatType::ConstPointer        m_Heat;
  std::optional<HeatObjectTree> m_Tree;
  std::optional<HeatObjectList> m_List;
  std::vector<int>              m_Selection;
  StartMask::Pointer            m_Mask;
  HeatType::Pointer             m_SelectedHeat;
  std::uint64_t                 m_Version{ 1 };
};
} // namespace shapeton

#endif
