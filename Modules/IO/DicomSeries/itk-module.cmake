set(DOCUMENTATION "CT and MR series in DICOM: which series a folder holds, what is wrong with them, the volume of one, and
series of 16-bit integers written.")

itk_module(DicomSeries
  ENABLE_SHARED
  DEPENDS
    VolumeFiles
    ITKCommon
  PRIVATE_DEPENDS
    Base
    Report
  TEST_DEPENDS
    Report
    ITKGoogleTest
    ITKIOGDCM
    ITKIOImageBase
    ITKIONIFTI
    ITKZLIB
  DESCRIPTION "${DOCUMENTATION}"
)
