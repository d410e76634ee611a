#ifndef itkVTKImageBridge_h
#define itkVTKImageBridge_h

#include "VTKGlueExport.h"

#include "itkImage.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace itk
{
/** A copy of the buffered region of an image as VTK image data with one scalar component.
 *
 * Origin (mm, LPS), spacing (mm) and direction cosines are kept, and the extent starts at the index of the region, so
 * that a voxel has the same index and the same physical position in both. The values are copied: neither side keeps the
 * other's memory alive. Throws std::invalid_argument for a null image.
 *
 * Instantiated for float, short, unsigned char, unsigned short and unsigned int pixels.
 * \ingroup VTKGlue */
template <typename TPixel>
vtkSmartPointer<vtkImageData>
ImageToVTK(const Image<TPixel, 3> * image);

/** The inverse of ImageToVTK: a copy of VTK image data as an ITK image.
 *
 * Throws std::invalid_argument when there are no scalars, when they have more than one component, or when their type is
 * not `TPixel`: values are never converted.
 * \ingroup VTKGlue */
template <typename TPixel>
typename Image<TPixel, 3>::Pointer
ImageFromVTK(vtkImageData * image);

#define itkVTKImageBridgeExternTemplate(TPixel)                                                                        \
  extern template VTKGlue_EXPORT vtkSmartPointer<vtkImageData> ImageToVTK(const Image<TPixel, 3> *);                   \
  extern template VTKGlue_EXPORT Image<TPixel, 3>::Pointer ImageFromVTK<TPixel>(vtkImageData *)

itkVTKImageBridgeExternTemplate(float);
itkVTKImageBridgeExternTemplate(short);
itkVTKImageBridgeExternTemplate(unsigned char);
itkVTKImageBridgeExternTemplate(unsigned short);
itkVTKImageBridgeExternTemplate(unsigned int);

#undef itkVTKImageBridgeExternTemplate
} // namespace itk

#endif
