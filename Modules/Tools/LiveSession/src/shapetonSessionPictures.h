#ifndef shapetonSessionPictures_h
#define shapetonSessionPictures_h

#include "shapetonHeatHistogram.h"
#include "shapetonLiveSession.h"
#include "shapetonSessionFrames.h"
#include "shapetonSessionObjects.h"
#include "shapetonShownVolume.h"
#include "shapetonSliceMontage.h"
#include "shapetonVolumeRendering.h"

#include <chrono>
#include <memory>
#include <string>

namespace shapeton
{
/** The first and the last voxel of a part of a volume. */
using DrawnBox = std::array<std::array<double, 3>, 2>;

/** The values that a session shows; refers to them. Of blocks, heat and visits, one is set. */
struct SessionScene
{
  const HeatObjectList::LabelImage *   labels{ nullptr }; ///< of the objects, if they have been found
  const BlockValues *                  blocks{ nullptr }; ///< a coarse picture
  itk::Image<float, 3> *               heat{ nullptr };
  const itk::Image<std::uint32_t, 3> * visits{ nullptr };
  std::uint32_t                        greatestVisits{ 1 };
  std::uint64_t                        step{ 0 };
  std::uint64_t                        version{ 0 }; ///< changes with the values

  ShownVolume
  Values(const std::array<std::size_t, 3> & size) const;
};

/** \class SessionPictures
 * \brief The frames with the part of what a session shows that a viewer lacks, and renderings. */
class SessionPictures
{
public:
  using ImageType = itk::Image<float, 3>;

  /** The image must outlive the object. */
  explicit SessionPictures(const ImageType * gray);

  /** Description of volume and views for the page. */
  Json
  Info() const;

  /** Slices, changed bricks and histogram. */
  void
  AddParts(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame);

  /** All values. */
  void
  AddWhole(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame) const;

  /** The labels of the objects, if the viewer lacks them. */
  void
  AddObjects(const SessionObjects & objects, SessionViewer & viewer, SessionFrame & frame) const;

  /** A rendering as a frame with a JPEG file. Throws ParameterError. */
  std::string
  Draw(const SessionScene & scene, const Json & request, Device device);

  /** Makes the next frame contain a new histogram, because other values are shown. */
  void
  OutdateHistogram();
  /** The same for values that change gradually, if the last histogram is a second old. */
  void
  OutdateOldHistogram();

private:
  void
  AddSlices(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame) const;
  void
  AddBricks(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame);
  void
  AddHistogram(const SessionScene & scene, SessionViewer & viewer, SessionFrame & frame);
  std::vector<std::uint8_t>
  GraySlice(unsigned int axis, std::size_t at) const;
  void
  RenewHistogram(const SessionScene & scene);
  ImageType::Pointer
  ImageOf(const SessionScene & scene) const;

  const ImageType * const          m_Gray;
  const std::array<std::size_t, 3> m_Size;
  const std::size_t                m_Stride; ///< of the reduced volume
  const IntensityWindow            m_Window;

  HeatBins      m_Reduced;
  std::uint64_t m_ReducedVersion{ 0 };

  bool                                  m_IsHistogramOld{ true };
  std::chrono::steady_clock::time_point m_HistogramTime{};
  std::uint64_t                         m_HistogramVersion{ 0 };
  HeatHistogram                         m_Histogram;
  HeatHistogram                         m_Axis;
  Json                                  m_Lines = Json::array();

  std::unique_ptr<VolumeRenderer> m_Renderer;
  std::uint64_t                   m_RendererVersion{ 0 };
  std::string                     m_RendererLines;
  DrawnBox                        m_RendererBox{};
};
} // namespace shapeton

#endif
