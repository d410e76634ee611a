set(DOCUMENTATION "The contract of a command-line tool: options declared in a 3D Slicer XML, progress, exit status,
outputs that are written completely or not at all, and the provenance of a result.")

itk_module(CommandLine
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    Base
    ITKCommon
  PRIVATE_DEPENDS
    ITKExpat
  TEST_DEPENDS
    ITKExpat
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
