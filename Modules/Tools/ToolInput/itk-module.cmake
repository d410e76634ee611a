set(DOCUMENTATION "Inputs of tools from command line parameters: volumes, masks, surfaces, curves, markups.")

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
