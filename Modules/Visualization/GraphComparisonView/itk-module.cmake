set(DOCUMENTATION "Pictures and reports of graphs side by side: comparisons with one colour for corresponding circles, dynamic graphs with their
changes.")

itk_module(GraphComparisonView
  ENABLE_SHARED
  DEPENDS
    GraphComparison
    GraphView
    Report
  PRIVATE_DEPENDS
    CommandLine
  TEST_DEPENDS
    CommandLine
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
