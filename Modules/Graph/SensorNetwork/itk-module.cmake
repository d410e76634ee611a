set(DOCUMENTATION "A simulated network of moving wireless devices with variable power: a sequence of graphs.")

itk_module(SensorNetwork
  ENABLE_SHARED
  EXCLUDE_FROM_DEFAULT
  DEPENDS
    GraphModel
  PRIVATE_DEPENDS
    Base
  TEST_DEPENDS
    GraphGenus
    ITKGoogleTest
  DESCRIPTION "${DOCUMENTATION}"
)
