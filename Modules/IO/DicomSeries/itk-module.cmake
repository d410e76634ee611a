set(DOCUMENTATION "Reads DICOM series with strict geometry, and the research formats NRRD, NIfTI and MetaImage; writes volumes
and CT series. Irregular series are refused by name of the defect unless a repair is asked for.")

itk_module(DicomSeries
  ENABLE_SHARED
  DEPENDS
    CommandLine
    ITKCommon
  PRIVATE_DEPENDS
    Report
    ITKImageGrid
    ITKIOImageBase
    ITKIOMeta
    ITKIONIFTI
    ITKIONRRD
    ITKZLIB
  TEST_DEPENDS
    ITKGoogleTest
    ITKIOGDCM
    ITKIOImageBase
    ITKIOMeta
    ITKIONIFTI
    ITKIONRRD
    ITKZLIB
    Report
  DESCRIPTION "${DOCUMENTATION}"
)
