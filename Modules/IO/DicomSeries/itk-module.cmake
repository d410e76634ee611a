set(DOCUMENTATION "CT and MR series in DICOM: which series a folder holds, what is wrong with them, the volume of one, and
series of 16-bit integers written.")

itk_module(DicomSeries
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    VolumeFiles
    ITKCommon
  PRIVATE_DEPENDS
    Report
    ITKGDCM
  TEST_DEPENDS
    Report
    ITKGDCM
    ITKGoogleTest
    ITKIOGDCM
    ITKIOImageBase
    ITKIONIFTI
    ITKZLIB
  DESCRIPTION "${DOCUMENTATION}"
)
