set(DOCUMENTATION "Volumes from NRRD, MetaImage and NIfTI files and from DICOM series, and their writers.")

itk_module(ShapetonVolumeFiles
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
    ITKCommon
    ITKIOImageBase
  PRIVATE_DEPENDS
    ITKIOMeta
    ITKIONIFTI
    ITKIONRRD
    ITKZLIB
    ShapetonReport
    ITKGDCM
  TEST_DEPENDS
    ITKIONIFTI
    ITKZLIB
    ShapetonReport
    ITKGDCM
    ITKGoogleTest
    ITKIOGDCM
  DESCRIPTION "${DOCUMENTATION}"
)
