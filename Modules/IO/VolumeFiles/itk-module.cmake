set(DOCUMENTATION "Volumes with their geometry, read from and written to NRRD, NIfTI and MetaImage.")

itk_module(VolumeFiles
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    ITKCommon
    ITKIOImageBase
  PRIVATE_DEPENDS
    ITKIOMeta
    ITKIONIFTI
    ITKIONRRD
    ITKZLIB
  TEST_DEPENDS
    ITKGoogleTest
    ITKIONIFTI
    ITKZLIB
  DESCRIPTION "${DOCUMENTATION}"
)
