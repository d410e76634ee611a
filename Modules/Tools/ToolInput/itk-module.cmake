set(DOCUMENTATION "What tools read, by the parameters of their command line: volumes, masks, surfaces, curves, markups.")

itk_module(ToolInput
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Devices
    SurfaceMesh
    DicomSeries
    SlicerMarkups
  PRIVATE_DEPENDS
    Base
    CommandLine
  DESCRIPTION "${DOCUMENTATION}"
)
