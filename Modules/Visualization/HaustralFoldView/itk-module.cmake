set(DOCUMENTATION "The flat colon with its haustral folds, their end points and the taeniae.")

itk_module(HaustralFoldView
  ENABLE_SHARED
  DEPENDS
    FlatColonView
    HaustralFolds
    ShapeRendering
  PRIVATE_DEPENDS
    Report
  TEST_DEPENDS
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
