set(DOCUMENTATION "Graphs and rotation systems, their files, planarity and genus, and simulated sensor networks.")

itk_module(ShapetonGraphModel
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    ShapetonCommon
  PRIVATE_DEPENDS
    ShapetonReport
    ITKExpat
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
